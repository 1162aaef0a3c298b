# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets of maps that are too thick: by balls, with the limits of single faces, and of maps of before by rays."""

from dataclasses import replace

import made_library
import made_meshes
import pytest

from thinpart_workbench.api.window.limits import too_thick_facets
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
    assert not too_thick_facets([block], limits(45.0))[0].any()  # the way through it is longer, to 60 mm
    assert too_thick_facets([block], limits(20.0))[0].mean() > 0.9
    before = replace(block, map=replace(block.map, balls=None))
    by_rays, = too_thick_facets([before], limits(39.0))
    assert (by_rays == (block.map.thickness > 1.02 * 39.0)).all() and by_rays.any()


def test_a_limit_that_is_kept_for_a_face_counts(block):
    face = block.record["faces"][0]
    limit = {"face": face["face"], "area_mm2": face["area_mm2"], "surface": face.get("surface"), "reason": "a foot",
             "max_mm": 60.0}
    found, = too_thick_facets([block], limits(20.0), {block.record["name"]: [limit]})
    assert not found[block.map.face == int(face["face"][4:]) - 1].any() and found.any() == (len(block.record["faces"]) > 1)
