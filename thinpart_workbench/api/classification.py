# SPDX-License-Identifier: LGPL-2.1-or-later
"""Classify files, FreeCAD shapes, meshes, objects and documents, and triangles."""

import os
import time
from urllib.parse import urlsplit

from ..core.analysis_limits import LEAST_MEGABYTES, Limits
from ..core.analysis_settings import DEFAULT_PROFILE, AnalysisSettings
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..storage.common_folder import common_folder
from ..storage.info.info_file import info_path_getter
from .classified_parts import ClassifiedPart, ClassifiedParts, PartFailure
from .file_run import FileRun


def classify(source, profile=DEFAULT_PROFILE, settings=None, *, write_info=False, seconds=Limits.seconds,
             megabytes=Limits.megabytes, report=None):
    """Measure and judge the parts of one file, of a FreeCAD object, or of triangles.

    Parameters
    ----------
    source : str, Path, Part.Shape, Mesh.Mesh, FreeCAD.DocumentObject, FreeCAD.Document, or (vertices, triangles)
        A file is read in a worker process, because a damaged file may crash or block its reader. Everything else is
        measured in this process.
    profile : str, Path, dict or Profile, optional
        Name of a shipped profile, a JSON file, or the content of a profile.
    settings : AnalysisSettings, optional
    write_info : bool, str or Path, optional
        Whether to store the result in an info file, beside the file or in the given folder, and to reuse the stored
        result of an unchanged file. By default nothing is written.
    seconds : float, optional
        Time limit for a file.
    megabytes : int, optional
        Memory limit for a file.
    report : callable, optional
        Called with the fraction done while measuring in this process; may raise `Cancelled` to stop.

    Returns
    -------
    ClassifiedParts
        Each distinct solid once, with the number of its instances; other parts that failed are in ``failures``.

    Raises
    ------
    ThinPartError
        If nothing could be classified; ``kind`` is a key of `thinpart_workbench.core.errors.KINDS`, and the message
        is one sentence.

    Examples
    --------
    >>> classify((vertices, triangles))[0].category
    'thin'
    """
    if isinstance(source, (str, os.PathLike)):
        return _classify_file(source, profile, settings, write_info, seconds, megabytes)
    if write_info:
        raise ThinPartError("Only a file can have an info file: leave out write_info for shapes, objects and "
                            "triangles.", "usage")
    profile, settings = given_profile(profile), settings or AnalysisSettings()
    if isinstance(source, (tuple, list)):
        return _classify_parts([_meshed_part(source)], [], profile, settings, report)
    from ..freecad_adapter.reading.held_parts import held_content

    content = held_content(source)
    return _classify_parts(content.parts, [broken.failure() for broken in content.broken], profile, settings, report)


def classify_files(paths, profile=DEFAULT_PROFILE, settings=None, *, jobs=None, seconds=Limits.seconds,
                   megabytes=Limits.megabytes, write_info=False, force=False, include=(), exclude=(), control=None,
                   report=None, cluster=None):
    """Measure and judge the parts of many files, each file in a worker process with limits.

    Parameters
    ----------
    paths : str, Path, or list of them
        Files, and folders that are searched recursively.
    profile, settings, seconds, megabytes, write_info
        See `classify`. A folder for info files mirrors the tree below the common folder of all paths.
    jobs : int, optional
        Files to process at once; by default one per processor.
    force : bool, optional
        Whether to measure files again that have not changed since their info file was written.
    include, exclude : sequence of str, optional
        Globs for files in folders: only those that match `include`, without those that match `exclude`.
    control : RunControl, optional
        Pauses, resumes and stops the run from another thread.
    report : callable, optional
        Called with the `RunProgress` at the start and after each file.
    cluster : str, optional
        Address of a Dask scheduler whose workers process the files.

    Returns
    -------
    iterator of ClassifiedParts
        One per file, in the order in which they finish. A file that failed has no parts and one failure. Closing
        the iterator stops the run.

    Raises
    ------
    ThinPartError
        At once if the profile or a limit is invalid or there are no files; during iteration if no worker can be
        started.
    Cancelled
        If `control` was asked to stop.

    Examples
    --------
    >>> {parts[0].label: parts[0].category for parts in classify_files([block, plate], write_info=True, jobs=1)}
    {'block': 'normal', 'plate': 'thin'}
    """
    paths = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    limits = _limits(seconds, megabytes, jobs)
    content, settings = given_profile(profile).content, settings or AnalysisSettings()
    if cluster is not None:
        cluster = cluster_address(cluster)
    run = FileRun(paths, _texts(include), _texts(exclude), control=control)

    def notify():
        if report is not None:
            report(run.progress)

    return _classified(run, run.outcomes(
        content, settings, limits, info_for=_info_for(write_info, paths), force=force, thumbnails=bool(write_info),
        started=notify, cluster=cluster), notify)


