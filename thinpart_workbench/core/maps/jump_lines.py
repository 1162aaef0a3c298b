# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets cut along the lines at which the thickness jumps, with a value at each corner of each piece."""

from dataclasses import dataclass, fields
from typing import NamedTuple

import numpy as np

from ..progress import portion, report_progress
from .facet_refinement import cut_sides, side_keys, side_lengths
from .seen_walls import JUMP, differ, seen_walls

INSET = 0.01
"""How far from a corner or a side towards the middle of its facet a wall is measured: on an edge there is none."""

LINE = 1.0 / 600.0
"""Greatest error of a line, as a share of the diagonal."""

ROUNDS = 4
"""How often facets are halved in which walls meet otherwise than along one line from side to side."""

BANDS = 2
"""How often facets are cut, after that, where a band that is narrower than they are lies between two walls."""

UNEVEN = 0.04
"""Share by which the thickness at the middle of a side or of a facet may differ from the mean of its ends or corners."""

STEEP = 0.1
"""The same between the middle of a side with a jump on it and the end that sees the same wall. A wall that ends at a bore is
nowhere else as far from even as beside the line at which the bore goes out of sight."""

MOST_FACETS = 200_000
"""Number of facets from which on none are halved. Few parts come near; frames full of small holes need as many."""

SMOOTH = 1.0 / 8.0
"""Share of the error of a line by which its corners may be off: corners that are off by all of it make a circle a comb."""

_MOST_HALVINGS = 12
"""Of a side, in search of the jump."""


@dataclass(frozen=True)
class CutFacets:
    """Facets on none of which the thickness jumps.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int64
    parent : ndarray of shape (m,), int64
        Triangle of the mesh that each lies on.
    corner_thickness : ndarray of shape (m, 3), mm
        inf where there is no wall.
    opposite : ndarray of shape (m,), int64
        Triangle that the facet sees, -1 for none.
    """

    points: np.ndarray
    facets: np.ndarray
    parent: np.ndarray
    corner_thickness: np.ndarray
    opposite: np.ndarray


def cut_along_jumps(mesh, rays, points, facets, parent, report=None):
    """Cut facets where the thickness jumps: CutFacets.

    Walls are measured at the corners, at the middles of the sides and of the facets. Where they show more than one line
    through a facet, or where the thickness is far from linear beside it, it is halved, a few times. Then the place of the
    jump on each side is found by bisection, and the facet is cut from place to place: on a plane, the edge of a plane wall
    behind it is a straight line. Facets of one face share these places, so that no gaps open.

    Parameters
    ----------
    mesh : SurfaceMesh
    rays : InwardRays
    points : ndarray of shape (v, 3), mm
    facets : ndarray of shape (m, 3), int64
    parent : ndarray of shape (m,), int64
    report : callable, optional
        Called with the fraction done; may raise to stop.
    """
    finest, last = LINE * mesh.extent, ROUNDS + BANDS + 2
    shown = _Shown(points, facets, parent,
                   _measured(mesh, rays, points, facets, parent, portion(report, 0.0, 1.0 / last)))
    for step in range(ROUNDS):
        sides = _to_halve(mesh, shown, step == 0) & (side_lengths(shown.points, shown.facets) > 4.0 * finest)
        sides = _within_bounds(shown, sides)
        if not sides.any():
            break
        shown = _cut_and_measured(mesh, rays, shown, sides, None, portion(report, (step + 1) / last, (step + 2) / last))
    crossings = _NONE
    for step in range(ROUNDS, ROUNDS + BANDS):
        crossings, sides, middle = _bands(mesh, rays, shown, finest, crossings)
        sides = _within_bounds(shown, sides)
        if not sides.any():
            break
        shown = _cut_and_measured(mesh, rays, shown, sides, middle, portion(report, (step + 1) / last, (step + 2) / last))
    cut = _cut(mesh, rays, shown._replace(found=_united(mesh, shown)), finest, crossings)
    report_progress(report, 1.0)
    return cut


