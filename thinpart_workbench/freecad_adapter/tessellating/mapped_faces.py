# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tessellate slender solids (wires, springs, rings, tubes) face by face on grids.

OCC's mesher places points freely in the parameter range of a face and then joins them. On a face that is a thousand
times as long as wide this takes minutes, makes millions of triangles, or silently leaves out three quarters of a
coil. Such faces have four sides, and a grid over their parameters, with its own steps in each direction, needs the
fewest triangles.
"""

import numpy as np

from .curve_division import CurveDivision, points_at
from .plane_face import NotMapped, PlaneFace
from .surface_types import LINE, PLANE, curve_type

MOST_FACES = 2000
"""Most faces of a solid that is examined. A solid with more is not a wire, and examining takes 1 ms per face."""

_TOLERANCE = 1e-6
"""Share of a parameter's range that is neglected."""

_FAR_LONGER = 10.0
"""Ratio of length to width from which a face belongs to a wire: along it, both sides turn alike and stay parallel."""

_ISOLINES = (0.0, 0.25, 0.5, 0.75, 1.0)
"""Shares of the width at which a face is sampled: a ring turns differently inside and outside."""


class MappedFaces:
    """A solid whose faces are all planar or have four sides. Raises NotMapped.

    Parameters
    ----------
    shape : Part.Shape
    types : list of str or None
        Its `surface_types`.

    Attributes
    ----------
    faces : list of Part.Face
    planar : ndarray of shape (f,), bool
    """

    def __init__(self, shape, types):
        self.faces = faces = shape.Faces
        if not 0 < len(faces) <= MOST_FACES or None in types:
            raise NotMapped
        self.planar = np.array([kind == PLANE for kind in types])
        # Most solids have a round face with a hole or a third side. It is found before any curve is looked at.
        if any(len(face.Wires) != 1 for face, plane in zip(faces, self.planar) if not plane):
            raise NotMapped
        self._edges = _Edges(shape)
        grids = {number: _GridFace(face, self._edges)
                 for number, (face, plane) in enumerate(zip(faces, self.planar)) if not plane}
        for grid in grids.values():
            grid.measure_sides()
        self._faces = [grids.get(number) or PlaneFace(face, self._edges) for number, face in enumerate(faces)]
        in_grids = {edge for grid in grids.values() for first, second, *_ in grid.opposite for edge in (first, second)}
        # An edge between two faces of one plane may be curved.
        self._flat_curves = [None if edge in in_grids else self._edges.curve_division(edge)
                             for edge in range(self._edges.count)]

    def divided(self, deflection, angle, angle_along):
        """Division of every edge, so that neighbours and opposite sides agree.

        Returns `pieces` (list of int; number of pieces of each edge) and `triangles` (int; estimated number of triangles).

        Parameters
        ----------
        deflection : float, mm
        angle, angle_along : float, radians
            Allowed turn between facets; `angle_along` applies along faces that are far longer than wide.
        """
        group = list(range(self._edges.count))

        def root(edge):
            while group[edge] != edge:
                edge = group[edge]
            return edge

        needed = [curve.pieces(deflection, angle) if curve else 1 for curve in self._flat_curves]
        for face in self._faces:
            for first, second, isolines, lengthwise in face.opposite:
                limit = angle_along if lengthwise else angle
                needed[first] = max(needed[first], *(curve.pieces(deflection, limit) for curve in isolines))
                group[root(first)] = root(second)
        most = [0] * len(needed)
        for edge, pieces in enumerate(needed):
            most[root(edge)] = max(most[root(edge)], pieces)
        pieces = [most[root(edge)] for edge in range(len(needed))]
        # A face whose sides are all closed would fold flat with fewer than three pieces.
        pieces = [max(count, 3) if self._edges.closed[edge] else count for edge, count in enumerate(pieces)]
        return pieces, sum(face.triangle_count(pieces) for face in self._faces)

    def surface(self, pieces):
        """Points, triangles and the face of each triangle for a division of the edges; raises NotMapped.

        Returns `points` (ndarray of shape (v, 3), mm), `triangles` (ndarray of shape (n, 3), int64) and `face_of_triangle`
        (ndarray of shape (n,), int64).
        """
        nodes = [self._edges.nodes(edge, count) for edge, count in enumerate(pieces)]
        parts = [face.surface(nodes) for face in self._faces]
        starts = np.cumsum([0] + [len(points) for points, _ in parts])
        return (
            np.concatenate([points for points, _ in parts]),
            np.concatenate([triangles + start for (_, triangles), start in zip(parts, starts)]),
            np.repeat(np.arange(len(parts)), [len(triangles) for _, triangles in parts]),
        )

    def parameters(self, number, pieces):
        """Parameters of the grid on a face that is no plane, list of (u, v)."""
        first, second = self._faces[number].parameters(pieces)
        columns = second.tolist()
        return [(u, v) for u in first.tolist() for v in columns]


