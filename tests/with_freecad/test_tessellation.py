# SPDX-License-Identifier: LGPL-2.1-or-later
"""From FreeCAD's mesh to arrays."""

import math

import numpy as np
import pytest

from thinpart_workbench.freecad_adapter.tessellating.tessellation import tessellate


@pytest.mark.parametrize("shift", [0.0, 1000.0])
def test_points_triangles_and_faces_are_those_of_freecads_mesh(shift):
    import FreeCAD
    import MeshPart
    import Part

    shape = Part.makeBox(30, 20, 10).cut(Part.makeCylinder(4, 10, FreeCAD.Vector(15, 10, 0)))
    shape.translate(FreeCAD.Vector(shift, -shift, 0))
    centre = shape.BoundBox.Center
    local = shape.copy(True, False)
    local.translate(centre * -1.0)
    deflection = 0.001 * shape.BoundBox.DiagonalLength
    mesh = MeshPart.meshFromShape(
        Shape=local, LinearDeflection=deflection, AngularDeflection=math.radians(12.0), Relative=False, Segments=True)
    surface = tessellate(shape, 0.001, 12.0)
    points, triangles = mesh.Topology
    assert (surface.points == [[p.x + centre.x, p.y + centre.y, p.z + centre.z] for p in points]).all()
    assert (surface.triangles == np.array(triangles)).all()
    assert mesh.countSegments() == 7
    for face in range(7):
        assert np.flatnonzero(surface.face_of_triangle == face).tolist() == sorted(mesh.getSegment(face))
