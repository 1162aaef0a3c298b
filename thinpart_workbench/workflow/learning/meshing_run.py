"""Mesh the parts of a library in worker processes, several at the same time."""

import json
import os
import time
from collections import defaultdict
from dataclasses import replace

from ...core.descriptors.descriptor_table import REPORTED_SHARES, quantity_named
from ...core.errors import ThinPartError
from ...core.judging.foretelling import foretellings
from ...core.mesh.tetrahedra import POOR
from ...core.message import message
from ...core.record.part_record import descriptors_of
from ...storage.info.info_file import source_is_unchanged
from ...storage.info.info_reading import read_info
from ...system.process_limits import WALL_FACTOR
from ..analysis.measured_source import check_source
from ..library.reclassify import described_document
from ..meshing.gmsh_program import gmsh_program
from ..workers.preparation import require_preparation
from ..workers.result_cache import ResultCache
from ..workers.task_run import run_tasks
from .gmsh_mesh import NOT_MESHABLE, SIZE, MeshingTask, mesh_document, results_fault
from .labels import info_files
from .meshing_labels import MeshedResult, Meshing

_LARGEST = 64 << 20
"""Bytes of the results of a document that are kept."""

_READING_SECONDS = 60.0
"""Time for loading FreeCAD and reading a document, beside the limit for a part."""


def mesh_library(library, limits, profile, control=None, report=None):
    """Mesh all classified parts of a library: Meshing.

    Raises ThinPartError if Gmsh is not installed, there are no info files, or no worker can be started. Raises Cancelled
    when `control` was asked to stop; what was meshed is kept for the next run.

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
    """
    started = time.monotonic()
    program, version = gmsh_program()
    names = info_files(library)
    results, failures, documents = defaultdict(list), defaultdict(list), {}
    report = report or (lambda done, total: None)

    def fail(name, sentence, part=None):
        failures[name].append({"file": name, "part": part, "message": sentence})

    for name, info_file in sorted(names.items()):
        try:
            task, descriptors = _document(library, info_file, program, limits.seconds)
        except ThinPartError as error:
            fail(name, str(error))
        else:
            documents[id(task)] = task, name, descriptors
    report(len(failures), len(names))
    tasks = [task for task, *_ in documents.values()]
    # Programs have their own limit. This one is for reading, and for programs that their limit does not end.
    parts = max((len(task.diagonals) for task in tasks), default=0)
    for_all = replace(limits, seconds=_READING_SECONDS + limits.seconds + (WALL_FACTOR + 1.0) * limits.seconds * parts)
    cache = ResultCache("meshing", _key(version, limits), _LARGEST)
    for done in run_tasks(tasks, _meshed, _results, for_all, cache=cache, control=control, with_programs=True):
        _, name, descriptors = documents[id(done.task)]
        if done.failure is not None:
            failed = done.failure["error"]
            fail(name, failed["message"] if failed["kind"] != "timeout" else message(
                "{file} could not be read in time.", file=os.path.basename(done.task.file)))
        for each in done.result or ():
            if each["outcome"] == NOT_MESHABLE:
                fail(name, each["reason"], each["part"])
            else:
                results[name].append(MeshedResult(
                    name, each["part"], each["elements"], each["least_ratio"], each["trouble_share"], each["reason"],
                    descriptors[each["part"]]))
        report(len({*results, *failures}), len(names))
    meshed = _in_order(results)
    return Meshing(f"gmsh {version}", meshed, _in_order(failures), _quantities(meshed, profile),
                   round(time.monotonic() - started, 1))


def _in_order(by_name):
    return tuple(each for name in sorted(by_name) for each in by_name[name])


def _quantities(results, profile):
    of_conditions = [condition.quantity for criterion in profile.criteria for condition in criterion.conditions]
    shares = [quantity_named(f"F[{low:g};{high:g}]") for low, high in REPORTED_SHARES]
    return tuple(foretellings([result.descriptors for result in results], [result.has_trouble for result in results],
                              [*shares, *of_conditions]))


def _document(library, info_file, program, seconds):
    """What an info file says: the task for its document, and descriptors by part; ThinPartError if it cannot be meshed."""
    path = os.path.join(os.path.abspath(library), os.fsdecode(info_file))
    content = read_info(path)
    source, file = content["source"], described_document(path, content)
    if not source_is_unchanged(source, file):
        raise ThinPartError(message("{file} has changed since it was classified, or is gone: classify it again.",
                                    file=source["file"]), "missing")
    descriptors = {record["name"]: descriptors_of(record) for record in content["parts"]}
    diagonals = {part: each.box.diagonal for part, each in descriptors.items()}
    return MeshingTask(file, source, diagonals, program, seconds), descriptors


def _key(version, limits):
    """What results depend on: limits too, since what took too long might not with others."""
    def key(task):
        what = ["1", version, SIZE, POOR, float(limits.seconds), limits.megabytes]
        links = [link["sha256"] for link in task.source.get("links", ())]
        return json.dumps([what, task.source["sha256"], links, task.diagonals])

    return key


def _meshed(task):
    """Runs in a worker."""
    require_preparation()
    return mesh_document(task)


def _results(task, answer):
    """The results of the parts of a document that an answer holds."""
    fault = results_fault(answer, task)
    if fault is not None:
        raise ValueError(fault)
    check_source(task.source, task.file)
    return answer
