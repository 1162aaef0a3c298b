# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets of maps beside limits: too thick by balls, and in maps of before by rays; with the limits of single faces."""

from dataclasses import replace

import made_library
import made_meshes
import numpy as np
import pytest

from thinpart_workbench.api.window.limits import checked_facets
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.wall_limits import WallLimits
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


@pytest.fixture(scope="module")
def block():
    shape = made_meshes.box(60, 50, 40)
    shown = thickness_map(measure(surface_mesh(*shape), AnalysisSettings()), has_balls=True)
    return MappedPart(made_library.measured_record("block", shape), shown)


def limits(most):
    return WallLimits("test", "Test", None, most)


def test_what_is_too_thick_is_told_by_balls_and_in_a_map_of_before_by_rays(block):
    assert not checked_facets([block], limits(45.0))[0].too_thick.any()  # the way through it is longer, to 60 mm
    assert checked_facets([block], limits(20.0))[0].too_thick.mean() > 0.9
    before = replace(block, map=replace(block.map, balls=None))
    by_rays = checked_facets([before], limits(39.0))[0].too_thick
    assert (by_rays == (block.map.thickness > 1.02 * 39.0)).all() and by_rays.any()


def test_a_limit_that_is_kept_for_a_face_counts(block):
    face = block.record["faces"][0]
    limit = {"face": face["face"], "area_mm2": face["area_mm2"], "surface": face.get("surface"), "reason": "a foot",
             "max_mm": 60.0}
    found = checked_facets([block], limits(20.0), {block.record["name"]: [limit]})[0].too_thick
    assert not found[block.map.face == int(face["face"][4:]) - 1].any() and found.any() == (len(block.record["faces"]) > 1)


def test_thicknesses_of_a_face_with_a_least_wall_of_its_own_are_compared_in_proportion(block):
    process = WallLimits("test", "Test", 80.0, None)
    alone, = checked_facets([block], process)
    assert alone.compared is block.map
    face = block.record["faces"][0]
    limit = {"face": face["face"], "area_mm2": face["area_mm2"], "surface": face.get("surface"), "reason": "a foot",
             "min_mm": 20.0}
    compared = checked_facets([block], process, {block.record["name"]: [limit]})[0].compared
    own = block.map.face == int(face["face"][4:]) - 1
    across = own | own[block.map.opposite] & (block.map.opposite >= 0)
    np.testing.assert_allclose(compared.thickness[across], 4.0 * block.map.thickness[across], rtol=1e-6)
    np.testing.assert_array_equal(compared.thickness[~across], block.map.thickness[~across])
    np.testing.assert_allclose(compared.corner_thickness[across], 4.0 * block.map.corner_thickness[across], rtol=1e-6)
