# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the results of a measured document; runs in the parent process of the worker.

The worker has read an untrusted file and may write nothing. The task alone determines the paths.
"""

import os
from contextlib import suppress

from ...core.errors import ThinPartError
from ...storage.info.info_file import info_content, write_info
from ...storage.info.measured_copies import keep_measured
from ...storage.thumbnails import write_thumbnail
from .analysis_outcome import failure
from .drawn_part import DrawnPart
from .measured_source import check_source


def write_results(task, outcome):
    """Write info file, pictures and pages of a document.

    Returns a dict: the outcome without ``unwritten``, with a failure for every file that could not be written; its parts
    have their annotations. If the document has changed meanwhile or is gone, a failure.

    Parameters
    ----------
    task : FileTask
    outcome : dict
        From `analyse_file`.
    """
    unwritten = outcome.get("unwritten")
    if unwritten is None:
        return outcome
    # If the share was unmounted, the info file would be written into the empty mount point.
    try:
        check_source(unwritten["source"], task.file)
    except ThinPartError as error:
        return {**failure(task.file, error.kind, str(error)), "confinement": outcome.get("confinement")}
    outcome = {key: value for key, value in outcome.items() if key != "unwritten"}
    records, failures = outcome["parts"], list(outcome["failures"])
    for record in records:
        drawn = _drawn(unwritten["drawn"].get(record["name"]))
        if drawn.thumbnail is not None:
            # A failed picture must not lose the measurement; it can be drawn again.
            with suppress(OSError, ValueError):
                write_thumbnail(unwritten["source"]["sha256"], record["name"], drawn.thumbnail)
        if drawn.page is not None:
            failures += _failures(task.pages.write, drawn, record)
    if task.info_file is not None and records:
        content = info_content(unwritten["source"], task.settings.content(), task.profile, records, outcome["failures"])
        is_beside = os.path.dirname(task.info_file) == os.path.dirname(task.file)
        lost = _failures(write_info, task.info_file, content, task.file if is_beside else None)
        failures += lost
        if not lost and not failures:
            keep_measured(task.file, unwritten["source"], task.info_file)
    return {**outcome, "failures": failures}


def _drawn(content):
    try:
        return DrawnPart.from_content(content)
    except ValueError:  # a faulty worker may return anything
        return DrawnPart()


def _failures(write, *arguments):
    try:
        write(*arguments)
    except ThinPartError as error:
        return [{"part": None, "label": None, "kind": error.kind, "message": str(error)}]
    return []