class _Shown(NamedTuple):
    """Facets as in `cut_along_jumps`, and what they see."""

    points: np.ndarray
    facets: np.ndarray
    parent: np.ndarray
    found: "_Seen"


def _within_bounds(shown, sides):
    """The sides to cut, only the longest of them where there would be more facets than `MOST_FACETS`."""
    room = (MOST_FACETS - len(shown.facets)) // 2  # a side that is cut divides the facets on both sides of it
    if sides.sum() <= room:
        return sides
    lengths = side_lengths(shown.points, shown.facets)
    return sides & (lengths > np.sort(lengths[sides])[::-1][max(room, 0)])


def _cut_and_measured(mesh, rays, shown, sides, share, report):
    """The facets with some sides cut, at their middle or as `cut_sides` says, and what the pieces see."""
    points, facets, pieces = cut_sides(shown.points, shown.facets, sides, share)
    parent = shown.parent[pieces]
    # Facets that stayed whole come first.
    whole = np.count_nonzero(np.bincount(pieces)[pieces] == 1)
    added = _measured(mesh, rays, points, facets[whole:], parent[whole:], report)
    return _Shown(points, facets, parent, _Seen(*(
        np.concatenate([old[pieces[:whole]], new]) for old, new in zip(shown.found, added))))


class _Seen(NamedTuple):
    """What facets see: thickness and opposite triangle at corners, middles of sides, each of shape (m, 3), and middles."""

    corner: np.ndarray
    opposite: np.ndarray
    side: np.ndarray
    opposite_of_side: np.ndarray
    centre: np.ndarray
    opposite_of_centre: np.ndarray

    def at_corner(self, number):
        """Thickness and opposite triangle at a corner of each facet."""
        return self.corner[:, number], self.opposite[:, number]


def _measured(mesh, rays, points, facets, parent, report):
    face, faces = mesh.face_of_triangle[parent], int(mesh.face_of_triangle.max()) + 1
    middles, row = points[facets].mean(axis=1), np.repeat(np.arange(len(facets)), 3)
    ahead = np.roll(facets, -1, axis=1)
    _, corner, of_corner = np.unique(_corner_keys(facets, face, faces), return_index=True, return_inverse=True)
    _, side, of_side = np.unique(side_keys(facets, len(points)) * faces + face[:, None], return_index=True,
                                 return_inverse=True)
    places = np.concatenate([points[facets.ravel()[corner]],
                             0.5 * (points[facets.ravel()[side]] + points[ahead.ravel()[side]]), middles])
    facet = np.concatenate([row[corner], row[side], np.arange(len(facets))])
    places += INSET * (middles[facet] - places)
    thickness, opposite = seen_walls(mesh, rays, places, parent[facet], report)
    ends = len(corner), len(corner) + len(side)
    (at_corner, at_side, centre), (see_corner, see_side, see) = np.split(thickness, ends), np.split(opposite, ends)
    of_corner, of_side = of_corner.reshape(-1, 3), of_side.reshape(-1, 3)
    return _Seen(at_corner[of_corner], see_corner[of_corner], at_side[of_side], see_side[of_side], centre, see)


def _corner_keys(facets, face, faces):
    return facets * faces + face[:, None]


def _united(mesh, shown):
    """What is seen where all facets of a face that share a corner see the same there: so they agree on which sides jump."""
    faces, found = int(mesh.face_of_triangle.max()) + 1, shown.found
    _, first, back = np.unique(_corner_keys(shown.facets, mesh.face_of_triangle[shown.parent], faces), return_index=True,
                               return_inverse=True)
    back = back.reshape(-1, 3)
    return found._replace(corner=found.corner.ravel()[first][back], opposite=found.opposite.ravel()[first][back])


def _jumps_between(mesh, found):
    """Whether the thickness jumps along each side: ndarray of shape (m, 3), bool."""
    return np.stack([differ(mesh, found.at_corner(side), found.at_corner((side + 1) % 3)) for side in range(3)], axis=1)


