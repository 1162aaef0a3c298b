# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cuts across walls along smooth edges, where one mid-surface goes over into another without a fold."""

import math

import numpy as np

from ..shapes.same_shapes import same_shapes

SMOOTH = math.cos(math.radians(5.0))
"""Cosine of the greatest angle between two faces that meet smoothly."""


def smooth_cuts(shape, walls):
    """Faces across the walls along the smooth edges between two of them: list of Part.Face for each wall."""
    faces = shape.Faces
    edges = edges_between(faces)
    opposite = {}
    for number, wall in enumerate(walls):
        for pair in wall.pairs:
            for one, other in (pair.faces, pair.faces[::-1]):
                opposite.setdefault((number, one), set()).add(other)
    cuts = [[] for _ in walls]
    walls_of = {}
    for number, wall in enumerate(walls):
        for face in wall.faces:
            walls_of.setdefault(face, []).append(number)
    for (one, other), shared in edges.items():
        for first in walls_of.get(one, ()):
            for second in walls_of.get(other, ()):
                if first == second:
                    continue
                for edge in shared:
                    normal = _smooth_normal(edge, faces[one], faces[other])
                    if normal is None:
                        continue
                    partners = [partner for a in opposite[first, one] for b in opposite[second, other]
                                for partner in edges.get((min(a, b), max(a, b)), ())]
                    thickness = max(walls[first].thickness, walls[second].thickness)
                    cut = _cut(edge, partners, normal, thickness)
                    if cut is not None:
                        cuts[first].append(cut)
                        cuts[second].append(cut)
    return cuts


def edges_between(faces):
    """Edges by the two faces that they lie between, the lower first."""
    edges = [(edge, number) for number, face in enumerate(faces) for edge in face.Edges]
    owners = {}
    for edge, own in zip(same_shapes(edge for edge, _ in edges), edges):
        owners.setdefault(edge, []).append(own)
    found = {}
    for (edge, first), *others in owners.values():
        if len(others) == 1 and others[0][1] != first:
            found.setdefault((first, others[0][1]), []).append(edge)
    return found


def _smooth_normal(edge, first, second):
    """The outward normal in the middle of an edge, where both faces have the same; else None."""
    if edge.Degenerated:
        return None
    point = edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter))
    normals = [np.array(face.normalAt(*face.Surface.parameter(point))) for face in (first, second)]
    return normals[0] if normals[0] @ normals[1] > SMOOTH else None


def _cut(edge, partners, normal, thickness):
    """A face across the wall, from an edge to the nearest one on the other side."""
    import FreeCAD
    import Part

    middle = np.array(edge.CenterOfMass)
    near = [(float(np.linalg.norm(np.array(each.CenterOfMass) - middle)), number) for number, each in enumerate(partners)]
    near = [each for each in near if each[0] < 3.0 * thickness]
    partner = partners[min(near)[1]] if near else None
    if edge.Curve.TypeId == "Part::GeomLine" and len(edge.Vertexes) == 2:
        start, end = (np.array(vertex.Point) for vertex in edge.Vertexes)
        way = (end - start) / np.linalg.norm(end - start)
        through = -normal * thickness if partner is None else np.array(partner.CenterOfMass) - middle
        through = through - (through @ way) * way
        low, high = -0.4 * through, 1.4 * through
        first, last = start - 2.0 * thickness * way, end + 2.0 * thickness * way
        corners = [FreeCAD.Vector(*each) for each in (first + low, last + low, last + high, first + high)]
        return Part.Face(Part.makePolygon([*corners, corners[0]]))
    if partner is None:
        return edge.extrude(FreeCAD.Vector(*(-normal * thickness)))
    ruled = Part.makeRuledSurface(edge, partner)
    return ruled.Faces[0] if ruled.Faces else None
