# SPDX-License-Identifier: LGPL-2.1-or-later
"""Label the parts of a library by a program in worker processes, several at the same time."""

import json
import os
import time
from collections import defaultdict
from dataclasses import replace

from ...core.descriptors.descriptor_table import REPORTED_SHARES, quantity_named
from ...core.errors import ThinPartError
from ...core.judging.foretelling import foretellings
from ...core.message import message
from ...core.record.part_record import descriptors_of
from ...storage.info.info_file import source_is_unchanged
from ...storage.info.info_reading import read_info
from ..analysis.measured_source import check_source
from ..library.reclassify import described_document
from ..workers.preparation import require_preparation
from ..workers.result_cache import ResultCache
from ..workers.task_run import run_tasks
from .automatic_labels import AutomaticLabels
from .labelling_task import LabellingTask, answer_fault, measure_document
from .labels import info_files

_LARGEST = 64 << 20
"""Bytes of the results of a document that are kept."""

_READING_SECONDS = 120.0
"""Time for loading FreeCAD and reading a document, beside the limit for a part."""


def label_library(library, labelling, limits, profile, control=None, report=None):
    """Label all classified parts of a library by a program: AutomaticLabels.

    Raises ThinPartError if there are no info files, or no worker can be started. Raises Cancelled when `control` was asked
    to stop; what was measured is kept for the next run.

    Parameters
    ----------
    library : str or Path
        Folder with info files; their documents are read.
    labelling : Labelling
    limits : Limits
        Of memory, and the number of workers.
    profile : Profile
        The quantities of its conditions are examined beside those of the table.
    control : RunControl, optional
    report : callable, optional
        Called with the number of documents done and their total.
    """
    started = time.monotonic()
    names = info_files(library)
    results, failures, documents = defaultdict(list), defaultdict(list), {}
    report = report or (lambda done, total: None)

    def fail(name, sentence, part=None):
        failures[name].append({"file": name, "part": part, "message": sentence})

    for name, info_file in sorted(names.items()):
        try:
            task, descriptors = _document(library, info_file, labelling)
        except ThinPartError as error:
            fail(name, str(error))
        else:
            documents[id(task)] = task, name, descriptors
    report(len(failures), len(names))
    tasks = [task for task, *_ in documents.values()]
    # Programs have their own limits. This one is for reading, and for programs that their limits do not end.
    parts = max((len(task.diagonals) for task in tasks), default=0)
    for_all = replace(limits, seconds=_READING_SECONDS + labelling.part_seconds * parts)
    cache = ResultCache(labelling.cache, _key(labelling, limits), _LARGEST)
    for done in run_tasks(tasks, _answer, _checked, for_all, cache=cache, control=control, with_programs=True):
        _, name, descriptors = documents[id(done.task)]
        if done.failure is not None:
            failed = done.failure["error"]
            fail(name, failed["message"] if failed["kind"] != "timeout" else message(
                "{file} could not be read in time.", file=os.path.basename(done.task.file)))
        for each in done.result or ():
            try:
                results[name].append(_label(labelling, name, each, descriptors[each["part"]]))
            except ThinPartError as error:
                fail(name, str(error), each["part"])
        report(len({*results, *failures}), len(names))
    labelled = _in_order(results)
    return AutomaticLabels(labelling, labelled, _in_order(failures), _quantities(labelled, profile),
                           round(time.monotonic() - started, 1))


def _label(labelling, name, answer, descriptors):
    if answer["failure"]:
        raise ThinPartError(answer["failure"])
    return labelling.labelled(name, answer["part"], answer["measured"], descriptors)


def _in_order(by_name):
    return tuple(each for name in sorted(by_name) for each in by_name[name])


def _quantities(results, profile):
    of_conditions = [condition.quantity for criterion in profile.criteria for condition in criterion.conditions]
    shares = [quantity_named(f"F[{low:g};{high:g}]") for low, high in REPORTED_SHARES]
    return tuple(foretellings([result.descriptors for result in results], [result.has_trouble for result in results],
                              [*shares, *of_conditions]))


def _document(library, info_file, labelling):
    """What an info file says: the task for its document, and descriptors by part; ThinPartError if it cannot be measured."""
    path = os.path.join(os.path.abspath(library), os.fsdecode(info_file))
    content = read_info(path)
    source, file = content["source"], described_document(path, content)
    if not source_is_unchanged(source, file):
        raise ThinPartError(message("{file} has changed since it was classified, or is gone: classify it again.",
                                    file=source["file"]), "missing")
    descriptors = {record["name"]: descriptors_of(record) for record in content["parts"]}
    diagonals = {part: each.box.diagonal for part, each in descriptors.items()}
    return LabellingTask(file, source, diagonals, labelling), descriptors


def _key(labelling, limits):
    def key(task):
        links = [link["sha256"] for link in task.source.get("links", ())]
        return json.dumps([labelling.key(), limits.megabytes, task.source["sha256"], links, task.diagonals])

    return key


def _answer(task):
    """Runs in a worker."""
    require_preparation()
    return measure_document(task)


def _checked(task, answer):
    """What was measured of the parts of a document, of which an answer holds all."""
    fault = answer_fault(answer, task)
    if fault is not None:
        raise ValueError(fault)
    check_source(task.source, task.file)
    return answer
