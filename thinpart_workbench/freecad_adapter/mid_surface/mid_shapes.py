# SPDX-License-Identifier: LGPL-2.1-or-later
"""The surface half-way between two faces: a plane between planes, a cylinder between cylinders, and so on."""

import math
from dataclasses import dataclass

import numpy as np

from ..bootstrap import load_freecad

MOST_SPLAY = math.radians(8.0)
"""Greatest angle between the axes of two round faces with one between them."""

PARALLEL = 1e-4
"""Sine of the angle between the sides of a cone or cylinder up to which the one between them needs no measuring."""

WIDEST_PIECE = math.radians(120.0)
"""A round face is made of pieces of up to this angle, so that none has a seam."""

WHOLE = math.radians(330.0)
"""From this angle on, a round wall is taken to be closed."""


def _vector(point):
    return load_freecad().Vector(*map(float, point))


def _unit(vector):
    vector = np.asarray(vector, dtype=np.float64)
    return vector / np.linalg.norm(vector)


def _frame(axis):
    """Two directions across an axis, right-handed with it."""
    first = _unit(np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))]))
    return first, np.cross(axis, first)


@dataclass(frozen=True)
class MidPlane:
    """A plane half-way between two.

    Attributes
    ----------
    point, normal : ndarray of shape (3,), mm
    """

    point: np.ndarray
    normal: np.ndarray

    def distances(self, points):
        """Distance of points along the normal, ndarray, mm."""
        return (points - self.point) @ self.normal

    def normals(self, points):
        """Normals at points, ndarray of shape (k, 3)."""
        return np.broadcast_to(self.normal, points.shape)

    def extents(self, points):
        """Extents of points along the surface, the lesser last, mm."""
        along = _axes_of(points - self.point - np.outer(self.distances(points), self.normal))
        flat = (points - self.point) @ along[:2].T
        return tuple(sorted(np.ptp(flat, axis=0), reverse=True))

    def patches(self, points, margin):
        """A rectangle over points, and a margin wider, list of Part.Face."""
        import Part

        flat = points - np.outer(self.distances(points), self.normal)
        first = _unit(_axes_of(flat - flat.mean(axis=0))[0])
        first = _unit(first - (first @ self.normal) * self.normal)
        second = np.cross(self.normal, first)
        (low_a, low_b), (high_a, high_b) = (
            end((flat - self.point) @ np.array([first, second]).T, axis=0) for end in (np.min, np.max))
        corners = [(low_a - margin, low_b - margin), (high_a + margin, low_b - margin), (high_a + margin, high_b + margin),
                   (low_a - margin, high_b + margin)]
        wire = Part.makePolygon([_vector(self.point + a * first + b * second) for a, b in (*corners, corners[0])])
        return [Part.Face(wire)]


def _axes_of(points):
    """Directions of the greatest extents of points about the origin, rows."""
    return np.linalg.svd(points.T @ points)[2]


