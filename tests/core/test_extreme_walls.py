# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest and the thickest wall of maps, and which places their parts hide."""

import numpy as np
import pytest
from made_meshes import box, moved, revolved, ribbed_block, tube

from thinpart_workbench.core.analysis_settings import RAY, SPHERE, AnalysisSettings
from thinpart_workbench.core.maps.extreme_walls import thickest_wall, thinnest_wall
from thinpart_workbench.core.maps.map_sight import MapSight
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


def _part(mesh, by=RAY, matrices=None, **record):
    shown = thickness_map(measure(surface_mesh(*mesh), AnalysisSettings()), by=by)
    return MappedPart(record, shown, [], np.eye(4)[None] if matrices is None else matrices)


def _thickest(*parts):
    return thickest_wall(list(parts), MapSight(list(parts)))


def test_the_thinnest_wall_is_that_of_the_record_and_stands_wherever_it_is():
    witness = {"distance": 6.0, "points": [[27.0, 50.0, 50.0], [33.0, 50.0, 50.0]]}
    other = {"distance": 6.001, "points": [[33.0, 50.0, 20.0], [27.0, 50.0, 20.0]]}
    thick = {"distance": 40.0, "points": [[10.0, 0.0, 50.0], [10.0, 40.0, 50.0]]}
    faces = [{"witness": each} for each in (thick, other, witness, None)]
    shifted = np.eye(4)
    shifted[:3, 3] = (200.0, 0.0, 0.0)
    wall = thinnest_wall([_part(ribbed_block(), faces=faces, matrices=np.array([np.eye(4), shifted]))])
    assert wall.value == 6.0 and wall.places.shape == (4, 2, 3)
    assert wall.places[0].tolist() == witness["points"]
    assert wall.places[2, 0].tolist() == [227.0, 50.0, 50.0]


def test_without_a_record_it_is_the_least_of_the_map():
    wall = thinnest_wall([_part(ribbed_block())])
    assert wall.value == pytest.approx(6.0, rel=1e-3)
    assert np.linalg.norm(wall.places[0, 1] - wall.places[0, 0]) == pytest.approx(6.0, rel=1e-3)


def test_a_map_of_balls_tells_the_ball_of_the_thinnest_wall():
    faces = [{"witness": {"distance": 6.0, "points": [[27.0, 50.0, 50.0], [33.0, 50.0, 50.0]]}}]
    wall = thinnest_wall([_part(ribbed_block(), by=SPHERE, faces=faces)])
    assert wall.value == pytest.approx(6.0, rel=0.02)


@pytest.mark.parametrize("mesh, value", [
    (box(100.0, 60.0, 40.0), 100.0),
    (box(100.0, 80.0, 2.0), 2.0),  # not the length seen from its rims
    (box(100.0, 8.0, 8.0), 8.0),
    (tube(20.0, 18.0, 60.0), 2.0),
    (revolved([(0.0, 0.0), (30.0, 0.0), (30.0, 60.0), (28.0, 60.0), (28.0, 5.0), (0.0, 5.0)]), 5.0)])
def test_the_thickest_wall_is_not_the_length_of_a_thin_one(mesh, value):
    assert _thickest(_part(mesh)).value == pytest.approx(value, rel=0.06)


def test_the_thickest_of_several_parts_and_of_balls():
    found = _thickest(_part(box(30.0, 30.0, 4.0)), _part(box(30.0, 30.0, 12.0)))
    assert found.value == pytest.approx(30.0, rel=1e-3)  # across a block, which is 12 high
    assert _thickest(_part(box(30.0, 30.0, 12.0), by=SPHERE)).value == pytest.approx(12.0, rel=0.02)


def test_what_the_part_hides_and_what_a_limit_spares():
    part = _part(ribbed_block())
    sight = MapSight([part])
    on_block, before_rib, behind_rib = (10.0, 40.01, 50.0), (26.0, 50.0, 50.0), (34.0, 50.0, 50.0)
    points = np.array([on_block, before_rib, behind_rib])
    inf = np.full(3, np.inf)
    towards = np.tile([-1.0, 0.0, 0.0], (3, 1))
    assert sight.are_free(points, towards, inf).tolist() == [True, True, False]
    assert sight.are_free(points, -towards, inf).tolist() == [False, False, True]
    assert sight.are_free(points, towards, np.array([np.inf, np.inf, 0.5])).all()
    assert sight.are_free(points, np.tile([0.0, 1.0, 0.0], (3, 1)), inf).all()


def test_an_occurrence_hides_another():
    away = np.eye(4)
    away[:3, 3] = (0.0, -100.0, 0.0)
    sight = MapSight([_part(box(20.0, 20.0, 20.0), matrices=np.array([np.eye(4), away]))])
    points = np.array([[10.0, -0.01, 10.0], [10.0, -0.01, 19.0]])
    towards = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
    assert sight.are_free(points, towards, np.full(2, np.inf)).tolist() == [False, True]


def test_a_part_that_is_turned_has_the_same_walls():
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    mesh = moved(box(100.0, 80.0, 2.0), turn, (5.0, 6.0, 7.0))
    assert _thickest(_part(mesh)).value == pytest.approx(2.0, rel=1e-3)
