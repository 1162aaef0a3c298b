# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read one file and analyse its parts. Runs in a worker process, which writes nothing: see `result_files`."""

import time
from dataclasses import dataclass, field
from typing import Optional

from ...core.analysis_settings import AnalysisSettings
from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile, profile_from
from ...storage.info.info_file import is_current, stored_info
from ...storage.info.measured_copies import copied_records
from ...storage.thumbnails import has_thumbnail
from ..report.report_pages import PageMaker, ReportPages
from .drawn_part import DrawnPart
from .measured_source import source_of


@dataclass(frozen=True)
class FileTask:
    """The task of a worker: one file. Contains only plain values, so that it can be pickled.

    Attributes
    ----------
    file : str
    info_file : str or None
        Path of the info file for the result; None to write none.
    settings : AnalysisSettings
    profile : dict
        Content of the profile.
    force : bool
        Measure even if the info file is current.
    thumbnails : bool
        Write thumbnails of all measured parts to the user's cache.
    """

    file: str
    info_file: Optional[str] = None
    settings: AnalysisSettings = field(default_factory=AnalysisSettings)
    profile: dict = field(default_factory=lambda: load_profile().content)
    force: bool = False
    thumbnails: bool = False
    pages: Optional[ReportPages] = None


def analyse_file(task, before_reading=None):
    """Analyse every part of a file, or take the results from a current info file.

    Returns a dict: ``file``, ``parts`` (part records), ``failures`` (``{"part", "label", "kind", "message"}``), ``reused``
    (bool), ``seconds``, ``sha256`` of the file; with pages also ``faces``, lines for the table of faces by part. If
    something was measured, ``unwritten``: the data for `result_files.write_results`. Raises ThinPartError if nothing could
    be analysed, for a single reason.

    Parameters
    ----------
    task : FileTask
    before_reading : callable, optional
        Called where the info file is not current, so that the file has to be read.
    """
    started = time.perf_counter()
    stored = stored_info(task.info_file) if task.info_file is not None else None
    if stored is not None and not task.force and is_current(
        stored, task.file, task.settings.content(), task.profile, task.info_file
    ):
        return _outcome(task, stored["parts"], stored.get("failures", []), True, started, stored["source"])
    if before_reading is not None:
        before_reading()
    # Imported here since the adapter loads FreeCAD, which unchanged files do not need.
    from ...freecad_adapter.reading.part_files import read_parts

    source = source_of(task.file, task.info_file)
    found = read_parts(task.file)
    read_seconds = time.perf_counter() - started
    pages = task.pages and PageMaker(task.pages, source, task.settings.content(), task.profile)
    copied = None if task.force or pages else _copied(found, source, task, read_seconds)
    records, failures, drawn = copied or _analyse_parts(found.parts, task, read_seconds, pages)
    failures += [broken.failure() for broken in found.broken]
    if not records and len(failures) == 1:
        raise ThinPartError(failures[0]["message"], failures[0]["kind"])
    outcome = _outcome(task, records, failures, False, started, source)
    outcome["unwritten"] = {"source": source, "drawn": drawn}
    if pages is not None:
        outcome["faces"] = pages.faces
    return outcome


def _copied(found, source, task, read_seconds):
    """The records of a document of the same bytes that was measured before, as `_analyse_parts`; None without one."""
    known = None if found.broken else copied_records(source, task.settings.content(), task.profile)
    if known is None or {part.name for part in found.parts} != set(known):
        return None
    if task.thumbnails and not all(has_thumbnail(source["sha256"], name) for name in known):
        return None  # its surface is needed to draw them
    seconds = {"read": round(read_seconds / len(known), 4), "tessellate": 0.0, "measure": 0.0}
    # A part without a name of its own has that of its file.
    return [{**known[part.name], "label": part.label, "seconds": seconds} for part in found.parts], [], {}


def _analyse_parts(parts, task, read_seconds, pages):
    from .analyse_part import analyse_parts

    drawn = {}

    def on_part(part, measurement, record):
        pictures = DrawnPart()
        if task.thumbnails:
            pictures.draw_thumbnail(measurement.field.mesh, record)
        if pages is not None:
            pictures.page, pictures.picture = pages.make(part, measurement, record)
        drawn[record["name"]] = pictures.content()

    records, failures = analyse_parts(parts, task.settings, profile_from(task.profile), read_seconds, on_result=on_part)
    if pages is not None and task.info_file is None:
        # Tables check them too. An info file is written with all that was kept in it before.
        records = [pages.limited(record) for record in records]
    return records, failures, drawn


def _outcome(task, records, failures, reused, started, source):
    return {
        "file": task.file, "parts": records, "failures": failures, "reused": reused,
        "seconds": round(time.perf_counter() - started, 4), "sha256": source["sha256"],
    }
