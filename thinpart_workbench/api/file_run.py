# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find, analyse and map documents in worker processes or on a cluster, for both the command line and the Python API."""

import os
from contextlib import closing
from typing import Optional

from ..core.analysis_limits import Limits
from ..core.analysis_settings import DEFAULT_PROFILE, RAY, AnalysisSettings
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..core.kinds.file_marks import MAPS
from ..core.message import message
from ..core.run_control import RunControl
from ..storage.output_file import check_output, write_output, writing
from ..workflow.analysis.analyse_file import FileTask
from ..workflow.analysis.analysis_outcome import failure
from ..workflow.analysis.find_documents import NameFilter, find_documents
from ..workflow.analysis.run_plan import plan_run
from ..workflow.analysis.run_progress import RunProgress
from ..workflow.workers.worker_pool import analyse_files


class FileRun:
    """A run over the documents found in some paths.

    Parameters
    ----------
    paths : list of str or Path
        Files, and folders that are searched.
    include, exclude : iterable of str, optional
        Globs for files in folders: only those that match `include`, without those that match `exclude`; see `NameFilter`.
    only : list of str, optional
        Files and folders to use instead of `paths`.
    control : RunControl, optional
        Pauses and stops the run.
    report : callable, optional
        Called with the number of documents found so far.

    Attributes
    ----------
    documents : list of Document
    failures : list of dict
        Outcomes for paths that could not be searched.
    control : RunControl
    progress : RunProgress or None
        None until `outcomes` is iterated.

    Raises
    ------
    ThinPartError
        kind ``empty`` if nothing was found.
    Cancelled
        If `control` was asked to stop.
    """

    def __init__(self, paths, include=(), exclude=(), only=None, control=None, report=None):
        self.control = control or RunControl()
        self.progress: Optional[RunProgress] = None

        def searched(count):
            self.control.check()
            if report is not None:
                report(count)

        self.control.set_state("searching")
        found = find_documents(paths if only is None else only, NameFilter(tuple(include), tuple(exclude)), searched)
        self.control.check()
        if not found.documents and not found.failures:
            raise ThinPartError(
                message("There are no parts in {paths}: name a CAD file or a folder that holds some.",
                        paths=", ".join(map(str, paths))), "empty",
            )
        self.documents = found.documents
        self.failures = [failure(path, error.kind, str(error)) for path, error in found.failures]

    def outcomes(self, profile, settings, limits, *, info_for=None, force=False, thumbnails=False, pages_for=None,
                 started=None, cluster=None):
        """Analyse the documents.

        Parameters
        ----------
        profile : dict
            Content of the profile to judge by.
        settings : AnalysisSettings
        limits : Limits
        info_for : callable, optional
            Maps a path to the path of its info file; by default no info files are read or written.
        force : bool, optional
            Whether to measure files again whose info file is current.
        thumbnails : bool, optional
            Whether to store pictures of all measured parts in the user's cache.
        pages_for : callable, optional
            Maps a path to the pages of a report to be made about its parts; see `ReportFolder.pages_for`.
        started : callable, optional
            Called once, when `progress` is available.
        cluster : str, optional
            Address of a Dask scheduler, from `cluster_address`, whose workers analyse the files instead of processes on
            this machine.

        Yields
        ------
        dict
            As `worker_pool.analyse_files`, in the order in which files finish; `progress` already counts it. A caller
            that stops iterating has to close the generator.

        Raises
        ------
        ThinPartError
            If no worker can be started or the cluster cannot be used.
        Cancelled
            If the control was asked to stop.
        """
        def new_task(file, info_file):
            return FileTask(file, info_file, settings, profile, force, thumbnails, pages_for and pages_for(file))

        planned = plan_run(self.documents, new_task, info_for or (lambda file: None), limits.jobs)
        sizes = {entry.task.file: (entry.bytes, entry.unchanged) for entry in planned}
        progress = self.progress = RunProgress(sizes, limits.jobs, self.control)
        info_errors = {entry.task.file: entry.problem for entry in planned if entry.problem is not None}
        self.control.set_state("paused" if self.control.paused else "running")
        if started is not None:
            started()
        with closing(self._analyse([entry.task for entry in planned], limits, cluster, progress)) as outcomes:
            for outcome in outcomes:
                if outcome["file"] in info_errors and "error" not in outcome:
                    error = info_errors[outcome["file"]]
                    outcome["failures"] = [*outcome["failures"], {
                        "part": None, "label": None, "kind": error.kind, "message": str(error)}]
                progress.add(outcome)
                yield outcome

    def _analyse(self, tasks, limits, cluster, progress):
        if cluster is None:
            return analyse_files(tasks, limits, self.control)
        from ..workflow.cluster.cluster_run import analyse_files_on_cluster

        def on_threads_changed(threads):
            progress.jobs = threads

        return analyse_files_on_cluster(cluster, tasks, limits, self.control, on_threads_changed)


