# SPDX-License-Identifier: LGPL-2.1-or-later
"""When a mesh is fine enough, what is told where it cannot be made so, and thresholds that are met exactly."""

import math
from dataclasses import replace

import numpy as np
import pytest
from made_meshes import box, prism
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import Descriptors, quantity_named
from thinpart_workbench.core.descriptors.distribution import Distribution
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import Condition, load_profile
from thinpart_workbench.core.mesh.bounds import minimal_box
from thinpart_workbench.core.mesh.mass_properties import area, volume
from thinpart_workbench.core.mesh.resolution import (
    Resolution,
    error_to_judge_with,
    is_turned_too_far,
    smallest_side,
)
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure

PAPER = load_profile("paper")


def rod(length, steps):
    """A rod of 1 mm."""
    turn = np.linspace(0.0, 2.0 * np.pi, steps, endpoint=False)
    points, triangles = prism(0.5 * np.column_stack([np.cos(turn), np.sin(turn)]), length)
    # The sides are one face, the ends two.
    middle = np.asarray(points)[np.asarray(triangles)].mean(axis=1)
    faces = np.where(middle[:, 2] < 1e-9 * length, 1, np.where(middle[:, 2] > (1 - 1e-9) * length, 2, 0))
    return surface_mesh(points, triangles, faces, rounding=0.0)


@pytest.mark.parametrize("length", [10, 1000, 10_000, 50_000])
def test_a_slender_rod(length):
    mesh = rod(length, 90)
    measurement = measure(mesh, AnalysisSettings())
    side, whole = math.pi * length, math.pi * length + math.pi / 2
    deflection = 0.5 * (1 - math.cos(math.pi / 90))
    resolution = Resolution(deflection, mesh.extent, mesh.rounding)
    measured = measurement.descriptors
    assert measured.volume == pytest.approx(math.pi / 4 * length, rel=resolution.error / measured.body_thickness)
    assert measured.area == pytest.approx(whole, rel=resolution.error / measured.body_thickness)
    assert measurement.thinnest_mm == pytest.approx(1.0, abs=1.001 * resolution.error)
    assert measured.value("F[0;0.25]") == pytest.approx(side / whole, abs=1e-3)
    assert smallest_side(measured) == measured.body_thickness
    assert resolution.is_enough_for(0.5)
    assert not is_turned_too_far(mesh, 4.0) and is_turned_too_far(rod(length, 31), 4.0)


def test_a_coarse_rod_is_seen_to_be_coarse_by_its_body_and_not_by_its_walls():
    mesh = rod(10_000, 5)
    deflection = 0.5 * (1 - math.cos(math.pi / 5))
    resolution = Resolution(deflection, mesh.extent)
    assert resolution.is_enough_for(measure(mesh, AnalysisSettings()).thinnest_mm)  # the end caps alone
    assert not resolution.is_enough_for(2 * volume(mesh) / area(mesh))
    assert resolution.required_deflection(0.5) * mesh.extent == pytest.approx(0.02, rel=1e-6)


def test_what_has_no_volume_is_measured_by_its_walls_alone():
    points, triangles = box(10, 10, 1)
    sheet = surface_mesh(points, triangles[:-2])
    measurement = measure(sheet, AnalysisSettings())
    assert measurement.descriptors.volume is None
    assert smallest_side(measurement.descriptors) is None


def test_the_error_to_judge_with_is_that_of_lengths_which_the_mesh_blurs():
    assert error_to_judge_with([(None, 1.0)]) == 0.0
    assert error_to_judge_with([(3.0, 0.1), (10.0, 1.0)]) == 0.0
    assert error_to_judge_with([(3.0, 0.1), (5.0, 1.0)]) == 1.0


def test_a_wall_is_as_certain_as_the_facets_at_its_two_ends():
    resolution = Resolution(0.3, 100.0, 1e-6)
    thickness, chords = np.array([1.0, 1.0, 4.0]), np.array([0.0, 0.2, 0.3])
    assert resolution.is_enough_for(thickness, chords).tolist() == [True, False, True]
    assert not resolution.is_enough_for(4.0) and resolution.is_enough_for(None)
    assert resolution.wall_error(0.2) == pytest.approx(0.2002)


def measured_block(length_error):
    """100 x 40 x 3 with a wall of 3 over all of it: D2/D3 13.3, F[0;0.05] 1."""
    mesh = surface_mesh(*box(100, 40, 3))
    return replace(measure(mesh, AnalysisSettings()).descriptors, length_error=length_error)