class _Edges:
    """The distinct edges of a solid, whose ends are moved onto the solid's corners."""

    def __init__(self, shape):
        self._edges = shape.Edges
        self._numbers = {}
        for number, edge in enumerate(self._edges):
            self._numbers.setdefault(edge.hashCode(), []).append(number)
        self._corners = np.array([tuple(vertex.Point) for vertex in shape.Vertexes])
        self.closed = [edge.isClosed() for edge in self._edges]

    @property
    def count(self):
        return len(self._edges)

    def number(self, edge):
        for number in self._numbers.get(edge.hashCode(), ()):
            if self._edges[number].isSame(edge):
                return number
        raise NotMapped

    def curve_division(self, number):
        """The CurveDivision of an edge, None where it is straight."""
        edge = self._edges[number]
        if edge.Degenerated or curve_type(edge) == LINE:
            return None
        return CurveDivision(edge.valueAt, *edge.ParameterRange, edge.Length)

    def nodes(self, number, pieces):
        """Points that divide an edge, in the order of its parameter, ndarray of shape (pieces + 1, 3), mm."""
        edge = self._edges[number]
        points = points_at(edge.valueAt, np.linspace(*edge.ParameterRange, pieces + 1))
        # Edges meet their corners only within a tolerance, but the triangles have to close.
        for end in (0, -1):
            away = np.linalg.norm(self._corners - points[end], axis=1)
            points[end] = self._corners[away.argmin()]
        return points