@dataclass(frozen=True)
class MidRound:
    """A surface of revolution half-way between two: a cylinder, a cone, a sphere or a torus.

    Attributes
    ----------
    point, axis : ndarray of shape (3,), mm
    start, along : ndarray of shape (2,), mm
        Of its profile, where that is a line: radius and height of a point on it, and its direction.
    middle, radius : ndarray of shape (2,) and float, mm
        Of its profile, where that is a circle.
    """

    point: np.ndarray
    axis: np.ndarray
    start: np.ndarray = None
    along: np.ndarray = None
    middle: np.ndarray = None
    radius: float = 0.0

    def _profile(self, points):
        """Radius and height of points about the axis, ndarray of shape (k, 2)."""
        away = points - self.point
        height = away @ self.axis
        return np.column_stack([np.linalg.norm(away - np.outer(height, self.axis), axis=1), height])

    def _angles(self, points):
        first, second = _frame(self.axis)
        away = points - self.point
        return np.arctan2(away @ second, away @ first)

    def distances(self, points):
        """Distance of points along the normal, ndarray, mm."""
        profile = self._profile(points)
        if self.middle is not None:
            return np.linalg.norm(profile - self.middle, axis=1) - self.radius
        return (profile - self.start) @ np.array([self.along[1], -self.along[0]])

    def normals(self, points):
        """Normals at points, ndarray of shape (k, 3)."""
        profile = self._profile(points)
        if self.middle is not None:
            across = profile - self.middle
            across /= np.maximum(np.linalg.norm(across, axis=1), 1e-300)[:, None]
        else:
            across = np.broadcast_to(np.array([self.along[1], -self.along[0]]), profile.shape)
        away = points - self.point
        outward = away - np.outer(away @ self.axis, self.axis)
        outward /= np.maximum(np.linalg.norm(outward, axis=1), 1e-300)[:, None]
        return across[:, :1] * outward + across[:, 1:] * self.axis

    def extents(self, points):
        """Extents of points along the surface, the lesser last, mm."""
        profile = self._profile(points)
        low, high = _arc(self._angles(points))
        if self.middle is not None:
            away = profile - self.middle
            low_v, high_v = _arc(np.arctan2(away[:, 1], away[:, 0]))
            other = (high_v - low_v) * self.radius
        else:
            other = np.ptp((profile - self.start) @ self.along)
        return tuple(sorted((float(other), float((high - low) * np.median(profile[:, 0]))), reverse=True))

    def patches(self, points, margin):
        """Pieces of the surface over points, and a margin wider, list of Part.Face."""
        import Part

        profile = self._profile(points)
        first, second = _frame(self.axis)

        def at(radius, height):
            return _vector(self.point + radius * first + height * self.axis)

        if self.middle is not None:
            away = profile - self.middle
            ends = _ends_of_pieces(np.arctan2(away[:, 1], away[:, 0]), margin / self.radius)
            edges = []
            for begin, end in zip(ends, ends[1:]):
                places = [self.middle + self.radius * np.array([math.cos(angle), math.sin(angle)])
                          for angle in (begin, 0.5 * (begin + end), end)]
                if min(place[0] for place in places) <= 0.0:
                    continue  # beyond the axis, as of a ball: the margin is not needed there
                edges.append(Part.Arc(*[at(*place) for place in places]).toShape())
        else:
            way = (profile - self.start) @ self.along
            low, high = way.min() - margin, way.max() + margin
            if self.along[0]:
                apex = -self.start[0] / self.along[0]
                low, high = (max(low, apex), high) if self.along[0] > 0.0 else (low, min(high, apex))
            edges = [Part.makeLine(at(*(self.start + low * self.along)), at(*(self.start + high * self.along)))]
        ends = np.degrees(_ends_of_pieces(self._angles(points), margin / max(float(np.median(profile[:, 0])), 1e-9)))
        centre, axis = _vector(self.point), _vector(self.axis)
        found = []
        for edge in edges:
            for begin, end in zip(ends, ends[1:]):
                turned = edge.copy()
                turned.rotate(centre, axis, float(begin))
                found += turned.revolve(centre, axis, float(end - begin)).Faces
        return found


def _arc(angles):
    """The arc that has all angles, whatever is the greatest gap between them: its ends, the first the lower."""
    angles = np.sort(np.mod(angles, 2.0 * math.pi))
    gaps = np.diff(np.append(angles, angles[0] + 2.0 * math.pi))
    widest = int(np.argmax(gaps))
    low = angles[(widest + 1) % len(angles)]
    return float(low), float(low + 2.0 * math.pi - gaps[widest])


def _ends_of_pieces(angles, beyond):
    """The angles between which an arc is divided that has all angles, and up to 60 degrees beyond them."""
    low, high = _arc(angles)
    beyond = min(beyond, math.radians(60.0))
    low, high = low - beyond, high + beyond
    if high - low >= WHOLE:
        high = low + 2.0 * math.pi
    pieces = max(1, math.ceil((high - low) / WIDEST_PIECE - 1e-9))
    return np.linspace(low, high, pieces + 1)


