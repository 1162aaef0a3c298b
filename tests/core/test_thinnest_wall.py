# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest wall has an extent."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.walls.face_thickness import face_thicknesses


def measured(*parts):
    vertices, triangles = [], []
    for points, own in parts:
        triangles.append(np.asarray(own) + sum(map(len, vertices)))
        vertices.append(np.asarray(points, float))
    return measure(surface_mesh(np.concatenate(vertices), np.concatenate(triangles)), AnalysisSettings())


def box_at(place, *size):
    points, triangles = made_meshes.box(*size)
    return np.asarray(points) + np.asarray(place, float), triangles


def test_a_plate():
    found = measured(made_meshes.box(100.0, 80.0, 2.0))
    assert found.thinnest_mm == pytest.approx(2.0, rel=1e-9)
    wall = found.thinnest_wall
    assert np.linalg.norm(wall.point - wall.opposite) == pytest.approx(2.0, rel=1e-9)


def test_a_wall_that_covers_less_than_the_floor_is_none():
    # Of 60,000 mm2, the flake has 0.5 on each side, and the small plate 200.
    block = made_meshes.box(100.0, 100.0, 100.0)
    flake, plate = box_at((300, 0, 0), 0.7, 0.7, 0.001), box_at((400, 0, 0), 10.0, 10.0, 0.5)
    assert measured(block, flake).thinnest_mm == pytest.approx(100.0, rel=1e-9)
    assert measured(block, flake, plate).thinnest_mm == pytest.approx(0.5, rel=1e-9)


def test_no_face_is_thinner_than_the_part():
    found = measured(made_meshes.box(100.0, 80.0, 2.0), box_at((200, 0, 0), 20.0, 20.0, 5.0))
    faces = face_thicknesses(found.field, 1.0, found.thinnest_wall)
    assert min(each.minimum for each in faces if each.minimum is not None) == found.thinnest_mm
