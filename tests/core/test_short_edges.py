# SPDX-License-Identifier: LGPL-2.1-or-later
"""Walls that run out into a sharp edge which is shorter than the depth beside it at which they are told."""

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


def run_out(edge, angle=8.0, long=10.0, wide=6.0):
    """A wedge whose sharp edge is short, and which gets wider along its way: measured."""
    rise = long * np.tan(np.radians(0.5 * angle))
    points = np.array([(0.0, side * 0.5 * edge, 0.0) for side in (-1, 1)]
                      + [(long, side * 0.5 * wide, way * rise) for side in (-1, 1) for way in (-1, 1)])
    hull = ConvexHull(points)
    triangles = hull.simplices.copy()
    normals = np.cross(*np.moveaxis(np.diff(points[triangles], axis=1), 1, 0))
    inwards = (normals * hull.equations[:, :3]).sum(axis=1) < 0.0
    triangles[inwards] = triangles[inwards][:, ::-1]
    return measure(surface_mesh(points, triangles), AnalysisSettings())


@pytest.mark.parametrize("edge", [0.2, 0.04])
def test_however_short_an_edge_is_its_wall_ends_in_it(edge):
    found = run_out(edge).thinnest
    assert found.kind == "edge" and found.witness.distance < 3.0 * found.depth * np.tan(np.radians(8.0))
