# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which wall regions are pieces of one thread: of a narrow crest, samples lose what is in between."""

from .region_kinds import TAPER, TOOTH, is_thread

_SAME = 0.03
"""Share by which the thickness of the pieces of a thread may differ."""


def thread_pieces(ridges, said, width):
    """Regions that are pieces of one thread: list of list of int, their numbers, ascending.

    One piece goes on where the next begins: on a face that both have, as thick.

    Parameters
    ----------
    ridges : sequence of tuple
        Kind, median thickness, length, mm, and faces of each region.
    said : sequence
        What people say of each; the pieces of one thread have to agree.
    width : float, mm
        Middle side of the box of the part.
    """
    threads: list[list[int]] = []
    for number, ridge in enumerate(ridges):
        if ridge[0] in (TAPER, TOOTH):
            joined = [thread for thread in threads
                      if any(said[other] == said[number] and _go_on(ridges[other], ridge) for other in thread)]
            threads = [thread for thread in threads if thread not in joined]
            threads.append(sorted([number, *(other for thread in joined for other in thread)]))
    return [thread for thread in threads if len(thread) > 1 and _go_round([ridges[number] for number in thread], width)]


def are_pieces_of_a_thread(ridges, width):
    """Whether all of some regions, as in `thread_pieces`, are pieces of one thread: bool."""
    return thread_pieces(ridges, [None] * len(ridges), width) == [list(range(len(ridges)))]


def _go_on(one, other):
    (_, median, _, faces), (_, other_median, _, other_faces) = one, other
    return abs(median - other_median) <= _SAME * max(median, other_median) and not set(faces).isdisjoint(other_faces)


def _go_round(ridges, width):
    return is_thread(TOOTH, sum(length for _, _, length, _ in ridges), ridges[0][1], width)