def _to_halve(mesh, shown, is_first):
    """Sides of facets through which more than one line goes, or which are far from even: ndarray of shape (m, 3), bool."""
    jumps = _jumps_between(mesh, shown.found)
    halve = ~_is_one_line(mesh, shown.found, jumps) | _is_uneven(shown.found, jumps)
    # A line that is bent within its facet gets a corner there.
    return np.repeat((halve | is_first & jumps.any(axis=1))[:, None], 3, axis=1)


def _bands(mesh, rays, shown, finest, known):
    """All `_Crossings`, the sides on which a third wall lies between those of their ends, and its middle: of shape (m, 3).

    Such a band, narrower than the facets, is what sees the rim of a hole far behind. Cut there, each side has two lines.
    """
    shown = shown._replace(found=_united(mesh, shown))
    jumps = _jumps_between(mesh, shown.found)
    crossings, crossing = _all_crossings(mesh, rays, shown, jumps, finest, known)
    width = np.append(crossings.after - crossings.before, 0.0)[crossing]
    middle = np.append(0.5 * (crossings.before + crossings.after), 0.5)[crossing]
    return crossings, jumps & (width * side_lengths(shown.points, shown.facets) > 2.0 * SMOOTH * finest), middle


def _is_one_line(mesh, found, jumps):
    """Whether at most one line from side to side explains what each facet sees: ndarray of shape (m,), bool."""
    fits, like_some = jumps.sum(axis=1) < 3, np.zeros(len(jumps), dtype=bool)
    for side in range(3):
        start, end = found.at_corner(side), found.at_corner((side + 1) % 3)
        at_middle = found.side[:, side], found.opposite_of_side[:, side]
        off_start, off_end = differ(mesh, at_middle, start), differ(mesh, at_middle, end)
        fits &= np.where(jumps[:, side], ~(off_start & off_end), ~(off_start | off_end))
        like_some |= ~differ(mesh, (found.centre, found.opposite_of_centre), start)
    return fits & like_some


def _is_uneven(found, jumps):
    """Whether the thickness is far from linear on a facet, or on either side of a jump: ndarray of shape (m,), bool."""
    ahead = np.roll(found.corner, -1, axis=1)
    with np.errstate(invalid="ignore", divide="ignore"):
        bent = np.abs(found.side - 0.5 * (found.corner + ahead)) > UNEVEN * found.side
        slope = np.fmin(np.abs(found.side / found.corner - 1.0), np.abs(found.side / ahead - 1.0))
        middle = np.abs(found.centre - found.corner.mean(axis=1)) > UNEVEN * found.centre
    # A middle that is far from both ends sees a third wall: that is no slope, and other lines go through the facet.
    steep = (slope > STEEP) & (slope < JUMP - 1.0)
    return np.where(jumps, steep, bent).any(axis=1) | (middle & ~jumps.any(axis=1))


def _cut(mesh, rays, shown, finest, known):
    """Cut the facets that have jumps on their sides."""
    points, facets, parent, found = shown
    jumps = _jumps_between(mesh, found)
    crossings, crossing = _all_crossings(mesh, rays, shown, jumps, finest, known)
    # The thickness at a crossing as seen from the corner that a side starts from, and from the one that it ends at.
    is_forward = facets <= np.roll(facets, -1, axis=1)
    both = np.append(crossings.low, np.nan), np.append(crossings.high, np.nan)
    at_start, at_end = (np.where(is_forward, here[crossing], there[crossing]) for here, there in (both, both[::-1]))
    whole = ~jumps.any(axis=1)
    sees = np.where(found.opposite_of_centre >= 0, found.opposite_of_centre, found.opposite.max(axis=1))
    pieces = [(facets[whole], parent[whole], found.corner[whole], sees[whole])]
    code, three = jumps @ np.array([1, 2, 4]), np.flatnonzero(jumps.all(axis=1))
    middle = np.full(len(facets), -1, dtype=np.int64)
    middle[three] = len(points) + len(crossings.points) + np.arange(len(three))
    for number in range(1, 8):
        own = np.flatnonzero(code == number)
        if len(own):
            pieces += _pieces(number, facets[own], len(points) + crossing[own], middle[own], parent[own], found.corner[own],
                              found.opposite[own], at_start[own], at_end[own])
    points = np.concatenate([points, crossings.points, points[facets[three]].mean(axis=1)])
    return CutFacets(points, *(np.concatenate(column) for column in zip(*pieces)))