def write_map(path, files, *, part=None, look=None, measure=RAY, profile=DEFAULT_PROFILE, settings=None, limits=None,
              control=None, overwrite=False, inputs=()):
    """Measure a part and write its thickness map to files.

    Parameters
    ----------
    path : str or Path
        The CAD file.
    files : list of str or Path
        What to write; their endings say as what: a picture (.png), or triangles with the thickness at every corner for
        ParaView (.vtp) and other programs (.ply). All values are in mm.
    part : str, optional
        Name or label of the part, where the document has several.
    look : MapLook, optional
        Colours, range and view, as `core.rendering.map_picture` has them; by default those of the window.
    measure : str, optional
        One of `SHOWN_MEASURES`.
    profile : str, Path, dict or Profile, optional
        Its thin limit says up to where the mesh has to be fine.
    settings : AnalysisSettings, optional
    limits : Limits, optional
        Of time and memory.
    control : RunControl, optional
        Stops the run.
    overwrite, inputs
        See `storage.output_file.check_output`; the CAD file is an input.

    Returns
    -------
    dict
        ``file`` and ``label``; ``thinnest``, mm, the thinnest wall, None where there is none, and ``thinnest_at``: "taper",
        "edge" or empty; ``low`` and ``high`` of the colours, mm.

    Raises
    ------
    ThinPartError
        kind ``usage`` where the part or the format is not clear; what else prevents it. Files that were there stay then.
    Cancelled
        If `control` was asked to stop.

    Examples
    --------
    >>> write_map(plate, [f"{samples}/plate.ply"])["thinnest"]
    8.0
    """
    # Imported late: it imports numpy.
    from ..core.rendering.map_picture import MapLook
    from ..workflow.maps.map_run import MapTask, map_of_part

    path, endings = os.fspath(path), {os.fspath(file): os.path.splitext(file)[1].lower() for file in files}
    for file, ending in endings.items():
        if ending not in MAPS:
            raise ThinPartError(message("{file} is no name for a map: give it one of the endings {endings}.", file=file,
                                        endings=", ".join(MAPS)), "usage")
    if not os.path.isfile(path):
        raise ThinPartError(message("{file} is no file: name a CAD file with one part.", file=path), "missing")
    inputs = [path, *inputs]
    for file, ending in endings.items():
        with writing(file):
            check_output(file, MAPS[ending], overwrite, inputs)
    found = map_of_part(MapTask(path, part, given_profile(profile).content, tuple(sorted(set(endings.values()))),
                                look or MapLook(), measure, settings or AnalysisSettings()), limits or Limits(), control)
    if "error" in found:
        raise ThinPartError(found["error"]["message"], found["error"]["kind"])
    contents = found.pop("contents")
    for file, ending in endings.items():
        with writing(file):
            write_output(file, contents[ending], MAPS[ending], overwrite, inputs)
    return found
