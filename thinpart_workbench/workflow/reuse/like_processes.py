# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds what is alike among many parts by several processes; the result is that of `LikeParts` in one."""

import base64
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ...core.errors import ThinPartError
from ...core.forms.laying import Laid
from ...core.forms.motion import Motion
from ..workers.process_pool import ProcessPool
from ..workers.task_run import worker_folder
from ..workers.worker_thread import WorkerDied, WorkerFault
from .like_parts import SAME_PROPORTIONS, Likeness, LikeParts

FEW = 3000
"""Parts up to which other processes would take longer to start than they help."""

_SECONDS = 3600.0  # for a lot
_TOGETHER = 300  # parts of a lot, unless more are near each other
_PAIRS, _REFERENCES = 16, 4000  # of a lot, and of all lots at a time, where parts may be alike
_MOST_NEAR = 20_000_000  # pairs of cells, from which on looking for what hangs together takes more memory than it saves time
_CELLS = 10.0  # in `SAME_PROPORTIONS`, within which proportions are equal


def of_one_form(likes, parts, jobs, control, report):
    """What `LikeParts.of_one_form` finds, as a list in the same order.

    Parts whose proportions are far from each other, by whichever others between them, are nothing to each other: each lot of
    the rest is searched by one process.

    Parameters
    ----------
    likes : LikeParts
    parts : FormedParts
        Those.
    jobs : int
        Number of processes.
    control : RunControl
    report : callable
        Called with the numbers of parts done and of all; may raise to stop.
    """
    if jobs > 1 and len(parts) >= FEW:
        with suppress(ThinPartError):  # where no process can be started, this one does it
            return _of_one_form(parts, jobs, control, report)
    return list(likes.of_one_form(report))


def _of_one_form(parts, jobs, control, report):
    found: list = []
    lots = _Lots(parts, _lots(parts.proportions))
    with _processes(jobs, _wholes) as done:
        for lot, told in done(lots, control):
            found += [_restored(each, lot.members) for each in told]
            report(lots.done(lot), len(parts))
    # The order in which one process finds them: by how the references stand; those of one reference come together.
    rank = {part: place for place, part in enumerate(sorted(range(len(parts)), key=lambda part: parts.standing[part],
                                                            reverse=True))}
    return sorted(found, key=lambda each: rank[each.reference])


def alike(likes, parts, among, jobs, control, report):
    """What `LikeParts.alike` finds, as a list in the same order; parameters as in `of_one_form`."""
    if jobs > 1 and len(among) >= FEW:
        with suppress(ThinPartError):
            return _alike(likes, parts, among, jobs, control, report)
    return list(likes.alike(among, report))


def _alike(likes, parts, among, jobs, control, report):
    with _processes(jobs, _partlies) as done:
        def partly(pairs):
            batches = [pairs[start:start + _PAIRS] for start in range(0, len(pairs), _PAIRS)]
            lots, answers = _Lots(parts, [np.unique(np.array(batch)) for batch in batches], batches), {}
            for lot, told in done(lots, control):
                answers[lot.number] = [None if each is None else _restored(each, lot.members) for each in told]
            return [each for number in range(len(batches)) for each in answers[number]]

        return list(likes.alike(among, report, partly, _REFERENCES))


@dataclass(frozen=True)
class _Lot:
    """Parts that a process is given, with their numbers among all, and the pairs of them that are to be compared."""

    number: int
    members: np.ndarray
    parts: object
    pairs: tuple


class _Lots:
    """The lots that wait: each reads the forms of its parts when it is taken."""

    def __init__(self, parts, members, pairs=None):
        self._parts, self._members, self._pairs = parts, members, pairs
        self._taken = self._done = 0

    def __len__(self):
        return len(self._members) - self._taken

    def popleft(self):
        number, self._taken = self._taken, self._taken + 1
        members = self._members[number]
        pairs = () if self._pairs is None else tuple(
            tuple(int(each) for each in np.searchsorted(members, pair)) for pair in self._pairs[number])
        return _Lot(number, members, self._parts.alone(members), pairs)

    def done(self, lot):
        """How many parts are done with a further lot."""
        self._done += len(lot.members)
        return self._done


def _lots(proportions):
    """Numbers of parts, ascending, so that all that are near each other are together: list of ndarray.

    Parts that are near no other are left out. Equal proportions, of which copies have many, count once.
    """
    side = SAME_PROPORTIONS / _CELLS
    cells, cell = np.unique(np.floor(proportions / side), axis=0, return_inverse=True)
    tree, reach = cKDTree(cells * side), SAME_PROPORTIONS + side * np.sqrt(proportions.shape[1])
    if tree.count_neighbors(tree, reach) > _MOST_NEAR:
        return [np.arange(len(proportions))]
    first, second = tree.query_pairs(reach, output_type="ndarray").T
    graph = coo_matrix((np.ones(len(first), dtype=bool), (first, second)), (len(cells), len(cells)))
    label = connected_components(graph, directed=False)[1][cell.ravel()]
    several = np.flatnonzero(np.bincount(label)[label] > 1)
    order = several[np.argsort(label[several], kind="stable")]
    ends = np.flatnonzero(np.diff(label[order])) + 1
    # Small ones together: the first of so many parts begins a lot.
    begins = np.flatnonzero(np.diff(np.append(0, ends) // _TOGETHER))
    return [np.sort(lot) for lot in np.split(order, ends[begins]) if len(lot)]


@contextmanager
def _processes(jobs, work):
    """For a ``with`` block: a function of lots that yields each with what `work` tells of it, as processes finish them."""
    with worker_folder() as folder:
        pool = ProcessPool(jobs, _SECONDS, folder, work, _start)

        def done(lots, control):
            with closing(pool.run(lots, control)) as finished:
                for future, lot in finished:
                    try:
                        told = future.result()
                    except (WorkerDied, WorkerFault, TaskTimeout):
                        told = work(lot)
                    yield lot, told

        try:
            yield done
        finally:
            pool.stop()


def _start():
    """Nothing is to be prepared."""


def _wholes(lot):
    return [_told(each) for each in LikeParts(lot.parts).of_one_form()]


def _partlies(lot):
    likes = LikeParts(lot.parts)
    return [None if each is None else _told(each) for each in likes.partly(lot.pairs)]


def _told(likeness):
    # It is laid in one of its ways, where they were looked for.
    number = next((number for number, way in enumerate(likeness.ways) if way is likeness.laid), None)
    laid = [likeness.laid] if number is None else likeness.ways
    return [int(likeness.part), int(likeness.reference), likeness.kind, number, [_told_laid(each) for each in laid]]


def _restored(told, members):
    part, reference, kind, number, laid = told
    laid = tuple(map(_restored_laid, laid))
    return Likeness(int(members[part]), int(members[reference]), kind, laid[number or 0], () if number is None else laid)


def _told_laid(laid):
    motion = laid.motion
    numbers = [*motion.turn.ravel(), motion.scale, *motion.shift, laid.share, laid.other_share, len(laid.distance)]
    return base64.b64encode(np.concatenate([numbers, laid.distance, laid.other_distance]).tobytes()).decode()


def _restored_laid(told):
    numbers = np.frombuffer(base64.b64decode(told))
    motion = Motion(numbers[:9].reshape(3, 3), float(numbers[9]), numbers[10:13])
    distance, other = np.split(numbers[16:], [int(numbers[15])])
    return Laid(motion, distance, other, float(numbers[13]), float(numbers[14]))
