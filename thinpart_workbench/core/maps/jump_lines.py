# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets cut along the lines at which the thickness jumps, with a value at each corner of each piece."""

from dataclasses import dataclass
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
    finest = LINE * mesh.extent
    found, new = None, np.arange(len(facets))
    for step in range(ROUNDS + 1):
        measured = _measured(mesh, rays, points, facets[new], parent[new],
                             portion(report, step / (ROUNDS + 2), (step + 1) / (ROUNDS + 2)))
        found = measured if found is None else _Seen(*(
            np.concatenate([old, added]) for old, added in zip(found, measured)))
        jumps = _jumps_between(mesh, found)
        # A line that is bent within its facet gets a corner there.
        halve = ~_is_one_line(mesh, found, jumps) | _is_uneven(found, jumps) | (jumps.any(axis=1) & (step == 0))
        sides = halve[:, None] & (side_lengths(points, facets) > 4.0 * finest)
        if step == ROUNDS or not sides.any():
            break
        room = (MOST_FACETS - len(facets)) // 2  # a side that is cut divides the facets on both sides of it
        if sides.sum() > room:
            # The longest first.
            longest = np.sort(side_lengths(points, facets)[sides])[::-1]
            sides &= side_lengths(points, facets) > longest[max(room, 0)]
            if not sides.any():
                break
        points, facets, pieces = cut_sides(points, facets, sides)
        parent = parent[pieces]
        # Facets that stayed whole come first.
        whole = np.count_nonzero(np.bincount(pieces)[pieces] == 1)
        found, new = _Seen(*(values[pieces[:whole]] for values in found)), np.arange(whole, len(facets))
    cut = _cut(mesh, rays, points, facets, parent, _united(mesh, facets, parent, found), finest)
    report_progress(report, 1.0)
    return cut


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


def _united(mesh, facets, parent, found):
    """The same, where all facets of a face that share a corner see the same there: so they agree on which sides jump."""
    faces = int(mesh.face_of_triangle.max()) + 1
    _, first, back = np.unique(_corner_keys(facets, mesh.face_of_triangle[parent], faces), return_index=True,
                               return_inverse=True)
    back = back.reshape(-1, 3)
    return found._replace(corner=found.corner.ravel()[first][back], opposite=found.opposite.ravel()[first][back])


def _jumps_between(mesh, found):
    """Whether the thickness jumps along each side: ndarray of shape (m, 3), bool."""
    return np.stack([differ(mesh, found.at_corner(side), found.at_corner((side + 1) % 3)) for side in range(3)], axis=1)


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


def _cut(mesh, rays, points, facets, parent, found, finest):
    """Cut the facets that have jumps on their sides."""
    jumps = _jumps_between(mesh, found)
    face, faces = mesh.face_of_triangle[parent], int(mesh.face_of_triangle.max()) + 1
    keys = (side_keys(facets, len(points)) * faces + face[:, None]).ravel()
    cut = np.flatnonzero(jumps.ravel())
    _, first, of_cut = np.unique(keys[cut], return_index=True, return_inverse=True)
    crossings = _crossings(mesh, rays, points, facets, parent, found, cut[first], finest)
    crossing = np.zeros(len(keys), dtype=np.int64)
    crossing[cut] = of_cut.ravel()
    crossing = crossing.reshape(-1, 3)
    # The thickness at a crossing as seen from the corner that a side starts from, and from the one that it ends at.
    is_forward = facets <= np.roll(facets, -1, axis=1)
    known = np.append(crossings.low, np.nan), np.append(crossings.high, np.nan)
    at_start, at_end = (np.where(is_forward, here[crossing], there[crossing]) for here, there in (known, known[::-1]))
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
    """Places of jumps on sides, with the thickness at either end: of the corner with the lower number, and the higher."""

    points: np.ndarray
    low: np.ndarray
    high: np.ndarray


def _crossings(mesh, rays, points, facets, parent, found, side, finest):
    """Find the place of the jump on each side by bisection."""
    facet, number = side // 3, side % 3
    ahead = (number + 1) % 3
    swap = facets[facet, number] > facets[facet, ahead]
    low, high = np.where(swap, ahead, number), np.where(swap, number, ahead)
    start, end, middles = points[facets[facet, low]], points[facets[facet, high]], points[facets[facet]].mean(axis=1)
    near, far = ([found.corner[facet, at], found.opposite[facet, at]] for at in (low, high))
    before, after, length = np.zeros(len(side)), np.ones(len(side)), np.linalg.norm(end - start, axis=1)
    for _ in range(_MOST_HALVINGS):
        wide = np.flatnonzero((after - before) * length > SMOOTH * finest)
        if not len(wide):
            break
        share = 0.5 * (before + after)[wide]
        places = start[wide] + share[:, None] * (end - start)[wide]
        places += INSET * (middles[wide] - places)
        seen = seen_walls(mesh, rays, places, parent[facet[wide]])
        is_far = differ(mesh, seen, (near[0][wide], near[1][wide]))
        for chosen, ends, shares in ((is_far, far, after), (~is_far, near, before)):
            rows = wide[chosen]
            ends[0][rows], ends[1][rows], shares[rows] = seen[0][chosen], seen[1][chosen], share[chosen]
    return _Crossings(start + (0.5 * (before + after))[:, None] * (end - start), near[0], far[0])


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