@pytest.mark.parametrize("error, told", [(0.0, True), (0.05, True), (0.25, True), (0.6, False), (5.0, False)])
def test_a_condition_is_told_while_the_error_cannot_turn_it(error, told):
    condition = Condition(quantity_named("d2_d3"), ">", 12.0).check(measured_block(error), 1e-4)
    assert condition.holds is (True if told else None)
    assert condition.too_coarse is not told


def test_errors_of_lengths_reach_all_that_depends_on_lengths():
    block = measured_block(0.25)
    names = "d1_mm", "volume_mm3", "area_mm2", "d2_d3", "F[0;0.25]"
    off = {name: quantity_named(name).error(block, 1e-4) for name in names}
    assert off["d1_mm"] == pytest.approx(0.25)
    assert off["volume_mm3"] == pytest.approx(0.125 * block.area)  # half of it under the whole surface
    assert off["area_mm2"] == pytest.approx(0.25 / block.body_thickness * block.area)
    assert off["d2_d3"] == pytest.approx(40 / 3 * (0.25 / 40 + 0.25 / 3), rel=1e-3)
    assert off["F[0;0.25]"] == pytest.approx(0.0, abs=1e-9)
    assert quantity_named("regions").error(measured_block(2.0), 1e-4) == math.inf
    assert quantity_named("d1_mm").error(measured_block(0.0), 1e-4) is None


def test_nothing_is_told_of_what_is_smaller_than_the_error_and_the_reason_says_so():
    verdict = classify(measured_block(2.0), PAPER)
    assert verdict.category == "unknown" and verdict.criteria == ()
    assert "too slender" in verdict.reason and "400,000 triangles" in verdict.reason
    assert classify(measured_block(0.0), PAPER).category == "thin"


def test_shares_of_walls_near_a_bound_are_not_told():
    shares = Distribution(np.array([48]), np.array([1.0]), *[np.array([], int)] * 2, np.array([]), 1.0, 0.0, 0.0, 0.0)
    dimensions = np.array([100.0, 60.0, 40.0])
    least = minimal_box(np.array([[x, y, z] for x in (0, 100) for y in (0, 60) for z in (0, 40)], float))
    measured = Descriptors(dimensions.prod(), 24800.0, least, shares, None, length_error=0.0)
    condition = Condition(quantity_named("F[0;0.05]"), ">", 0.0)
    assert condition.check(measured, 1e-4).holds is True
    diagonal = least.diagonal
    assert condition.check(replace(measured, length_error=0.0005 * diagonal), 1e-4).holds is True
    assert condition.check(replace(measured, length_error=0.004 * diagonal), 1e-4).holds is None


EXACT = {
    "d2_d3": (box(30, 12, 1), 12.0),
    "d1_d2": (box(21, 12, 2), 1.75),
    "long": (box(1200, 12, 1), 12.0),
    "volume_ratio": (prism([(0, 0), (30, 0), (30, 10), (20, 10), (20, 20), (0, 20)], 7), 5 / 6),
}


@pytest.mark.parametrize("quantity", EXACT)
def test_what_is_exactly_at_a_threshold_stays_there_under_rotation_and_scale(quantity):
    (points, triangles), threshold = EXACT[quantity]
    named = quantity_named("d2_d3" if quantity == "long" else quantity)
    conditions = [Condition(named, comparison, threshold) for comparison in "<>"]
    random = np.random.default_rng(5)
    turns = Rotation.random(200, random_state=7).as_matrix()
    shares = Distribution(*[np.array([], int)] * 4, np.array([]), 0.0, 0.0, 1.0, 0.0)
    for number, turn in enumerate(turns):
        moved = points @ turn.T * 10.0 ** random.uniform(-3, 3)
        if number % 2:
            moved = (moved - moved.mean(axis=0)).astype(np.float32)
        mesh = surface_mesh(moved, triangles)
        measured = Descriptors(volume(mesh), area(mesh), minimal_box(mesh.vertices), shares, None)
        checked = [condition.check(measured, 1e-4) for condition in conditions]
        assert [each.holds for each in checked] == [False, False], named.evaluate(measured, 1e-4)
        assert [each.margin for each in checked] == [0.0, 0.0]


def test_a_little_beside_a_threshold_is_beside_it():
    measured = measured_block(0.0)
    ratio = measured.value("d2_d3")
    for share, holds in ((1e-4, False), (-1e-4, True)):
        assert Condition(quantity_named("d2_d3"), ">", ratio * (1 + share)).check(measured, 1e-4).holds is holds