@dataclass(frozen=True)
class _Crossings:
    """Places of jumps on sides, with the thickness at either end: of the corner with the lower number, and the higher.

    Between `before` and `after`, shares of the way from the lower to the higher, is what else is seen there, if anything.
    `side` has the numbers of both corners and of the face, of shape (n, 3).
    """

    side: np.ndarray
    before: np.ndarray
    after: np.ndarray
    points: np.ndarray
    low: np.ndarray
    high: np.ndarray

    def chosen(self, which):
        return _Crossings(*(getattr(self, each.name)[which] for each in fields(self)))

    def and_those(self, more):
        return _Crossings(*(np.concatenate([getattr(self, each.name), getattr(more, each.name)]) for each in fields(self)))


_NONE = _Crossings(np.empty((0, 3), dtype=np.int64), *(np.empty((0, 3) if number == 2 else 0) for number in range(5)))


def _all_crossings(mesh, rays, shown, jumps, finest, known):
    """The _Crossings of all sides with jumps, once for all facets of a face, and the number of each side's own: (m, 3).

    Of `known`, those of the facets before some were cut, what is needed is taken.
    """
    face, ahead = mesh.face_of_triangle[shown.parent], np.roll(shown.facets, -1, axis=1)
    sides = np.stack([np.minimum(shown.facets, ahead), np.maximum(shown.facets, ahead),
                      np.broadcast_to(face[:, None], ahead.shape)], axis=2).reshape(-1, 3)
    count, faces = len(shown.points), int(mesh.face_of_triangle.max()) + 1

    def keys(sides):
        return (sides[:, 0] * count + sides[:, 1]) * faces + sides[:, 2]

    cut = np.flatnonzero(jumps.ravel())
    needed, first, of_cut = np.unique(keys(sides[cut]), return_index=True, return_inverse=True)
    order = np.argsort(keys(known.side))
    place = np.searchsorted(keys(known.side)[order], needed)
    is_known = np.zeros(len(needed), dtype=bool)
    inside = place < len(order)
    is_known[inside] = keys(known.side)[order[place[inside]]] == needed[inside]
    new = _crossings(mesh, rays, shown, cut[first[~is_known]], finest)
    at = np.empty(len(needed), dtype=np.int64)
    at[is_known], at[~is_known] = order[place[is_known]], len(order) + np.arange(len(new.low))
    crossing = np.zeros(len(sides), dtype=np.int64)
    crossing[cut] = of_cut.ravel()
    return known.and_those(new).chosen(at), crossing.reshape(-1, 3)


