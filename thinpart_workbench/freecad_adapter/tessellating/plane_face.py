# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles of a planar face between given nodes of its edges."""

import numpy as np
from scipy.spatial import cKDTree

_TOLERANCE = 1e-6
"""Share of a face's size that is neglected."""


class NotMapped(Exception):
    """A face is not planar and does not have four sides along its parameters, or its loops enclose no triangles."""


class PlaneFace:
    """A planar face: the polygon of its edges' nodes, without further points."""

    opposite = ()

    def __init__(self, face, edges):
        self._normal = _outward(face)
        self._wires = [
            [(edges.number(edge), edge.Orientation != "Reversed") for edge in wire.OrderedEdges]
            for wire in face.Wires
        ]

    def triangle_count(self, pieces):
        return sum(pieces[edge] for wire in self._wires for edge, _ in wire)

    def surface(self, nodes):
        """Points and triangles, given the nodes of all edges."""
        import FreeCAD
        import Part

        loops = [_loop([nodes[edge] if forward else nodes[edge][::-1] for edge, forward in wire])
                 for wire in self._wires]
        points = np.concatenate(loops)
        # Flatten the polygon and centre it: nodes of a spline lie off the plane by its tolerance.
        origin = points.mean(axis=0)
        flat = points - origin
        flat -= np.outer(flat @ self._normal, self._normal)
        polygons, start = [], 0
        for loop in loops:
            corners = [FreeCAD.Vector(*corner) for corner in flat[start:start + len(loop)].tolist()]
            polygons.append(Part.makePolygon([*corners, corners[0]]))
            start += len(loop)
        try:
            found, triangles = Part.Face(polygons).tessellate(float(np.ptp(flat, axis=0).max()))
        except Exception:  # FreeCAD raises its own classes, which differ between versions
            raise NotMapped from None
        if not triangles:
            raise NotMapped  # loops of too few nodes cross each other
        size = float(np.ptp(flat, axis=0).max())
        distance, which = cKDTree(flat).query(np.array([tuple(point) for point in found]))
        if distance.max() > _TOLERANCE * size:
            raise NotMapped
        triangles = which[np.array(triangles)]
        corners = flat[triangles]
        up = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) @ self._normal
        triangles[up < 0.0] = triangles[up < 0.0, ::-1]
        return points, triangles


def _loop(parts):
    """Distinct nodes of a wire with consecutive edges, ndarray of shape (k, 3), mm."""
    return np.concatenate([part[:-1] for part in parts])


def _outward(face):
    low_u, high_u, low_v, high_v = face.ParameterRange
    return np.array(tuple(face.normalAt(0.5 * (low_u + high_u), 0.5 * (low_v + high_v))))
