# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes for an error that is aimed at: what the law holds whatever its constants are, and parts that are known."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.sizing.element_estimate import PER_FACE
from thinpart_workbench.core.sizing.error_law import (
    AIM,
    AIMS,
    FLAT,
    IGNORED,
    error_at,
    size_for_error,
    without_thinnest_places,
)
from thinpart_workbench.core.sizing.size_proposal import propose_sizes, without_thinnest
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.core.thickness.measurement import measure

THICKNESSES = np.geomspace(1e-4, 1.0, 40)
"""By the diagonal."""


def measured(vertices, triangles):
    return measure(surface_mesh(vertices, triangles), AnalysisSettings())


def proposed(part, **settings):
    return propose_sizes(part, 10.0, SizingSettings(**settings))


def sizes_inside(proposal):
    """Sizes within the part, mm."""
    return proposal.field.at(proposal.inner.points.reshape(-1, 3))


@pytest.fixture(scope="module")
def block():
    return measured(*made_meshes.box(100, 80, 60))


@pytest.fixture(scope="module")
def ribbed():
    return measured(*made_meshes.ribbed_block(60.0, 40.0, 3.0, 20.0, 100.0))


@pytest.mark.parametrize("error", AIMS)
def test_the_size_grows_with_the_thickness_but_less(error):
    size = size_for_error(THICKNESSES, 1.0, error)
    ratio, thicker = size[1:] / size[:-1], THICKNESSES[1:] / THICKNESSES[:-1]
    assert (ratio > 1.0).all() and (ratio <= thicker * (1.0 + 1e-9)).all()
    # A wall a tenth as thick as another bends in waves as long: its elements are not a tenth as long.
    assert size_for_error(0.02, 1.0, error) > 0.2 * size_for_error(0.2, 1.0, error)


def test_the_size_grows_with_the_error():
    sizes = [size_for_error(THICKNESSES, 1.0, error) for error in np.linspace(*AIMS, 20)]
    assert all((larger > smaller).all() for smaller, larger in zip(sizes, sizes[1:]))


def test_a_part_twice_as_large_has_elements_twice_as_large():
    assert size_for_error(20.0 * THICKNESSES, 20.0, AIM) == pytest.approx(20.0 * size_for_error(THICKNESSES, 1.0, AIM))


def test_no_element_is_much_longer_than_its_wall_is_thick():
    assert (size_for_error(THICKNESSES, 1.0, AIM) <= FLAT * THICKNESSES * (1.0 + 1e-9)).all()


@pytest.mark.parametrize("error", [AIMS[0], 0.03, AIMS[1]])
def test_the_error_that_is_left_is_that_for_which_the_sizes_are(error):
    factor = size_for_error(0.05, 1.0, error) / size_for_error(0.05, 1.0, AIM)
    assert error_at(AIM, factor) == pytest.approx(error) and error_at(AIM, 1.0) == AIM


def test_the_thinnest_places_ask_for_no_more_than_the_rest():
    area = np.full(1000, 2.0)
    size = np.linspace(5.0, 6.0, 1000)
    few = round(0.9 * IGNORED * len(size))
    size[500:500 + few] = 0.01
    found = without_thinnest_places(size, area)
    rest = np.setdiff1d(np.arange(1000), np.arange(500, 500 + few))
    assert found.min() == pytest.approx(5.0, rel=0.01)
    assert (found[rest] >= size[rest]).all() and found[rest] == pytest.approx(size[rest], rel=0.01)
    size[500:500 + 2 * few] = 0.01
    assert without_thinnest_places(size, area).min() == 0.01, "so many are a wall of the part"
    # The area counts, not the number of places.
    size[:], area[:] = 5.0, 2.0
    size[:300], area[:300] = 0.01, 0.9 * IGNORED * 700 * 2.0 / 300
    assert without_thinnest_places(size, area).min() == 5.0


def test_a_bulky_block_is_about_uniform(block):
    proposal = proposed(block)
    thinnest, thickest = np.quantile(proposal.sources.sizes, [0.05, 0.95])
    assert thickest < 1.2 * thinnest and proposal.uniform_elements < 3 * proposal.elements
    assert proposal.error == AIM and proposal.left_out == 0 and not proposal.is_uniform