class _GridFace:
    """A face whose sides are isolines of its parameters.

    Attributes
    ----------
    opposite : list of (int, int, list of CurveDivision, bool)
        Two opposite edges, which are divided alike, the isolines between them, and whether the face is far longer
        in their direction than across. It is known after `measure_sides`.
    """

    def __init__(self, face, edges):
        self._surface, self._reversed = face.Surface, face.Orientation == "Reversed"
        lines = [self._line(face, edge, edges) for edge in face.Wires[0].Edges]
        ends = np.array([end for _, _, *both in lines for end in both])
        self._low, self._high = ends.min(axis=0), ends.max(axis=0)
        self._range = self._high - self._low
        if not (self._range > 0.0).all():
            raise NotMapped
        self._sides = self._four_sides(lines)
        for first, second in self._sides:
            if len(first) != len(second):
                raise NotMapped
            for one, other in zip(first, second):
                if abs(one[0] - other[0]) > _TOLERANCE or abs(one[1] - other[1]) > _TOLERANCE:
                    raise NotMapped
        self.opposite = []

    def measure_sides(self):
        """Look at the curves along both parameters, which takes far longer than everything before."""
        lengths = [max(curve.length for curve in self._isolines(along, 0.0, 1.0)) for along in (0, 1)]
        for along in (0, 1):
            lengthwise = lengths[along] > _FAR_LONGER * lengths[1 - along]
            for one, other in zip(*self._sides[along]):
                self.opposite.append((one[2], other[2], self._isolines(along, one[0], one[1]), lengthwise))

    @staticmethod
    def _line(face, edge, edges):
        """Number of an edge, whether it is a seam, and its two ends in the parameters of the face."""
        if edge.Degenerated:
            raise NotMapped
        of_face = face.curveOnSurface(edge)
        if of_face is None:  # a damaged shape
            raise NotMapped
        curve, first, last = of_face
        start, middle, end = (np.array([point.x, point.y]) for point in (
            curve.value(first), curve.value(0.5 * (first + last)), curve.value(last)))
        if np.abs(start + end - 2.0 * middle).max() > _TOLERANCE * np.abs(end - start).max():
            raise NotMapped
        return edges.number(edge), edge.isSeam(face), start, end

    def _four_sides(self, lines):
        """The two sides along each parameter: pieces as (from, to, edge, forward), in shares of the range."""
        sides = [[[], []], [[], []]]
        for edge, seam, start, end in lines:
            start, end = (start - self._low) / self._range, (end - self._low) / self._range
            across = int(np.abs(end - start).argmin())
            along = 1 - across
            if abs(end[across] - start[across]) > _TOLERANCE:
                raise NotMapped
            forward = bool(end[along] > start[along])
            low, high = sorted((float(start[along]), float(end[along])))
            piece = (low, high, edge, forward)
            if seam:
                sides[along][0].append(piece)
                sides[along][1].append(piece)
            elif abs(start[across]) <= _TOLERANCE or abs(start[across] - 1.0) <= _TOLERANCE:
                sides[along][int(start[across] > 0.5)].append(piece)
            else:
                raise NotMapped
        for side in (side for both in sides for side in both):
            side.sort()
            breaks = [0.0] + [piece[1] for piece in side]
            reached = all(abs(piece[0] - at) <= _TOLERANCE for piece, at in zip(side, breaks))
            if not side or not reached or abs(breaks[-1] - 1.0) > _TOLERANCE:
                raise NotMapped
        return sides

    def _isolines(self, along, low, high):
        """CurveDivision of the isolines along one parameter, between two shares of its range."""
        first, last = (self._low[along] + share * self._range[along] for share in (low, high))
        lines = []
        for share in _ISOLINES:
            at = self._low[1 - along] + share * self._range[1 - along]
            curve = self._surface.vIso(at) if along == 0 else self._surface.uIso(at)
            lines.append(CurveDivision(curve.value, first, last, curve.length(first, last)))
        return lines

    def triangle_count(self, pieces):
        counts = [sum(pieces[piece[2]] for piece in self._sides[along][0]) for along in (0, 1)]
        return 2 * counts[0] * counts[1]

    def surface(self, nodes):
        """Points and triangles, given the nodes of all edges."""
        first, second = self.parameters([len(points) - 1 for points in nodes])
        value, columns = self._surface.value, second.tolist()
        points = np.array([tuple(value(u, v)) for u in first.tolist() for v in columns])
        points = points.reshape(len(first), len(second), 3)
        for end in (0, -1):
            points[:, end] = self._side(0, end, nodes)
            points[end] = self._side(1, end, nodes)
        corner = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
        a, b, c, d = (corners.ravel() for corners in (
            corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]))
        triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
        return points.reshape(-1, 3), triangles[:, ::-1] if self._reversed else triangles

    def parameters(self, pieces):
        """The two ndarrays of parameters between which the grid lies, given the number of pieces of all edges."""
        return [self._low[along] + self._steps(along, pieces) * self._range[along] for along in (0, 1)]

    def _steps(self, along, pieces):
        """Positions at which a side is divided, as shares of its range."""
        steps = [np.linspace(low, high, pieces[edge] + 1)[:-1]
                 for low, high, edge, _ in self._sides[along][0]]
        return np.concatenate([*steps, [1.0]])

    def _side(self, along, end, nodes):
        parts = [nodes[edge] if forward else nodes[edge][::-1]
                 for _, _, edge, forward in self._sides[along][end]]
        return np.concatenate([*(part[:-1] for part in parts), parts[-1][-1:]])
