# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces of mid-surfaces in the joints of walls, which lie between the sides of no wall, and connect others."""

import numpy as np

from ..shapes.same_shapes import same_shapes

ON_SURFACE = 0.1
"""Distance from a mid-surface by the thickness up to which a face lies on it: facets of a round one are off a little."""

WIDEST = 3.0
"""Width of a piece by the thickness of its wall up to which it may be a bridge: a joint with rounded edges."""

_SAMPLES, _GRID = 60, 16


def spread_points(face, thickness):
    """Points spread over a face, and the area of each: ndarrays of shape (k, 3) and (k,); none where it has no area."""
    points, triangles = face.tessellate(max(0.05 * thickness, 1e-4))
    if not triangles:
        return _points_on_grid(face)
    corners = np.array([tuple(point) for point in points])[np.array(triangles)]
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    counts = np.maximum(1, np.ceil(_SAMPLES * areas / max(areas.sum(), 1e-300))).astype(int)
    row = np.repeat(np.arange(len(areas)), counts)
    step = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts) + 0.5
    # A low-discrepancy sequence, folded into the triangle.
    u, v = np.mod(0.5 + 0.754877666 * step, 1.0), np.mod(0.5 + 0.569840296 * step, 1.0)
    over = u + v > 1.0
    u[over], v[over] = 1.0 - u[over], 1.0 - v[over]
    a, b, c = corners[row].transpose(1, 0, 2)
    return a + u[:, None] * (b - a) + v[:, None] * (c - a), (areas / counts)[row]


def _points_on_grid(face):
    """The same for a face that OCC makes no triangles of: because it is a sliver, or an edge of it is shorter than its ends
    are exact."""
    low_u, high_u, low_v, high_v = face.ParameterRange
    steps = (np.arange(_GRID) + 0.5) / _GRID
    places = [(low_u + u * (high_u - low_u), low_v + v * (high_v - low_v)) for u in steps for v in steps]
    points = np.array([tuple(face.valueAt(*place)) for place in places if face.isPartOfDomain(*place)]).reshape(-1, 3)
    return points, np.full(len(points), face.Area / max(len(points), 1))


def lies_on(points, wall):
    """Whether a face lies on the mid-surface of a wall, by points spread over it."""
    return bool(len(points)) and float(np.abs(wall.shape.distances(points)).max()) <= ON_SURFACE * wall.thickness


def is_bridge(face, wall):
    """Whether a face is narrow enough for the joint of a wall."""
    return 2.0 * face.Area <= WIDEST * wall.thickness * face.Length


def bridges(faces, kept, rest):
    """Faces that connect what is apart without them: list of int.

    The smallest that do: of two ways from one piece to another, one is taken.

    Parameters
    ----------
    faces : list of Part.Face
        Those that meet share their edges.
    kept : list of int
        Numbers of the faces that are there anyhow.
    rest : list of int
        Numbers of those that may be added.
    """
    meets, found = _meets(faces, (*kept, *rest)), []
    for group in _connected(rest, meets):
        # All pieces of a joint connect most; those without which it connects as much are left out, the largest first.
        most = _apart([*kept, *found], meets) - _apart([*kept, *found, *group], meets)
        if most > 0:
            for number in sorted(group, key=lambda each: -faces[each].Area):
                fewer = [other for other in group if other != number]
                if _apart([*kept, *found], meets) - _apart([*kept, *found, *fewer], meets) >= most:
                    group = fewer
            found += group
    return found


def connected_faces(faces, numbers):
    """Groups of faces that hold together by their edges: list of list of int.

    Parameters
    ----------
    faces : list of Part.Face
    numbers : sequence of int
        Of those that are meant.
    """
    return _connected(numbers, _meets(faces, numbers))


def _meets(faces, numbers):
    """Which faces share an edge with which: dict of set."""
    edges = [(edge, number) for number in numbers for edge in faces[number].Edges]
    sharing = {}
    for edge, (_, number) in zip(same_shapes(edge for edge, _ in edges), edges):
        sharing.setdefault(edge, set()).add(number)
    meets = {number: set() for number in numbers}
    for together in sharing.values():
        for number in together:
            meets[number] |= together - {number}
    return meets


def _connected(numbers, meets):
    """Groups of numbers that meet each other, list of list."""
    left, groups = set(numbers), []
    while left:
        group = [left.pop()]
        for number in group:
            more = meets[number] & left
            left -= more
            group += sorted(more)
        groups.append(group)
    return sorted(groups, key=min)


def _apart(numbers, meets):
    """Into how many pieces faces fall."""
    return len(_connected(numbers, meets))
