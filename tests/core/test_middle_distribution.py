# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shares of the surface by thickness in units of the middle side of the box."""

from dataclasses import replace

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.bins import MIDDLE_BINS
from thinpart_workbench.core.descriptors.packed_distribution import middle_share, packed_middle, packed_slanted, packed_walls
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


def descriptors(*size):
    return measure(surface_mesh(*made_meshes.box(*size)), AnalysisSettings()).descriptors


def share_of_the_sides(long, wide, high):
    return long * wide / (long * wide + long * high + wide * high)


@pytest.mark.parametrize("length", [200.0, 2000.0, 20_000.0])
def test_a_strip_has_its_thickness_whatever_its_length(length):
    # 1 mm of 20 mm: x is less than a bin of a thousandth of the diagonal from 1,000 mm on.
    strip = descriptors(length, 20.0, 1.0)
    assert strip.value("K[0;0.06]") == pytest.approx(share_of_the_sides(length, 20, 1), abs=1e-6)
    assert strip.value("P[0;0.05]") == strip.value("K[0;0.04]") == pytest.approx(0.0, abs=1e-9)


def test_a_wall_exactly_at_a_bound_is_not_below_it():
    for turn in (Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix(), np.eye(3)):
        mesh = surface_mesh(*made_meshes.moved(made_meshes.box(200, 100, 12), turn))
        found = measure(mesh, AnalysisSettings()).descriptors
        assert found.value("K[0;0.12]") == pytest.approx(0.0, abs=1e-9)
        assert found.value("K[0;0.13]") == pytest.approx(share_of_the_sides(200, 100, 12), abs=1e-6)


def test_a_bound_within_a_bin_counts_in_part():
    strip = descriptors(200.0, 20.0, 1.1)
    whole = share_of_the_sides(200, 20, 1.1)
    assert strip.value("K[0;0.055]") == pytest.approx(0.5 * whole, abs=1e-6)


def test_the_margin_is_how_much_thicker_walls_would_have_to_be():
    strip = descriptors(2000.0, 20.0, 1.0)
    thickness = strip.distribution.middle_quantile(0.5, strip.box.dimensions[1] / strip.box.diagonal)
    assert 0.05 <= thickness <= 0.06
    assert strip.distribution.middle_quantile(0.999, 0.01) == float("inf")


def test_of_a_record_without_them_the_shares_are_those_by_the_diagonal():
    plate = descriptors(100.0, 60.0, 3.0)
    older = replace(plate, distribution=replace(plate.distribution, middle=None))
    assert older.value("K[0;0.12]") == pytest.approx(plate.value("K[0;0.12]"), abs=1e-6)


def test_a_search_finds_the_same_shares_in_packed_columns():
    plate = descriptors(3000.0, 60.0, 3.0)
    content = plate.distribution
    walls = packed_walls({"bins": content.bins.tolist(), "area": content.area.tolist()})
    slanted = packed_slanted({"bins": content.nonparallel_bins.tolist(), "angles": content.nonparallel_angles.tolist(),
                              "area": content.nonparallel_area.tolist()})
    middle = {"bins": content.middle.bins.tolist(), "parallel": content.middle.parallel.tolist(),
              "nonparallel": content.middle.nonparallel.tolist()}
    unit = plate.box.dimensions[1] / plate.box.diagonal
    for packed in (packed_middle(middle), packed_middle(None)):
        found = middle_share(*walls, *slanted, *packed, unit, 0.0, 0.12, True)
        assert found == pytest.approx(plate.value("K[0;0.12]"), abs=1e-6)


def test_bins_are_those_that_have_an_area():
    middle = descriptors(100.0, 60.0, 3.0).distribution.middle
    assert len(middle.bins) < MIDDLE_BINS and ((middle.parallel + middle.nonparallel) > 0.0).all()
    assert middle.parallel.sum() + middle.nonparallel.sum() <= 1.0 + 1e-12
