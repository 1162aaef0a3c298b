# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a map colours as too thick is what the check of the part says, by the largest balls inside."""

from dataclasses import replace

import made_library
import made_meshes
import numpy as np
import pytest
from test_equal_features import comb, perforated

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.limit_bands import too_thick as thick_places
from thinpart_workbench.core.judging.wall_check import check_walls
from thinpart_workbench.core.judging.wall_limits import WallLimits
from thinpart_workbench.core.maps.map_summary import share_of
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.storage.map_file import read_maps, write_maps

PLATE_BESIDE_BLOCK = made_meshes.joined(
    made_meshes.box(40, 40, 40), made_meshes.moved(made_meshes.box(40, 30, 2), shift=(100.0, 0.0, 0.0)))
SHAPES = {"plate": made_meshes.box(100, 80, 2), "beside": PLATE_BESIDE_BLOCK, "ribbed": made_meshes.ribbed_block(),
          "comb": comb(), "perforated": perforated()}


def mapped(name):
    shape = SHAPES[name]
    shown = thickness_map(measure(surface_mesh(*shape), AnalysisSettings()), has_balls=True)
    return MappedPart(made_library.measured_record(name, shape), shown)


@pytest.fixture(scope="module")
def parts():
    return {name: mapped(name) for name in SHAPES}


def too_thick(part, process):
    return thick_places(check_walls(part.record, process), part.map.balls, part.map.face)


def limits(most):
    return WallLimits("test", "Test", None, most)


def test_the_rims_of_a_plate_are_not_too_thick_though_rays_run_along_them(parts):
    part = parts["plate"]
    assert (part.map.thickness > 50.0).any()
    assert not too_thick(part, limits(3.0)).any()
    assert share_of([part], [too_thick(part, limits(1.5))]) > 0.95


@pytest.mark.parametrize("most", [1.0, 1.4, 1.9, 2.5, 3.0, 5.0, 8.0, 12.0, 25.0, 39.0, 45.0])
@pytest.mark.parametrize("name", SHAPES)
def test_there_is_some_where_the_check_fails_and_as_much_as_it_says(parts, name, most):
    part = parts[name]
    check, found = check_walls(part.record, limits(most)), too_thick(part, limits(most))
    assert check.thick_holds is not None and found.any() == (not check.thick_holds)
    if not check.thick_holds:
        assert share_of([part], [found]) == pytest.approx(check.thick_share, abs=0.05)
        faces = {f"Face{face + 1}" for face in np.unique(part.map.face[found])}
        assert set(check.thick_faces) <= faces


def test_of_a_plate_and_a_block_the_block_is_too_thick(parts):
    part = parts["beside"]
    found = too_thick(part, limits(10.0))
    is_block = part.map.corners.mean(axis=1)[:, 0] + part.map.origin[0] < 50.0
    assert not found[~is_block].any()
    # Balls do not reach into the very corners.
    assert part.map.areas[found].sum() > 0.99 * part.map.areas[is_block].sum()


def test_a_face_with_a_greatest_wall_of_its_own_is_compared_with_that(parts):
    part = parts["beside"]
    block = part.record["faces"][int(part.map.face[too_thick(part, limits(10.0))][0])]
    limit = {"face": block["face"], "reason": "a foot", "area_mm2": block["area_mm2"], "surface": block.get("surface")}
    allowed = replace(part, record={**part.record, "face_limits": [{**limit, "max_mm": 50.0}]})
    number = int(block["face"][4:]) - 1
    assert check_walls(allowed.record, limits(10.0)).own[0].holds
    assert not (too_thick(allowed, limits(10.0)) & (part.map.face == number)).any()
    forbidden = replace(part, record={**part.record, "face_limits": [{**limit, "max_mm": 20.0}]})
    assert check_walls(forbidden.record, limits(60.0)).holds is False
    found = too_thick(forbidden, limits(60.0))
    own = part.map.face == number
    assert not found[~own].any() and part.map.areas[found].sum() > 0.95 * part.map.areas[own].sum()


def test_balls_are_kept_in_the_file_of_a_map(parts, tmp_path):
    file = str(tmp_path / "map.npz")
    write_maps(file, [parts["beside"], replace(parts["plate"], map=replace(parts["plate"].map, balls=None))])
    beside, plate = read_maps(file)
    assert (beside.map.balls == parts["beside"].map.balls).all() and plate.map.balls is None