def mid_shape(first, second, pair):
    """The surface half-way between two faces: MidPlane or MidRound, or None where the surfaces are of other kinds.

    Parameters
    ----------
    first, second : Part.Face
    pair : FacingFaces
    """
    try:
        surfaces = first.Surface, second.Surface
    except (TypeError, RuntimeError):
        return None
    kinds = [surface.TypeId for surface in surfaces]
    if kinds == ["Part::GeomPlane"] * 2:
        return _between_planes(surfaces, pair)
    profiles = [_PROFILES[kind](surface) for kind, surface in zip(kinds, surfaces) if kind in _PROFILES]
    return _between_round(profiles, pair) if len(profiles) == 2 else None


def _between_planes(surfaces, pair):
    normals = [_unit(surface.Axis) for surface in surfaces]
    if normals[0] @ normals[1] < 0.0:
        normals[1] = -normals[1]
    normal = _unit(normals[0] + normals[1])
    return MidPlane(np.average(pair.middles, axis=0), normal)


def _cylinder(surface):
    return np.array(surface.Center), _unit(surface.Axis), ("line", np.array([surface.Radius, 0.0]), np.array([0.0, 1.0]))


def _cone(surface):
    angle = surface.SemiAngle
    return (np.array(surface.Center), _unit(surface.Axis),
            ("line", np.array([surface.Radius, 0.0]), np.array([math.sin(angle), math.cos(angle)])))


def _torus(surface):
    return (np.array(surface.Center), _unit(surface.Axis),
            ("circle", np.array([surface.MajorRadius, 0.0]), surface.MinorRadius))


def _sphere(surface):
    return np.array(surface.Center), None, ("circle", np.zeros(2), surface.Radius)


_PROFILES = {"Part::GeomCylinder": _cylinder, "Part::GeomCone": _cone, "Part::GeomToroid": _torus,
             "Part::GeomSphere": _sphere}


def _between_round(profiles, pair):
    (first_point, first_axis, first), (second_point, second_axis, second) = profiles
    if first[0] != second[0]:
        return None
    if first_axis is None or second_axis is None:
        known = [axis for axis in (first_axis, second_axis) if axis is not None]
        # Two balls have no axis: one through the middle of the wall would have it at its pole.
        away = _unit(np.average(pair.middles, axis=0) - first_point)
        axis = known[0] if known else _frame(away)[0]
        first_axis = second_axis = axis
    turned = first_axis @ second_axis < 0.0
    if turned:
        second_axis = -second_axis
    if first_axis @ second_axis < math.cos(MOST_SPLAY):
        return None
    axis, between = _unit(first_axis + second_axis), second_point - first_point
    across = between - (between @ axis) * axis
    if np.linalg.norm(across) > pair.thickness:
        return None
    if first[0] == "circle":
        height = float(between @ axis)
        middle = 0.5 * (first[1] + second[1] + np.array([0.0, height]))
        return MidRound(first_point + 0.5 * across, axis, middle=middle, radius=0.5 * (first[2] + second[2]))
    start, along = second[1], second[2]
    if turned:
        start, along = start * np.array([1.0, -1.0]), along * np.array([-1.0, 1.0])
    start = start + np.array([0.0, float(between @ axis)])
    if along @ first[2] < 0.0:
        along = -along
    point = first_point + 0.5 * across
    direction = _unit(first[2] + along)
    across = np.array([direction[1], -direction[0]])
    if abs(first[2] @ np.array([along[1], -along[0]])) < PARALLEL:
        return MidRound(point, axis, first[1] + 0.5 * ((start - first[1]) @ across) * across, direction)
    # The lines lean: the middle of the wall says where the one between them runs.
    shape = MidRound(point, axis, first[1], direction)
    return MidRound(point, axis, first[1] + np.median(shape.distances(pair.middles)) * across, direction)
