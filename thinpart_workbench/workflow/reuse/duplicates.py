# SPDX-License-Identifier: LGPL-2.1-or-later
"""Groups of parts of libraries that are the same, mirrored, scaled, or alike, each with its evidence."""

from dataclasses import dataclass, replace
from typing import Any

from ...core.forms.laying import SAME
from ...core.reuse.likeness import KINDS
from ...core.run_control import RunControl
from ..workers.result_cache import ResultCache
from ..workers.task_run import run_tasks, run_with_cache
from .comparison_task import ComparedPart, ComparisonTask, checked_comparison, comparison_by_worker, side_answer
from .evidence import BYTES, GEOMETRY, OUTLINES, evidence, judged
from .formed_parts import formed_parts
from .like_parts import LikeParts
from .like_processes import alike, of_one_form

REFERENCE = "reference"
"""What stands for the kind of the part of a group that is to be kept, with which the others are compared."""

_CACHE, _LARGEST = "comparisons", 16 << 20


@dataclass(frozen=True)
class GroupPart:
    """A part of a group.

    Attributes
    ----------
    stored : StoredPart
    kind : str
        One of `KINDS`, or `REFERENCE`.
    evidence : dict
        See docs/command-line.md; empty for the reference.
    """

    stored: Any
    kind: str
    evidence: dict


@dataclass(frozen=True)
class PartGroup:
    """Parts that are one kind of likeness to the first of them, which is the one to keep.

    Attributes
    ----------
    kind : str
        One of `KINDS`.
    parts : list of GroupPart
    """

    kind: str
    parts: list


@dataclass(frozen=True)
class Duplicates:
    """What several parts of libraries have in common.

    Attributes
    ----------
    groups : list of PartGroup
        The closest kind first, and the largest groups of a kind.
    compared : int
        Number of parts that were compared.
    without_form : int
        Number of those that an earlier version has measured, which have to be classified again first.
    failures : list of dict
        As `failure` makes them, of documents that could not be read again: what is said of them comes from their records.
    """

    groups: list
    compared: int
    without_form: int
    failures: list


def find_duplicates(indexes, limits, reads_documents=True, control=None, report=None, cluster=None):
    """Find the parts that refreshed LibraryIndexes have more than once: Duplicates.

    Parts are found by the moments and outlines that their records keep. Then the documents of each pair are read again, and
    their geometry is compared; results of before are taken from the cache. Raises Cancelled when `control` was asked to
    stop.

    Parameters
    ----------
    indexes : list of LibraryIndex
    limits : Limits
        Of seconds for each pair, of memory, and the number of workers.
    reads_documents : bool, optional
        Whether documents are read; otherwise the outlines are the evidence.
    control : RunControl, optional
    report : callable, optional
        Called with the numbers of steps done and of all; may raise to stop.
    cluster : str, optional
        Address of a Dask scheduler, from `cluster_address`, whose workers read and compare the documents.
    """
    control, report = control or RunControl(), report or (lambda done, total: None)
    parts = formed_parts(indexes)

    def step(done, total):
        control.check()
        report(done, total)

    likes = LikeParts(parts)
    found = of_one_form(likes, parts, limits.jobs, control, step)
    rest = set(range(len(parts))) - {each.part for each in found}
    found += alike(likes, parts, rest, limits.jobs, control, step)
    stored = parts.stored(sorted({number for each in found for number in (each.part, each.reference)}))
    found = [likes.with_ways(each) if reads_documents else each
             for each in found if each.part in stored and each.reference in stored]
    answers, failures = _answers(found, parts, stored, limits, reads_documents, control, report, cluster)
    groups: dict = {}
    for likeness, (answer, compared) in zip(found, answers):
        likeness = likeness.taken(answer["motion"]) if compared == GEOMETRY else likeness
        part, reference = stored[likeness.part], stored[likeness.reference]
        kind = judged(likeness, answer, compared, part, reference)
        if kind is not None:
            member = GroupPart(part, kind, evidence(kind, likeness, answer, compared, part, reference))
            groups.setdefault((kind, likeness.reference), []).append(member)
    made = [PartGroup(kind, [GroupPart(stored[reference], REFERENCE, {}), *members])
            for (kind, reference), members in groups.items()]
    made.sort(key=lambda group: (KINDS.index(group.kind), -len(group.parts)))
    return Duplicates(made, len(parts), parts.without_form, failures)


def _answers(found, parts, stored, limits, reads_documents, control, report, cluster):
    """Of each `Likeness`: an answer about it, and what was compared; and the failures of documents."""
    answers, failures, tasks = [], [], {}
    for number, likeness in enumerate(found):
        part, reference = stored[likeness.part], stored[likeness.reference]
        form, other = parts.form(likeness.part), parts.form(likeness.reference)
        is_copy = part.sha256 == reference.sha256 and part.name == reference.name
        answers.append((of_outlines(likeness.laid, form, other), BYTES if is_copy else OUTLINES))
        if reads_documents and not is_copy:
            motions = tuple(laid.motion for laid in likeness.ways)
            task = ComparisonTask(_compared_part(part, form), _compared_part(reference, other), motions)
            tasks[id(task)] = number, task
    limits = replace(limits, seconds=2.0 * limits.seconds)  # two documents are read
    for count, done in enumerate(_compared([task for _, task in tasks.values()], limits, control, cluster), 1):
        report(count, len(tasks))
        if done.failure is not None:
            failures.append(done.failure)
        else:
            answers[tasks[id(done.task)][0]] = done.result, GEOMETRY
    return answers, failures


def _compared(tasks, limits, control, cluster):
    """Yield the Done of each ComparisonTask; what was compared before comes from the cache."""
    cache = ResultCache(_CACHE, lambda task: task.key, _LARGEST)
    if cluster is None:
        yield from run_tasks(tasks, comparison_by_worker, checked_comparison, limits, cache=cache, control=control)
        return
    # Imported late: few runs need what it imports.
    from ..cluster.cluster_run import run_on_cluster
    from .comparison_work import COMPARISONS

    def run(waiting):
        return run_on_cluster(cluster, waiting, COMPARISONS, limits, control)

    yield from run_with_cache(tasks, run, checked_comparison, cache, control)


def of_outlines(laid, form, other):
    """What the outlines of two forms say, as `comparison_task.ANSWER`."""
    same = SAME * other.extent
    return {"are_solids": True, "extent_mm": other.extent, "motion": 0,
            "part": side_answer(form, laid.distance, same),
            "reference": side_answer(other, laid.other_distance, same)}


def _compared_part(stored, form):
    return ComparedPart(stored.file, stored.sha256, stored.name, form)
