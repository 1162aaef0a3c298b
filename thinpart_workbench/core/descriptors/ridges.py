# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people call equal wall regions; and ridges: the ribs, pins, threads and teeth that stand on the core of a part."""

from typing import NamedTuple

from .equal_walls import SAME, equal_groups
from .region_kinds import BAR, BLOCK, CORE, FEWEST_TEETH, RIB, RIB_VOLUME, THREAD, TOOTH, called, is_rib, is_thread
from .thread_pieces import are_pieces_of_a_thread

NO_RIDGE = 1.0
"""Thickness of the thinnest ridge, by the width of the part, where there is none."""

LEAST_RIDGE_SHARE = 0.01
"""Share of the surface from which on ridges count."""

FEWEST_PINS = 4
"""Bars or blocks of one thickness from which on they are pins on a core, such as the leads of a chip; two are a fork."""

CORE_THICKNESS = 2.0
"""Thickness of a core, by that of a ridge on it, from which it is a solid body beside it."""


class WallRow(NamedTuple):
    """What equal wall regions are together.

    Attributes
    ----------
    typical : int
        Which of them is neither the longest nor the shortest.
    is_one_thread : bool
        Whether they are pieces of one thread.
    length : float, mm
        Of the typical one, or of the thread.
    word : str
        The kind as people call it: see `called`; or `THREAD`, `RIB`, or `TOOTH` of bars that get thinner.
    """

    typical: int
    is_one_thread: bool
    length: float
    word: str


def has_core(sizes, volume_shares, thickness=0.0):
    """Whether bulky regions of at least a thickness, mm, are a good part of a volume together: bool.

    Parameters
    ----------
    sizes : sequence of WallSize
        Of all regions of the part.
    volume_shares : sequence of float or None
    thickness : float, optional
    """
    return sum(share or 0.0 for size, share in zip(sizes, volume_shares)
               if size.kind in (BLOCK, BAR) and size.median >= thickness) >= CORE


def wall_row(sizes, volume_shares, faces, width, on_core):
    """What equal regions are together: WallRow.

    Parameters
    ----------
    sizes : sequence of WallSize
        Of the equal ones.
    volume_shares : sequence of float or None
    faces : sequence of sequence
    width : float, mm
        Middle side of the box of the part.
    on_core : bool
        Whether the part has a core.
    """
    typical = sorted(range(len(sizes)), key=lambda number: sizes[number].length)[(len(sizes) - 1) // 2]
    size = sizes[typical]
    is_one_thread = are_pieces_of_a_thread(
        [(each.kind, each.median, each.length, own) for each, own in zip(sizes, faces)], width)
    length = sum(each.length for each in sizes) if is_one_thread else size.length
    word = called(size.kind, len(sizes))
    if is_one_thread or is_thread(size.kind, length, size.median, width):
        word = THREAD
    elif on_core and is_rib(size.kind, size.width, size.median, volume_shares[typical]):
        word = RIB
    elif _are_teeth(size, volume_shares):
        word = TOOTH
    return WallRow(typical, is_one_thread, length, word)


def ridge_ratio(sizes, volume_shares, faces, width, surface):
    """Median thickness of the thinnest ribs, pins, thread or teeth on a core, by the width: float, `NO_RIDGE` without any.

    Parameters
    ----------
    sizes : sequence of WallSize
        Of all listed regions of the part.
    volume_shares : sequence of float or None
    faces : sequence of sequence
    width : float, mm
        Middle side of the box of the part.
    surface : float, mm2
        Area of the part.
    """
    if not has_core(sizes, volume_shares):
        return NO_RIDGE
    rows = []
    for numbers in equal_groups(sizes, [None] * len(sizes), faces, width):
        own, shares = [sizes[number] for number in numbers], [volume_shares[number] for number in numbers]
        walls = wall_row(own, shares, [faces[number] for number in numbers], width, on_core=True)
        rows.append(_RidgeRow(own[walls.typical].median, len(own), sum(size.area for size in own),
                              walls.word in (RIB, THREAD, TOOTH), _is_slim(own[walls.typical].kind, shares)))
    return min([NO_RIDGE, *(row.thickness / width for row in rows
                            if (row.is_ridge or _are_pins(row, rows)) and row.area >= LEAST_RIDGE_SHARE * surface
                            and has_core(sizes, volume_shares, CORE_THICKNESS * row.thickness))])


class _RidgeRow(NamedTuple):
    thickness: float
    walls: int
    area: float
    is_ridge: bool
    is_slim: bool


def _are_teeth(typical, volume_shares):
    """Whether there are enough equal slim bars that get thinner somewhere: teeth with a broad tip, of gears and pulleys."""
    return typical.kind == BAR and typical.is_varied and len(volume_shares) >= FEWEST_TEETH and _is_slim(BAR, volume_shares)


def _is_slim(kind, volume_shares):
    return kind in (BAR, BLOCK) and all(share is not None and share <= RIB_VOLUME for share in volume_shares)


def _are_pins(row, rows):
    """Whether there are enough of one thickness, whatever their lengths: leads are bent and cut differently."""
    return row.is_slim and sum(other.walls for other in rows if other.is_slim and abs(
        other.thickness - row.thickness) <= SAME * row.thickness) >= FEWEST_PINS
