# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nearest point of a part's own geometry."""

import numpy as np
import pytest

from thinpart_workbench.freecad_adapter.reading.shape_parts import solids_of
from thinpart_workbench.freecad_adapter.shapes.nearest_on_shape import NearestOnSolid


def points_on(faces, each=6):
    """Points within faces: ndarray of shape (k, 3), mm."""
    found = []
    for face in faces:
        low_u, high_u, low_v, high_v = face.ParameterRange
        found += [tuple(face.Surface.value(u, v)) for u in np.linspace(low_u, high_u, each + 2)[1:-1]
                  for v in np.linspace(low_v, high_v, each + 2)[1:-1] if face.isPartOfDomain(u, v)]
    return np.array(found)


def test_points_beside_and_on_a_solid():
    import Part

    nearest = NearestOnSolid(Part.makeCylinder(5, 20).cut(Part.makeCylinder(2, 20)))
    found = nearest.anywhere(np.array([[9.0, 0.0, 10.0], [0.0, 0.5, 10.0], [0.0, 3.0, 25.0], [0.0, -5.0, 4.0]]))
    np.testing.assert_allclose(found, [[5.0, 0.0, 10.0], [0.0, 2.0, 10.0], [0.0, 3.0, 20.0], [0.0, -5.0, 4.0]], atol=1e-6)


@pytest.mark.timeout(180)  # tens of thousands of distances
def test_points_of_a_part_are_on_its_copy_in_iges(training_parts, tmp_path):
    """For some of them, OCC's own search takes an edge of a surface of revolution for the nearest."""
    import FreeCAD
    import Part

    part = Part.read(str(training_parts / "parts" / "t052_C04H030044-rear-metal-sheet.stp"))
    matrix = FreeCAD.Matrix()
    for turn, angle in ((matrix.rotateX, 0.3), (matrix.rotateY, -1.1), (matrix.rotateZ, 0.7)):
        turn(angle)
    part = part.transformed(matrix, True)
    part.exportIges(str(tmp_path / "turned.iges"))
    (copy,), _ = solids_of(Part.read(str(tmp_path / "turned.iges")))
    points = points_on([face for face in part.Faces if isinstance(face.Surface, Part.Cylinder)], each=6)
    away = np.linalg.norm(NearestOnSolid(copy).anywhere(points) - points, axis=1)
    assert len(points) > 300 and away.max() < 1e-3
