# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure triangles with numpy and scipy alone."""

from ..core.analysis_settings import AnalysisSettings
from ..core.mesh.surface_mesh import surface_mesh
from ..core.thickness import measurement
from .mesh_arrays import checked_arrays


def measure(vertices, triangles, settings=None, face_of_triangle=None, report=None):
    """Measure the walls, box, volume and area of a part given as triangles: Measurement. FreeCAD is not needed.

    Parameters
    ----------
    vertices : array_like of shape (v, 3), mm
    triangles : array_like of shape (n, 3), int
        Indices into `vertices`, counter-clockwise as seen from outside.
    settings : AnalysisSettings, optional
    face_of_triangle : array_like of shape (n,), int, optional
        The face that each triangle belongs to, from 0; by default faces are smooth patches of the surface.
    report : callable, optional
        Called with the fraction done; may raise `Cancelled` to stop.

    Raises
    ------
    MeshError
        kind ``usage`` for wrong shapes or types, ``empty``, ``not_finite``, ``unreadable`` if triangles refer to
        missing points, ``zero_volume``; the message is one sentence.

    Notes
    -----
    The mesh is taken as exact: the distance of its facets from the original surface is not known here.

    Examples
    --------
    >>> measured = measure(vertices, triangles)
    >>> measured.thinnest_mm, measured.box_mm
    (2.0, (80.0, 60.0, 2.0))
    """
    mesh = surface_mesh(*checked_arrays(vertices, triangles, face_of_triangle))
    return measurement.measure(mesh, settings or AnalysisSettings(), report)
