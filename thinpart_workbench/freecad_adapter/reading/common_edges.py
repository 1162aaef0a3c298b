# SPDX-License-Identifier: LGPL-2.1-or-later
"""Give faces that meet the same edges where OCC's sewing does not: along whole circles, and where one edge meets several.

IGES files that FreeCAD writes are full of both: the round border of a plane is a circle there, that of the cylinder beside
it a spline that starts at the same point.
"""

from collections import Counter, defaultdict
from contextlib import suppress

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

_SAME_LENGTH = 0.01
"""Edges that follow each other all along have the same length, within this share of it."""

_SAME_AREA = 1e-3
"""A face keeps its area, within this share of it, when it gets its neighbour's edges."""

_PLACE = 0.43
"""Where on an edge it is looked whether it follows another: not in the middle, where edges of half that length may end."""


def has_free_edges(shape):
    """Whether an edge of a Part.Shape belongs to one face only."""
    return bool(_free_edges(shape.Faces))


def with_common_edges(shape, gap):
    """The faces of a shape, in which free edges of two faces that follow each other are replaced by those of one.

    Returns a Part.Compound, or None where there is nothing to replace.

    Parameters
    ----------
    shape : Part.Shape
    gap : float
        Distance of edges that follow each other, in mm.
    """
    import Part

    faces = list(shape.Faces)
    changes = defaultdict(list)
    for sides in _courses(_free_edges(faces), gap):
        (first, own), (second, others) = sorted(sides.items(), key=lambda side: _is_plane(faces[side[0]]))
        # A plane needs no curve in its parameters, so it takes the edges of the other.
        changes[second].append((others, own))
    is_changed = False
    for index, replaced in changes.items():
        face = _with_edges(faces[index], replaced, gap)
        if face is not None:
            faces[index], is_changed = face, True
    return Part.Compound(faces) if is_changed else None


def _free_edges(faces):
    """(index of the face, Part.Edge) of every edge that belongs to one face only."""
    uses, owner = Counter(), {}
    for index, face in enumerate(faces):
        for edge in face.Edges:
            if not edge.Degenerated:
                uses[edge.hashCode()] += 2 if edge.isSeam(face) else 1
                owner[edge.hashCode()] = index, edge
    return [owner[key] for key, count in uses.items() if count == 1]


def _courses(free, gap):
    """Of every course that free edges of two faces follow all along: a dict of the edges by index of the face."""
    if not free:
        return []
    places = [_place(edge) for _, edge in free]
    owners = np.array([index for index, _ in free])
    low, high = np.transpose([_corners(edge) for _, edge in free], (1, 0, 2))
    pairs = []
    for number, place in enumerate(places):
        near = ((low - gap <= place) & (np.array(place) <= high + gap)).all(axis=1) & (owners != owners[number])
        pairs += [(number, other) for other in np.flatnonzero(near) if _distance(place, free[other][1]) <= gap]
    rows, columns = np.array(pairs, dtype=int).reshape(-1, 2).T
    _, names = connected_components(coo_matrix((np.ones(len(rows)), (rows, columns)), shape=(len(free), len(free))))
    courses = defaultdict(lambda: defaultdict(list))
    for name, (index, edge) in zip(names, free):
        courses[name][index].append(edge)
    return [sides for sides in courses.values() if len(sides) == 2 and _same_length(*sides.values())]


def _same_length(*sides):
    lengths = [sum(edge.Length for edge in edges) for edges in sides]
    return max(lengths) - min(lengths) <= _SAME_LENGTH * max(lengths)


def _place(edge):
    return edge.valueAt(edge.FirstParameter + _PLACE * (edge.LastParameter - edge.FirstParameter))


def _corners(edge):
    box = edge.BoundBox
    return (box.XMin, box.YMin, box.ZMin), (box.XMax, box.YMax, box.ZMax)


def _distance(point, edge):
    import Part

    return edge.distToShape(Part.Vertex(point))[0]


def _is_plane(face):
    # Some surfaces have no name in FreeCAD.
    with suppress(Exception):
        return type(face.Surface).__name__ == "Plane"
    return False


def _with_edges(face, replaced, gap):
    """A face whose edges are replaced: list of (edges, edges in their place); None where that gives another face."""
    import Part

    new = face
    try:
        for edges, others in replaced:
            turned = [_in_direction(edge, edges) for edge in others]
            new = new.replaceShape([(edges[0], turned[0] if len(turned) == 1 else Part.Compound(turned))])
            if len(edges) > 1:
                new = new.removeShape(edges[1:])
        new.fix(gap, gap, 10.0 * gap)
    except (Part.OCCError, RuntimeError):
        return None
    if len(new.Faces) != 1 or abs(new.Area - face.Area) > _SAME_AREA * face.Area:
        return None
    return new.Faces[0]


def _in_direction(edge, edges):
    """An edge, reversed where its curve runs against that of the one among ``edges`` that it follows."""
    place = _place(edge)
    followed = min(edges, key=lambda other: _distance(place, other))
    directions = [each.Curve.tangent(each.Curve.parameter(place))[0] for each in (edge, followed)]
    return edge if directions[0].dot(directions[1]) > 0.0 else edge.reversed()
