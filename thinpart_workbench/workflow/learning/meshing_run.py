"""Mesh the parts of a library in worker processes, several at the same time."""

import os
import time
from collections import deque
from collections.abc import Mapping
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from ...core.descriptors.descriptor_table import REPORTED_SHARES, quantity_named
from ...core.errors import ThinPartError
from ...core.judging.foretelling import foretellings
from ...core.message import message
from ...core.problem import UNEXPECTED
from ...core.record.part_record import descriptors_of
from ...core.run_control import RunControl
from ...storage.info.info_file import source_is_unchanged
from ...storage.info.info_reading import read_info
from ...system.process_limits import WALL_FACTOR
from ..meshing.gmsh_program import gmsh_program
from ..workers.pool_supervisor import PoolSupervisor
from ..workers.preparation import require_preparation
from ..workers.process_pool import WorkerDied, WorkerFault
from ..workers.reading import close_documents, start_reader
from ..workers.worker_pool import worker_folder
from .gmsh_mesh import NOT_MESHABLE, MeshingTask, mesh_document, results_fault
from .labels import info_files
from .meshing_cache import MeshingCache
from .meshing_labels import MeshedResult, Meshing

_READING_SECONDS = 60.0
"""Time for loading FreeCAD and reading a document, beside the limit for a part."""


def mesh_library(library, limits, profile, control=None, report=None):
    """Mesh all classified parts of a library.

    Parameters
    ----------
    library : str or Path
        Folder with info files; their documents are read.
    limits : Limits
        Of time for each part, of memory, and the number of workers.
    profile : Profile
        The quantities of its conditions are examined beside those of the table.
    control : RunControl, optional
    report : callable, optional
        Called with the number of documents done and their total.

    Returns
    -------
    Meshing

    Raises
    ------
    ThinPartError
        If Gmsh is not installed, there are no info files, or no worker can be started.
    KeyboardInterrupt
        When `control` was asked to stop; what was meshed is kept for the next run.
    """
    started = time.monotonic()
    program, version = gmsh_program()
    names = info_files(library)
    found, waiting = _Found(MeshingCache(version, limits)), []
    report = report or (lambda done, total: None)
    for name, info_file in sorted(names.items()):
        try:
            document = _document(library, name, info_file, program, limits.seconds)
        except ThinPartError as error:
            found.fail(name, str(error))
            continue
        if not found.take_kept(document):
            waiting.append(document)
    report(found.count, len(names))
    for document, results in _outcomes(waiting, limits, control or RunControl()):
        if isinstance(results, str):
            found.fail(document.name, results)
        elif not source_is_unchanged(document.source, document.task.document):
            found.fail(document.name, message("{file} changed while it was read: measure it again.", file=document.name))
        else:
            found.add(document, results)
        report(found.count, len(names))
    return Meshing(f"gmsh {version}", found.results, found.failures, _quantities(found.results, profile),
                   round(time.monotonic() - started, 1))


def _quantities(results, profile):
    of_conditions = [condition.quantity for criterion in profile.criteria for condition in criterion.conditions]
    shares = [quantity_named(f"F[{low:g};{high:g}]") for low, high in REPORTED_SHARES]
    return tuple(foretellings([result.descriptors for result in results], [result.has_trouble for result in results],
                              [*shares, *of_conditions]))


@dataclass(frozen=True)
class _Document:
    """A classified document of the library.

    Attributes
    ----------
    name : str
        Its path below the library.
    source : dict
        Of its info file.
    descriptors : dict of str to Descriptors
        By part.
    task : MeshingTask
    """

    name: str
    source: Mapping
    descriptors: Mapping
    task: MeshingTask


def _document(library, name, info_file, program, seconds):
    """Read an info file; ThinPartError if its document cannot be meshed."""
    path = os.path.join(os.path.abspath(library), os.fsdecode(info_file))
    content = read_info(path)
    source = content["source"]
    file = os.path.normpath(os.path.join(os.path.dirname(path), source.get("folder", ""), source["file"]))
    if not source_is_unchanged(source, file):
        raise ThinPartError(message("{file} has changed since it was classified, or is gone: classify it again.",
                                    file=source["file"]), "missing")
    descriptors = {record["name"]: descriptors_of(record) for record in content["parts"]}
    diagonals = {part: each.box.diagonal for part, each in descriptors.items()}
    return _Document(name, source, descriptors, MeshingTask(file, diagonals, program, seconds))


class _Found:
    """What became of documents so far, by their names."""

    def __init__(self, cache):
        self._cache = cache
        self._results, self._failures = {}, {}

    @property
    def count(self):
        """Number of documents that are done."""
        return len({*self._results, *self._failures})

    @property
    def results(self):
        """tuple of MeshedResult"""
        return tuple(result for name in sorted(self._results) for result in self._results[name])

    @property
    def failures(self):
        """tuple of dict"""
        return tuple(failure for name in sorted(self._failures) for failure in self._failures[name])

    def fail(self, name, sentence, part=None):
        """Add why a document or a part could not be given to Gmsh."""
        self._failures.setdefault(name, []).append({"file": name, "part": part, "message": sentence})

    def take_kept(self, document):
        """Take the results of an earlier run; False if there are none."""
        kept = self._cache.results(document.source, document.task)
        if kept is not None:
            self._add(document, kept)
        return kept is not None

    def add(self, document, results):
        """Add what a worker found, and keep it."""
        self._cache.keep(document.source, document.task, results)
        self._add(document, results)

    def _add(self, document, results):
        self._results[document.name] = [
            MeshedResult(document.name, each["part"], each["elements"], each["least_ratio"], each["trouble_share"],
                         each["reason"], document.descriptors[each["part"]])
            for each in results if each["outcome"] != NOT_MESHABLE]
        for each in results:
            if each["outcome"] == NOT_MESHABLE:
                self.fail(document.name, each["reason"], each["part"])


def _outcomes(documents, limits, control):
    """Yield documents with the results of their parts, or a sentence why there are none, as they finish."""
    if not documents:
        return
    # Programs have their own limit. This one is for reading, and for programs that their limit does not end.
    parts = max(len(document.task.diagonals) for document in documents)
    seconds = _READING_SECONDS + limits.seconds + (WALL_FACTOR + 1.0) * limits.seconds * parts
    by_task = {id(document.task): document for document in documents}
    with worker_folder() as folder:
        workers = PoolSupervisor(max(1, min(limits.jobs, len(documents))), seconds, folder, _mesh, start_reader,
                                 (limits.megabytes,), confine=True, with_programs=True)
        try:
            for future, task in workers.run(deque(document.task for document in documents), control):
                yield by_task[id(task)], _outcome(future, task)
        finally:
            workers.stop()


def _mesh(task):
    """Runs in a worker."""
    require_preparation()
    try:
        return mesh_document(task)
    except ThinPartError as error:
        return str(error)
    finally:
        with suppress(Exception):  # what cannot be closed does not lose the results
            close_documents()


def _outcome(future, task):
    name = Path(task.document).name
    try:
        results = future.result()
    except TaskTimeout:
        return message("{file} could not be read in time.", file=name)
    except WorkerDied:
        return message("{file} crashed the process that read it: the file is probably damaged.", file=name)
    except WorkerFault:
        return message("{file} failed ({problem}).", file=name, problem=UNEXPECTED)
    if isinstance(results, str):
        return results
    problem = results_fault(results, task)
    return results if problem is None else message("{file} failed ({problem}).", file=name, problem=problem)

