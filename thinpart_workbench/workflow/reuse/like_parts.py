# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds parts of one form, and parts that are alike, by what their records keep of them."""

from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from ...core.forms.laying import Laid, each_laid, is_exact, laid_partly, laid_whole
from ...core.reuse.likeness import (
    KINDS,
    LIKE,
    SAME_MEASURE_OF_TRIANGLES,
    is_much_nearer,
    is_whole_by_outlines,
    kind_of,
    known_scale,
)

SAME_PROPORTIONS = 4e-3
"""Distance of `FormedParts.proportions` up to which parts may have one form: triangles of a round part differ from it."""

NEIGHBOURS = 10
"""Parts, of those nearest in size and proportions, that are looked at as alike."""

MOST_UNLIKE = 0.5
"""Distance of the logarithms of sizes up to which they are."""

LIKE_SIDE = 1e-3
"""Share by which a side of the box, or the area of a face, may differ that two parts have in common."""

LIKE_AREA = 0.25
"""Share of the surface that faces have that two parts have in common, from which on they may be alike."""

_FORMS_AT_HAND = 4096
_TURNED_FIRST = 2
_LEAST_LENGTH = 1e-9


@dataclass(frozen=True)
class Likeness:
    """What a part is to another one.

    Attributes
    ----------
    part, reference : int
        Numbers in the `FormedParts`.
    kind : str
        One of `likeness.KINDS`.
    laid : Laid
        The part laid upon the reference.
    ways : tuple of Laid
        All ways to lay it that are likely, where they were looked for; see `LikeParts.with_ways`.
    """

    part: int
    reference: int
    kind: str
    laid: Laid
    ways: tuple = ()

    def taken(self, number):
        """The same, laid in one of its ways."""
        return replace(self, laid=self.ways[number])


