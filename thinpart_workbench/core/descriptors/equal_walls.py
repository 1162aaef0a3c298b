# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which wall regions are equal, such as the teeth of a gear, however their measures scatter."""

from dataclasses import dataclass

from .region_kinds import TAPER, TOOTH
from .thread_pieces import thread_pieces

SAME, SAME_TAPER = 0.03, 0.12
"""Share by which the thickness of equal regions may differ: points stand for the surface, and what varies in thickness, such
as the tooth of a gear, has a share of them everywhere between thin and thick."""

SAME_SIDES = 0.06
"""Share by which length and width of equal regions may differ: each is known to about 3 percent."""

SAME_AREA = 0.15
"""Share by which the area of regions on equal faces may differ: a small region has twenty points, of which some are lost at
its border. And what is thinnest of them, which a fillet or a neighbour decides."""

SAME_FACE = 0.01
"""Share by which the areas of equal faces differ, since facets lie inside of round faces."""

OF_FACES = 0.6
"""Share of the faces of two regions together that both need to have equal to be on equal faces: a face at the border of a
region belongs to it or not."""


@dataclass(frozen=True)
class WallSize:
    """What tells a wall region from others, mm and mm2.

    Attributes
    ----------
    kind : str
        One of `REGION_KINDS`.
    least, median, length, width, area : float
    faces : tuple of float
        Areas of its faces, ascending.
    """

    kind: str
    least: float
    median: float
    length: float
    width: float
    area: float
    faces: tuple = ()

    @classmethod
    def of_region(cls, region, face_areas):
        """That of a measured WallRegion, by the areas of all faces, ndarray of shape (f,), mm2: WallSize."""
        return cls(region.kind, region.least, region.median, region.length, region.width, region.area,
                   tuple(sorted(float(face_areas[face]) for face in region.faces)))

    @property
    def is_taper(self):
        """Whether it gets thinner towards one side."""
        return self.kind in (TAPER, TOOTH)

    @property
    def is_varied(self):
        """Whether it is thinner at some places than at others."""
        return self.is_taper or self.least < (1.0 - SAME_TAPER) * self.median


def are_equal(one, other):
    """Whether two wall regions are equal, by their `WallSize`: bool.

    Equal faces make equal walls, whatever kind a region that is just wide enough is taken for, and however its length
    was found. Without them, all measures have to agree.
    """
    is_taper = one.is_taper or other.is_taper
    same = SAME_TAPER if one.is_varied or other.is_varied else SAME
    if not _near(one.median, other.median, same):
        return False
    if are_on_equal_faces(one.faces, other.faces):
        return _near(one.area, other.area, SAME_AREA) and (is_taper or _near(one.least, other.least, SAME_AREA))
    return one.kind == other.kind and (is_taper or _near(one.least, other.least, same)) and all(
        _near(getattr(one, name), getattr(other, name), SAME_SIDES) for name in ("length", "width"))


def equal_groups(sizes, said, faces, width):
    """Which wall regions are shown as one row: list of list of int, their numbers, in the order of the first of each.

    The pieces of a thread are one row. Each other region joins the first group whose middle one by thickness is equal to
    it, and of which people say the same.

    Parameters
    ----------
    sizes : sequence of WallSize
    said : sequence
        What people say of each region, of values that can be compared.
    faces : sequence of sequence
        Of each region.
    width : float, mm
        Middle side of the box of the part.
    """
    ridges = [(size.kind, size.median, size.length, own) for size, own in zip(sizes, faces)]
    threads = thread_pieces(ridges, said, width)
    in_threads = {number for thread in threads for number in thread}
    groups: list[list[int]] = []
    for number, (size, of_it) in enumerate(zip(sizes, said)):
        if number in in_threads:
            continue
        equal = next((group for group in groups if said[group[0]] == of_it and are_equal(_middle(sizes, group), size)), None)
        if equal is None:
            groups.append([number])
        else:
            equal.append(number)
    return sorted([*groups, *threads])


def _middle(sizes, group):
    """The `WallSize` of a group that is of middle thickness: what scatters does so on both sides of it."""
    return sorted((sizes[number] for number in group), key=lambda size: size.median)[len(group) // 2]


def are_on_equal_faces(one, other):
    """Whether most faces of two regions are equal, by their areas, ascending, mm2: bool."""
    at_one = at_other = equal = 0
    while at_one < len(one) and at_other < len(other):
        if _near(one[at_one], other[at_other], SAME_FACE):
            equal, at_one, at_other = equal + 1, at_one + 1, at_other + 1
        elif one[at_one] < other[at_other]:
            at_one += 1
        else:
            at_other += 1
    return equal > 0 and equal >= OF_FACES * (len(one) + len(other) - equal)


def _near(one, other, share):
    return abs(one - other) <= share * max(one, other)