def _crossings(mesh, rays, shown, side, finest):
    """Find the place of the jump on each side by bisection.

    From the lower corner, it is where its wall ends; from the higher, where its own does: where a third wall lies between,
    such as the narrow band that sees the rim of a hole, these are two places. The place is half-way then.
    """
    points, facets, parent, found = shown
    facet, number = side // 3, side % 3
    ahead = (number + 1) % 3
    swap = facets[facet, number] > facets[facet, ahead]
    low, high = np.where(swap, ahead, number), np.where(swap, number, ahead)
    ends, middles = points[facets[facet[:, None], np.column_stack([low, high])]], points[facets[facet]].mean(axis=1)
    walls = [(found.corner[facet, at], found.opposite[facet, at]) for at in (low, high)]
    sides = _Sides(ends, middles, parent[facet], np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
    nothing, everything = np.zeros(len(side)), np.ones(len(side))
    before, after, near, far = _bisected(mesh, rays, sides, nothing, everything, walls[0], walls[1], finest)
    third = np.flatnonzero(differ(mesh, far, walls[1]))
    if len(third):
        # The same from the other corner, as far as the place that is known. A wall that rises steeply ends nowhere, and is
        # not one wall where it begins and ends.
        found_first = far[0][third], far[1][third]
        back, behind, own, other = _bisected(mesh, rays, sides.chosen(third), everything[third], after[third],
                                             (walls[1][0][third], walls[1][1][third]), found_first, finest)
        ends_there = differ(mesh, own, other) & ~differ(mesh, found_first, other)
        third = third[ends_there]
        after[third], far[0][third] = 0.5 * (back + behind)[ends_there], own[0][ends_there]
    place = 0.5 * (before + after)
    names = np.column_stack([facets[facet, low], facets[facet, high], mesh.face_of_triangle[parent[facet]]])
    return _Crossings(names, before, after, ends[:, 0] + place[:, None] * (ends[:, 1] - ends[:, 0]), near[0], far[0])


class _Sides(NamedTuple):
    """Sides of facets: their ends, of shape (n, 2, 3), the middles of the facets, the triangles they lie on, and lengths."""

    ends: np.ndarray
    middles: np.ndarray
    parent: np.ndarray
    length: np.ndarray

    def chosen(self, which):
        return _Sides(*(each[which] for each in self))


def _bisected(mesh, rays, sides, first, last, near, far, finest):
    """Where the wall that is seen at the first place of each side ends on the way to the last, which sees another.

    Returns the last place that sees it, the first that does not, and what they see: each as (thickness, opposite).
    """
    before, after, near, far = first.copy(), last.copy(), [each.copy() for each in near], [each.copy() for each in far]
    for _ in range(_MOST_HALVINGS):
        wide = np.flatnonzero(np.abs(after - before) * sides.length > SMOOTH * finest)
        if not len(wide):
            break
        some, share = sides.chosen(wide), 0.5 * (before + after)[wide]
        places = some.ends[:, 0] + share[:, None] * (some.ends[:, 1] - some.ends[:, 0])
        places += INSET * (some.middles - places)
        seen = seen_walls(mesh, rays, places, some.parent)
        is_far = differ(mesh, seen, (near[0][wide], near[1][wide]))
        for chosen, ends, shares in ((is_far, far, after), (~is_far, near, before)):
            rows = wide[chosen]
            ends[0][rows], ends[1][rows], shares[rows] = seen[0][chosen], seen[1][chosen], share[chosen]
    return before, after, near, far


def _pieces(code, facets, crossing, middle, parent, thickness, opposite, at_start, at_end):
    """Pieces of facets that jump on the sides of a code: list of (facets, parent, corner thickness, opposite)."""
    def piece(nodes, values, corner):
        return np.column_stack(nodes), parent, np.column_stack(values), opposite[:, corner]

    if code in (1, 2, 4):
        a = {1: 0, 2: 1, 4: 2}[code]
        b, c = (a + 1) % 3, (a + 2) % 3
        return [piece((facets[:, a], crossing[:, a], facets[:, c]), (thickness[:, a], at_start[:, a], thickness[:, c]), a),
                piece((crossing[:, a], facets[:, b], facets[:, c]), (at_end[:, a], thickness[:, b], thickness[:, c]), b)]
    if code != 7:
        # The tip is the corner between the two sides.
        a = {5: 0, 3: 1, 6: 2}[code]
        b, c = (a + 1) % 3, (a + 2) % 3
        return [piece((facets[:, a], crossing[:, a], crossing[:, c]), (thickness[:, a], at_start[:, a], at_end[:, c]), a),
                piece((crossing[:, a], facets[:, b], facets[:, c]), (at_end[:, a], thickness[:, b], thickness[:, c]), b),
                piece((crossing[:, a], facets[:, c], crossing[:, c]), (at_end[:, a], thickness[:, c], at_start[:, c]), c)]
    found = []
    for a in range(3):
        c = (a + 2) % 3
        found += [piece((facets[:, a], crossing[:, a], middle), (thickness[:, a], at_start[:, a], thickness[:, a]), a),
                  piece((facets[:, a], middle, crossing[:, c]), (thickness[:, a], thickness[:, a], at_end[:, c]), a)]
    return found
