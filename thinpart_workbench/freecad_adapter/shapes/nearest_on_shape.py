# SPDX-License-Identifier: LGPL-2.1-or-later
"""The points of a part's own geometry nearest to given points."""

import numpy as np

from ...core.analysis_settings import AnalysisSettings
from ...core.forms.nearest_on_mesh import NearestOnMesh
from ..bootstrap import load_freecad
from ..tessellating.surface_types import FREE_FORM

MOST_FREE_FORM = 96
"""Points of free-form faces that are looked at: to find the nearest point of one takes OCC milliseconds."""


class NearestOnSolid:
    """Finds the nearest points of a Part.Solid, in the coordinates of its document."""

    def __init__(self, solid):
        load_freecad()
        import Part

        # Not the solid itself, from which a point in its material is at no distance.
        self._all, self._faces, self._vertex = Part.makeCompound(solid.Faces), solid.Faces, Part.Vertex
        self._surfaces = [_surface(face) for face in self._faces]
        boxes = [face.BoundBox for face in self._faces]
        self._least = np.array([(box.XMin, box.YMin, box.ZMin) for box in boxes])
        self._most = np.array([(box.XMax, box.YMax, box.ZMax) for box in boxes])

    def quick(self, outline):
        """An `Outline` without most of its points on free-form faces."""
        is_slow = np.array([surface is None or surface.TypeId in FREE_FORM for surface in self._surfaces])
        slow = np.flatnonzero(is_slow[np.minimum(outline.face, len(is_slow) - 1)])
        if len(slow) <= MOST_FREE_FORM:
            return outline
        left_out = np.delete(slow, np.linspace(0, len(slow) - 1, MOST_FREE_FORM).astype(np.int64))
        return outline.chosen(np.delete(np.arange(outline.count), left_out))

    def on_faces(self, points, faces):
        """The point of the whole surface on which each face lies nearest to a point: ndarray of shape (k, 3), mm.

        A point stays where it is where the surface has none.

        Parameters
        ----------
        points : ndarray of shape (k, 3), mm
        faces : ndarray of shape (k,), int64
        """
        from FreeCAD import Vector

        found = np.array(points)
        for row, face in enumerate(faces):
            surface = self._surfaces[face] if face < len(self._surfaces) else None
            if surface is None:
                continue
            try:
                found[row] = surface.value(*surface.parameter(Vector(*points[row])))
            except Exception:  # where a surface has no such point; FreeCAD raises classes of its own
                continue
        return found

    def anywhere(self, points):
        """The points of the solid nearest to points: ndarray of shape (k, 3), mm. It takes long."""
        return np.array([self._nearest(point) for point in points])

    def _nearest(self, point):
        from FreeCAD import Vector

        at = Vector(*point)
        distance, pairs, _ = self._all.distToShape(self._vertex(at))
        found = pairs[0][0]
        # OCC takes an edge for the nearest where it cannot solve for the surface: surfaces of revolution, as IGES has them.
        outside = np.linalg.norm(np.maximum(np.maximum(self._least - point, point - self._most), 0.0), axis=1)
        for face in np.flatnonzero(outside < distance):
            foot = self._foot(face, at)
            if foot is not None and foot.distanceToPoint(at) < distance:
                found, distance = foot, foot.distanceToPoint(at)
        return tuple(found)

    def _foot(self, number, at):
        """The point of a face at right angles below a Vector, or None where that is not on the face."""
        face, surface = self._faces[number], self._surfaces[number]
        if surface is None:
            return None
        try:
            u, v = surface.parameter(at)
            low_u, high_u, low_v, high_v = face.ParameterRange
            u = _within(u, low_u, high_u, surface.UPeriod() if surface.isUPeriodic() else 0.0)
            v = _within(v, low_v, high_v, surface.VPeriod() if surface.isVPeriodic() else 0.0)
            return surface.value(u, v) if face.isPartOfDomain(u, v) else None
        except Exception:  # where a surface has no such point; FreeCAD raises classes of its own
            return None


class NearestOnTriangles:
    """Finds the nearest points of a part that is given as triangles, in the coordinates of its document."""

    def __init__(self, part):
        mesh, _ = part.surface_mesh(AnalysisSettings(), None)
        self._nearest, self._origin = NearestOnMesh(mesh), mesh.origin

    def quick(self, outline):
        """The `Outline` as it is."""
        return outline

    def on_faces(self, points, _faces):
        """The points of all triangles nearest to points."""
        return self.anywhere(points)

    def anywhere(self, points):
        """The points of the triangles nearest to points: ndarray of shape (k, 3), mm."""
        return self._nearest.nearest(points - self._origin) + self._origin


def _within(value, low, high, period):
    """A parameter moved by whole periods to where the face has it."""
    if period > 0.0 and not low <= value <= high:
        value += period * np.ceil((low - value) / period)
    return float(value)


def _surface(face):
    try:
        return face.Surface
    except (TypeError, RuntimeError):  # it has no Python class; the exception differs between versions of FreeCAD
        return None