class LikeParts:
    """Finds what is alike among `FormedParts`."""

    def __init__(self, parts):
        self._parts = parts
        self._form = lru_cache(_FORMS_AT_HAND)(parts.form)
        self._areas = lru_cache(None)(self._face_areas)  # some hundred bytes of each part
        self._order = sorted(range(len(parts)), key=lambda part: parts.standing[part], reverse=True)

    def of_one_form(self, report=None):
        """Yield a `Likeness` for each part that is identical with, mirrors or scales one that stands before it."""
        if not self._order:
            return
        tree, taken = cKDTree(self._parts.proportions), set()
        for done, reference in enumerate(self._order):
            if report is not None:
                report(done, len(self._order))
            if reference in taken:
                continue
            taken.add(reference)
            near = [part for part in tree.query_ball_point(self._parts.proportions[reference], SAME_PROPORTIONS)
                    if part not in taken and self._may_have_one_volume(part, reference)]
            for part in sorted(near, key=lambda part: (self._distance(part, reference), part)):
                found = self._whole(part, reference)
                if found is not None:
                    taken.add(part)
                    yield found

    def alike(self, among, report=None, partly=None, at_once=1):
        """Yield a `Likeness` for each of some parts that is alike but for something to one that stands before it.

        Parameters
        ----------
        among : set of int
        report : callable, optional
            Called with the numbers of parts done and of all; may raise to stop.
        partly : callable, optional
            As the method `partly`.
        at_once : int, optional
            Of how many references the pairs are given to it at a time.
        """
        chosen = [part for part in self._order if part in among]
        if len(chosen) < 2:
            return
        size, partly = self._size(chosen), partly or self.partly
        tree, taken = cKDTree(size), set()
        for start in range(0, len(chosen), at_once):
            references, pairs = range(start, min(start + at_once, len(chosen))), []
            _, near = tree.query(size[references], k=min(NEIGHBOURS + 1, len(chosen)), distance_upper_bound=MOST_UNLIKE)
            for done, places in zip(references, near):
                reference = chosen[done]
                if report is not None:
                    report(done, len(chosen))
                if reference not in taken:
                    others = [chosen[place] for place in places if done < place < len(chosen)]  # none has the last number
                    pairs += [(part, reference) for part in self._may_be_alike(
                        [part for part in others if part not in taken], reference)]
            for (part, reference), found in zip(pairs, partly(pairs)):
                if found is not None and part not in taken and reference not in taken:
                    taken.add(part)
                    yield found

    def partly(self, pairs):
        """What each pair of a part and a reference have in common: iterable of `Likeness`, None where that is little."""
        return (self._partly(part, reference) for part, reference in pairs)

    def of_part(self, part):
        """What a part is to the one of the others that is closest to it: `Likeness`, or None where none is alike."""
        proportions, size = self._parts.proportions, self._size(slice(None))
        away = np.linalg.norm(proportions - proportions[part], axis=1)
        away[part] = np.inf
        whole = [self._whole(part, other) for other in np.argsort(away, kind="stable")[:NEIGHBOURS]
                 if away[other] <= SAME_PROPORTIONS]
        found = [each for each in whole if each is not None]
        if found:
            return min(found, key=lambda each: (KINDS.index(each.kind), each.laid.apart(np.inf)))
        away = np.linalg.norm(size - size[part], axis=1)
        away[part] = np.inf
        near = [other for other in np.argsort(away, kind="stable")[:NEIGHBOURS] if away[other] <= MOST_UNLIKE]
        partly = [self._partly(part, other) for other in near if self._may_be_alike([part], other)]
        return max((each for each in partly if each is not None), key=lambda each: each.laid.least_share, default=None)

    def _size(self, parts):
        lengths = np.column_stack([self._parts.radii, np.sqrt(self._parts.area)])[parts]
        return np.log(np.maximum(lengths, _LEAST_LENGTH))

    def _distance(self, part, reference):
        return abs(np.log(self._parts.area[part] / self._parts.area[reference]))

    def _may_have_one_volume(self, part, reference):
        """Whether volumes agree, as far as those of triangles do, where both are known."""
        own, other = self._parts.volume[part], self._parts.volume[reference]
        scaled = own * (self._parts.area[reference] / self._parts.area[part]) ** 1.5
        return not abs(scaled - other) > SAME_MEASURE_OF_TRIANGLES * other  # nan agrees with everything

    def with_ways(self, likeness):
        """A Likeness with all ways to lay the part that are likely, in the order in which geometry is to try them.

        Only geometry tells them from each other where a part is nearly symmetric.
        """
        if likeness.ways:
            return likeness
        turned, mirrored = self._ways(likeness.part, likeness.reference, likeness.laid.motion.scale)
        return replace(likeness, ways=(*turned[:_TURNED_FIRST], *mirrored, *turned[_TURNED_FIRST:]))

    def _whole(self, part, reference):
        form, other = self._form(part), self._form(reference)
        if form is None or other is None:
            return None
        scale = known_scale(float(np.sqrt(self._parts.area[reference] / self._parts.area[part])))
        if scale != 1.0:  # in a large library many boxes are others by some factor: one way is enough to say so
            found = next((laid for is_mirrored in (False, True) for laid in each_laid(form, other, scale, is_mirrored)
                          if is_whole_by_outlines(laid)), None)
            return None if found is None else Likeness(part, reference, kind_of(found, True), found)
        turned, mirrored = self._ways(part, reference, scale)
        ways = (*turned[:_TURNED_FIRST], *mirrored, *turned[_TURNED_FIRST:])
        if not ways:
            return None
        # Where the mirror image is as near, the part is a mirror image of itself.
        is_mirrored = not turned or bool(mirrored) and is_much_nearer(mirrored[0], turned[0], other.extent)
        laid = mirrored[0] if is_mirrored else turned[0]
        return Likeness(part, reference, kind_of(laid, True), laid, ways)

    def _ways(self, part, reference, scale):
        """The ways to lay a part upon one of its form, turned and mirrored: two lists of `Laid`, the best one first."""
        form, other = self._form(part), self._form(reference)
        turned = [laid for laid in laid_whole(form, other, scale, False) if is_whole_by_outlines(laid)]
        if turned and is_exact(turned[0], other.extent):
            return turned[:1], []
        return turned, [laid for laid in laid_whole(form, other, scale, True) if is_whole_by_outlines(laid)]

    def _partly(self, part, reference):
        form, other = self._form(part), self._form(reference)
        if form is None or other is None:
            return None
        laid = laid_partly(form, other, LIKE)
        return None if laid is None else Likeness(part, reference, kind_of(laid, False), laid, (laid,))

    def _may_be_alike(self, parts, reference):
        """Those of some parts, as a list, that have two sides of the box in common with another, or enough faces."""
        if not parts:
            return []
        sides, others = self._parts.sides[parts], self._parts.sides[reference]
        common = (np.abs(sides[:, :, None] - others).min(axis=2) <= LIKE_SIDE * others.max()).sum(axis=1)
        open_ones = [part for part, count in zip(parts, common) if count < 2]
        alike = dict(zip(open_ones, self._common_areas(open_ones, reference) >= LIKE_AREA))
        return [part for part in parts if alike.get(part, True)]

    def _common_areas(self, parts, reference):
        """Shares of the surfaces of some parts that faces have which are as large as one of a reference: ndarray."""
        found, other = np.zeros(len(parts)), self._areas(reference) if parts else None
        known = [number for number, part in enumerate(parts) if self._areas(part) is not None]
        if known and other is not None:
            areas = [self._areas(parts[number]) for number in known]
            starts = np.cumsum([0, *map(len, areas[:-1])])
            own = np.concatenate(areas)
            place = np.searchsorted(other, own)
            above, below = other[np.minimum(place, len(other) - 1)], other[np.maximum(place - 1, 0)]
            nearest = np.minimum(np.abs(own - above), np.abs(own - below))
            same = np.where(nearest <= LIKE_SIDE * own, own, 0.0)
            found[known] = np.add.reduceat(same, starts) / np.add.reduceat(own, starts)
        return found

    def _face_areas(self, part) -> Any:
        form = self._form(part)
        if form is None:
            return None
        return np.sort(np.bincount(form.outline.face, form.outline.area)[np.unique(form.outline.face)])