def _classified(run, outcomes, notify):
    try:
        yield from map(ClassifiedParts.of_outcome, run.failures)
        for outcome in outcomes:
            notify()
            yield ClassifiedParts.of_outcome(outcome)
    finally:
        outcomes.close()


def _classify_file(path, profile, settings, write_info, seconds, megabytes):
    if os.path.isdir(path):
        raise ThinPartError(f"{path} is a folder: name a file in it.", "usage")
    parts, = classify_files([path], profile, settings, jobs=1, seconds=seconds, megabytes=megabytes,
                            write_info=write_info)
    if not parts.parts and len(parts.failures) == 1:
        raise parts.failures[0].error()
    return parts


def _classify_parts(parts, broken, profile, settings, report):
    from ..workflow.analysis.analyse_part import analyse_parts

    started, measured = time.perf_counter(), {}

    def show(part, measurement, record):
        measured[record["name"]] = measurement

    def part_report(stage, fraction):
        if stage == "measure":
            report(fraction)

    records, failures = analyse_parts(parts, settings, profile, 0.0, report and part_report, show)
    failures = [PartFailure.of(failure) for failure in failures + broken]
    if not records and len(failures) == 1:
        raise failures[0].error()
    return ClassifiedParts(
        tuple(ClassifiedPart(record, None, measured[record["name"]]) for record in records), tuple(failures),
        seconds=round(time.perf_counter() - started, 4))


def _meshed_part(source):
    from ..freecad_adapter.shapes.part import MeshedPart
    from .mesh_arrays import checked_arrays

    if len(source) != 2 or any(isinstance(item, (str, os.PathLike)) for item in source):
        raise ThinPartError("A tuple or list has to be vertices and triangles; several files are for "
                            "classify_files.", "usage")
    vertices, triangles, _ = checked_arrays(*source)
    return MeshedPart("Mesh", "mesh", points=vertices, triangles=triangles)


def _limits(seconds, megabytes, jobs):
    jobs = os.cpu_count() or 1 if jobs is None else jobs
    if not (_is_number(jobs, int) and jobs >= 1):
        raise ThinPartError(f"{jobs!r} jobs are not possible: give a whole number from 1 on.", "usage")
    if not (_is_number(seconds, (int, float)) and 0.0 < seconds < float("inf")):
        raise ThinPartError(f"{seconds!r} seconds is not a limit: give a number above 0.", "usage")
    if not (_is_number(megabytes, int) and megabytes >= LEAST_MEGABYTES):
        raise ThinPartError(
            f"{megabytes!r} MB is not a limit: give a whole number from {LEAST_MEGABYTES} on.", "usage")
    return Limits(float(seconds), megabytes, jobs)


def _is_number(value, kinds):
    return isinstance(value, kinds) and not isinstance(value, bool)


def _info_for(write_info, paths):
    if not write_info:
        return None
    if write_info is True:
        return info_path_getter()
    return info_path_getter(write_info, common_folder(paths))


def _texts(globs):
    return (globs,) if isinstance(globs, str) else tuple(globs)


def cluster_address(text):
    """The complete address of a scheduler; also accepts ``HOST:PORT``. Raises a ThinPartError, kind ``usage``.

    Examples
    --------
    >>> cluster_address("host:8786")
    'tcp://host:8786'
    """
    address = text if "://" in text else f"tcp://{text}"
    try:
        parts = urlsplit(address)
        usable = parts.scheme in ("tcp", "tls") and parts.hostname and parts.port
    except ValueError:
        usable = False
    if not usable or parts.path or parts.query or parts.username:
        raise ThinPartError(
            f"'{text}' is not the address of a Dask scheduler: write it as tcp://HOST:PORT.", "usage")
    return address
