"""One file: read it, analyse its parts, keep the result beside it. Runs in a worker process."""

import time
from dataclasses import dataclass, field
from pathlib import Path

from ..core.analysis_settings import AnalysisSettings
from ..core.criteria import load_profile, profile_from
from ..core.errors import ThinPartError
from ..freecad_adapter.linked_files import linked_files
from ..storage.info_file import (
    info_content, is_current, new_source, source_is_unchanged, stored_info, write_info,
)
from .report_pages import PageWriter, ReportPages


@dataclass(frozen=True)
class FileTask:
    """What a worker is asked to do with one file; only plain values, so that it can travel.

    Attributes
    ----------
    file : str
    info_file : str or None
        Where the result is kept; None keeps nothing.
    settings : AnalysisSettings
    profile : dict
        Content of the profile.
    force : bool
        Measure again even when the info file is current.
    thumbnails : bool
        Keep a picture of every part that is measured in the user's cache.
    """

    file: str
    info_file: str = None
    settings: AnalysisSettings = field(default_factory=AnalysisSettings)
    profile: dict = field(default_factory=lambda: load_profile("paper").content)
    force: bool = False
    thumbnails: bool = False
    pages: ReportPages = None


def analyse_file(task, report=None):
    """Analyse every part of a file, or take the results from a current info file.

    Parameters
    ----------
    task : FileTask
    report : callable, optional
        See `analyse_part`.

    Returns
    -------
    dict
        ``file``, ``parts`` (part records), ``failures`` (``{"part", "label", "kind",
        "message"}``), ``reused`` (bool), ``seconds``; with pages also ``faces``, lines for the table of faces
        by part. Without any part nothing is kept.

    Raises
    ------
    ThinPartError
        When nothing of the file could be analysed, for one reason.
    """
    started = time.perf_counter()
    stored = stored_info(task.info_file) if task.info_file is not None else None
    if stored is not None and not task.force and is_current(
        stored, task.file, task.settings.content(), task.profile, task.info_file
    ):
        return _outcome(task, stored["parts"], stored.get("failures", []), True, started)
    # The adapter loads FreeCAD; what is unchanged never needs it.
    from ..freecad_adapter.part_files import read_parts

    source = new_source(task.file, linked_files(task.file), task.info_file)
    found = read_parts(task.file)
    read_seconds = time.perf_counter() - started
    writer = task.pages and PageWriter(task.pages, source, task.settings.content(), task.profile)
    records, failures = _analyse_parts(found.parts, task, source["sha256"], read_seconds, writer, report)
    failures += [broken.failure() for broken in found.broken]
    if not records and len(failures) == 1:
        raise ThinPartError(failures[0]["message"], failures[0]["kind"])
    if not source_is_unchanged(source, task.file):
        raise ThinPartError(
            f"{Path(task.file).name} changed while it was read: classify it again.", "unreadable"
        )
    content = info_content(source, task.settings.content(), task.profile, records, failures)
    if task.info_file is not None and records:
        try:
            write_info(task.info_file, content)
        except ThinPartError as error:
            failures = [*failures, _failure(None, None, error.kind, str(error))]
    outcome = _outcome(task, content["parts"], failures, False, started)
    return outcome if writer is None else {**outcome, "faces": writer.faces}


def _analyse_parts(parts, task, sha256, read_seconds, writer, report):
    from .analyse_part import analyse_part
    from .part_thumbnail import keep_thumbnail

    profile = profile_from(task.profile)
    records, failures = [], []
    for number, part in enumerate(parts):
        def part_report(stage, fraction, number=number):
            report(stage, (number + fraction) / len(parts))

        def show(measurement, record, part=part):
            if task.thumbnails:
                keep_thumbnail(measurement.field.mesh, record, sha256)
            if writer is not None:
                writer.write(part, measurement, record)

        try:
            record = analyse_part(part, task.settings, profile, report and part_report, show)
        except ThinPartError as error:
            if error.kind == "cancelled":
                raise
            failures.append(
                _failure(part.name, part.label, error.kind, f"{part.label}: {error}"))
            continue
        record["seconds"] = {"read": read_seconds / len(parts), **record["seconds"]}
        record["seconds"] = {key: round(value, 4) for key, value in record["seconds"].items()}
        records.append(record)
    return records, failures


def _failure(part, label, kind, message):
    return {"part": part, "label": label, "kind": kind, "message": message}


def _outcome(task, records, failures, reused, started):
    return {
        "file": task.file, "parts": records, "failures": failures, "reused": reused,
        "seconds": round(time.perf_counter() - started, 4),
    }