def test_a_thin_plate_has_elements_of_one_size_that_is_the_law_s():
    for thickness in (1.0, 4.0):
        plate = measured(*made_meshes.box(100, 80, thickness))
        proposal = proposed(plate)
        expected = float(size_for_error(thickness, plate.descriptors.box.diagonal, AIM))
        assert np.median(sizes_inside(proposal)) == pytest.approx(expected, rel=0.05)
        region, = proposal.regions
        assert region.size == pytest.approx(expected, rel=0.05) and region.layers >= 1.0


def test_only_what_is_thin_is_fine(ribbed):
    proposal = proposed(ribbed)
    inside = sizes_inside(proposal)
    assert inside.max() > 1.5 * inside.min() and proposal.elements < 0.5 * proposal.uniform_elements


@pytest.mark.parametrize("shape", ["block", "ribbed"])
def test_a_smaller_error_takes_more_elements_and_nodes(shape, request):
    part = request.getfixturevalue(shape)
    found = [proposed(part, error=error, size=60.0) for error in (0.005, 0.01, 0.02, 0.05)]
    for finer, coarser in zip(found, found[1:]):
        assert finer.elements > coarser.elements and finer.nodes > coarser.nodes
        assert (sizes_inside(finer) <= sizes_inside(coarser) * (1.0 + 1e-9)).all()


def test_a_knife_s_edge_asks_for_no_more_than_the_plate_that_it_is_on():
    plain = proposed(measured(*made_meshes.prism([(0, 0), (2, 0), (2, 100), (0, 100)], 80)))
    bladed = measured(*made_meshes.prism([(0, 0), (2, 0), (2, 100), (0.05, 100.8), (0, 100.8)], 80))
    edged = proposed(bladed)
    assert edged.least_size == pytest.approx(plain.least_size, rel=0.1)
    assert edged.elements == pytest.approx(plain.elements, rel=0.1)
    assert without_thinnest(bladed, edged) is None, "of the sizes for layers, it would be raised"


@pytest.mark.parametrize("share", [0.8, 0.4, 0.2])
def test_a_budget_is_kept_and_raises_the_error_that_is_expected(ribbed, share):
    free = proposed(ribbed)
    budget = round(share * free.elements)
    found = proposed(ribbed, budget=budget)
    assert free.elements > 500 and free.unbounded is None
    assert found.elements <= budget and found.unbounded.elements == free.elements
    assert found.error > free.error == AIM == found.unbounded.error and found.least_size > free.least_size
    assert found.layered_from == 0.0


def test_a_smaller_budget_costs_more(ribbed):
    free = proposed(ribbed).elements
    errors = [proposed(ribbed, budget=round(share * free)).error for share in (0.9, 0.7, 0.5, 0.3, 0.2)]
    assert errors == sorted(errors) and len(set(errors)) == len(errors)


def test_a_budget_below_what_faces_and_edges_take_gives_as_few_elements_as_there_can_be(ribbed):
    found, faces = proposed(ribbed, budget=10), ribbed.field.mesh.face_of_triangle.max() + 1
    assert PER_FACE * faces < found.elements < 2 * PER_FACE * faces and found.error > AIMS[1]


def test_a_budget_that_is_not_reached_costs_nothing(ribbed):
    free, found = proposed(ribbed), proposed(ribbed, budget=1_000_000)
    assert found.unbounded is None and (found.elements, found.error) == (free.elements, AIM)


def test_a_part_of_one_size_has_a_field_all_the_same(block):
    """Without one, Gmsh spreads the sizes of its edges into the volume."""
    proposal = proposed(block, error=AIMS[1])
    assert proposal.least_size == proposal.global_size and not proposal.is_uniform and proposal.regions == ()
    assert proposal.sources.sizes.max() == proposal.global_size


def test_sizes_that_people_want_on_a_wall_count(ribbed):
    free = proposed(ribbed)
    region = free.regions[0]
    finer = propose_sizes(ribbed, 10.0, SizingSettings(), {region.number: 0.5 * region.size})
    changed = next(each for each in finer.regions if each.number == region.number)
    assert changed.size == pytest.approx(0.5 * region.size, rel=0.01) and finer.elements > free.elements
    off = propose_sizes(ribbed, 10.0, SizingSettings(), {region.number: None})
    assert region.number not in [each.number for each in off.regions] and off.elements < free.elements


def test_layers_and_elements_of_first_order_have_no_error(ribbed):
    for settings in ({"layers": 1.0}, {"order": 1}, {"error": None}):
        found = proposed(ribbed, **settings)
        assert found.error is None and not found.settings.is_by_error
