# SPDX-License-Identifier: LGPL-2.1-or-later
"""Element sizes of parts whose walls are known, the size field, its boxes, and measures of volume meshes."""

import itertools
from dataclasses import replace

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.mesh.tetrahedra import inverse_condition_numbers, layers_through, outer_nodes
from thinpart_workbench.core.sizing.size_boxes import size_boxes
from thinpart_workbench.core.sizing.size_field import SizeField
from thinpart_workbench.core.sizing.size_proposal import propose_sizes, without_thinnest
from thinpart_workbench.core.sizing.size_sources import places
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings, divisions_of, layers_of
from thinpart_workbench.core.thickness.measurement import measure

RNG = np.random.default_rng(7)

LAYERED = SizingSettings(order=1, growth=1.4)
"""Two layers of elements of first order in thin walls."""


def measured(vertices, triangles, faces=None):
    return measure(surface_mesh(vertices, triangles, faces), AnalysisSettings())


@pytest.fixture(scope="module")
def plate():
    return measured(*made_meshes.box(100, 80, 2))


@pytest.fixture(scope="module")
def ribbed():
    return measured(*made_meshes.ribbed_block(60.0, 40.0, 3.0, 20.0, 100.0))


@pytest.mark.parametrize("layers", [0.2, 0.9, 1.0, 1.3, 1.7, 2.0, 3.0, 8.0])
def test_layers_and_divisions_are_inverse(layers):
    assert layers_of(divisions_of(layers)) == pytest.approx(layers, rel=1e-12)


def test_a_plate_has_elements_that_give_it_the_wanted_layers(plate):
    proposal = propose_sizes(plate, 10.0, SizingSettings(layers=2))
    size = 2.0 / divisions_of(2)
    assert proposal.least_size == pytest.approx(size, rel=1e-3)
    region, = proposal.regions
    assert region.layers == pytest.approx(2.0, rel=1e-3) and region.size == pytest.approx(size, rel=1e-3)
    coarser = propose_sizes(plate, 10.0, SizingSettings(layers=1))
    # The rims of the plate are narrow faces.
    assert coarser.least_size == pytest.approx(2.0, rel=0.05) and coarser.elements < proposal.elements / 7
    assert propose_sizes(plate, 10.0, SizingSettings(order=2, error=None)).layers == 1.0


def test_each_element_is_counted_for_one_region():
    """A plate with a step: its level side is a face of both of its walls."""
    vertices, triangles = made_meshes.prism([(0, 0), (80, 0), (80, 5), (40, 5), (40, 2), (0, 2)], 60.0)
    part = measured(vertices, triangles, np.zeros(len(triangles), dtype=np.int64))
    proposal = propose_sizes(part, 20.0, SizingSettings(layers=2))
    thin, thick = proposal.regions
    assert (thin.region.median, thick.region.median) == pytest.approx((2.0, 5.0))
    assert thin.region.faces == thick.region.faces
    # Two layers each in volumes of 2 to 5, so elements as 5^2 to 2^2; some are of the transition.
    assert thin.elements > 3 * thick.elements
    assert thin.elements + thick.elements <= proposal.elements + 1


def test_the_estimate_is_the_volume_by_that_of_an_element(plate):
    proposal = propose_sizes(plate, 10.0, SizingSettings(layers=2, growth=1.05))
    by_size = {each: propose_sizes(plate, 10.0, SizingSettings(layers=1, size=each)).elements for each in (0.5, 1.0)}
    assert by_size[0.5] == pytest.approx(8 * by_size[1.0], rel=0.01)
    assert proposal.elements == pytest.approx(by_size[1.0] * (2.3 / 2.0) ** 3.0, rel=0.1)
    assert proposal.uniform_elements >= proposal.elements


def test_elements_larger_than_a_wall_is_thick_are_flat_and_as_many_as_its_area_asks_for(plate):
    """Gmsh makes 7.1 to 8.2 for each square of a plate or tube from a quarter of its thickness on."""
    for size in (2.0, 4.0, 8.0):
        found = propose_sizes(plate, 0.0, replace(LAYERED, size=size)).elements
        assert found == pytest.approx(7.2 * 100 * 80 / size ** 2, rel=0.15)


def test_only_chosen_walls_ask_for_sizes(ribbed):
    """As in a part that is called normal."""
    free = propose_sizes(ribbed, 5.0, LAYERED)
    number = free.regions[0].number
    none = propose_sizes(ribbed, 5.0, LAYERED, only_chosen=True)
    assert none.is_uniform and not none.regions and none.left_out == len(free.regions) and free.left_out == 0
    off = propose_sizes(ribbed, 5.0, LAYERED, {number: None}, only_chosen=True)
    assert off.is_uniform and off.left_out == none.left_out
    chosen = propose_sizes(ribbed, 5.0, LAYERED, {number: 1.0}, only_chosen=True)
    region, = chosen.regions
    assert region.number == number and region.size == pytest.approx(1.0) and chosen.left_out == none.left_out - 1


def test_a_part_without_thin_walls_has_one_size():
    block = measured(*made_meshes.box(100, 80, 60))
    proposal = propose_sizes(block, 10.0, LAYERED)
    diagonal = block.descriptors.box.diagonal
    assert proposal.is_uniform and proposal.least_size == proposal.global_size == pytest.approx(0.1 * diagonal)
    assert not proposal.regions and proposal.layers == 0.0


def test_only_the_thin_wall_is_fine(ribbed):
    proposal = propose_sizes(ribbed, 5.0, LAYERED)
    size = 3.0 / divisions_of(2)
    on_rib, below = np.array([[30.0, 30.0, 50.0]]), np.array([[5.0, 5.0, 50.0]])
    low, high = ribbed.field.mesh.vertices.min(axis=0), ribbed.field.mesh.vertices.max(axis=0)
    middle = 0.5 * (low + high) + ribbed.field.mesh.origin
    on_rib = middle + [0.0, 0.5 * (high - low)[1] - 5.0, 0.0]
    below = low + ribbed.field.mesh.origin + 2.0
    field = proposal.field
    assert field.at(on_rib[None])[0] == pytest.approx(size, rel=0.35)
    assert field.at(below[None])[0] > 4.0 * size
    assert proposal.elements < 0.5 * proposal.uniform_elements


def test_a_narrow_face_asks_for_elements_as_small_as_it_is():
    """A thin plate with a chamfer of 0.2 mm along one edge."""
    outline = [(0, 0), (100, 0), (100, 1.8), (99.8, 2.0), (0, 2.0)]
    vertices, triangles = made_meshes.prism(outline, 80)
    with_chamfer = propose_sizes(measured(vertices, triangles), 10.0, LAYERED)
    without = propose_sizes(measured(*made_meshes.box(100, 80, 2)), 10.0, LAYERED)
    assert with_chamfer.least_size < 0.3 < without.least_size


@pytest.mark.parametrize("budget", [200_000, 20_000, 3_000, 300, 5])
def test_a_budget_is_kept_and_says_what_it_costs(ribbed, budget):
    proposal = propose_sizes(ribbed, 5.0, SizingSettings(layers=4, budget=budget))
    free = propose_sizes(ribbed, 5.0, SizingSettings(layers=4))
    if free.elements <= budget:
        assert proposal.unbounded is None and proposal.elements == free.elements
        return
    assert proposal.elements <= max(budget, 5) * 1.05
    assert proposal.unbounded.elements == free.elements and proposal.layers < proposal.unbounded.layers == 4.0
    assert proposal.least_size > free.least_size


def test_a_budget_is_saved_first_where_a_knife_edge_takes_most_of_the_elements():
    """A plate of 2 mm, 100 long, that ends in a blade of 0.05 mm; the walls that are not the blade keep their layers."""
    bladed = measured(*made_meshes.prism([(0, 0), (2, 0), (2, 100), (0.05, 102), (0, 102)], 80))
    free = propose_sizes(bladed, 10.0, LAYERED)
    coarser = without_thinnest(bladed, free)
    assert coarser.elements < 0.5 * free.elements and coarser.layers == free.layers == 2.0
    between = (coarser.elements + free.elements) // 2
    found = propose_sizes(bladed, 10.0, replace(LAYERED, budget=between))
    assert 0.9 * between < found.elements <= between and found.layers == 2.0 and found.unbounded.elements == free.elements
    assert 0.05 < found.layered_from < coarser.layered_from
    found = propose_sizes(bladed, 10.0, replace(LAYERED, budget=coarser.elements // 3))
    assert found.elements <= coarser.elements // 3 and 0.0 < found.layers < 2.0
    assert found.layered_from == coarser.layered_from


def test_walls_of_one_thickness_have_no_thinnest(plate, ribbed):
    for part in (plate, ribbed):
        free = propose_sizes(part, 10.0, LAYERED)
        assert without_thinnest(part, free) is None and free.layered_from == 0.0


@pytest.mark.parametrize("wrong", [
    {"order": 3}, {"error": 0.0}, {"error": 0.3}, {"error": float("nan")}, {"layers": 0.0}, {"layers": float("nan")},
    {"layers": 1e9}, {"growth": 1.0}, {"growth": float("inf")}, {"size": 0.0}, {"size": float("nan")}, {"budget": 0}])
def test_settings_out_of_range_are_refused(wrong):
    with pytest.raises(ThinPartError) as refused:
        SizingSettings(**wrong)
    assert refused.value.kind == "usage"


@pytest.fixture(scope="module")
def scattered():
    points = RNG.uniform(0.0, 100.0, (300, 3))
    return SizeField(places(points, RNG.uniform(0.5, 20.0, 300)), 15.0, 1.4), points


def test_the_size_is_that_of_its_sources_and_grows_no_faster(scattered):
    field, _ = scattered
    here = RNG.uniform(-20.0, 120.0, (3000, 3))
    step = RNG.normal(0.0, 2.0, (3000, 3))
    # Levels of sizes are searched together, which rounds by their factor.
    most = field.slope * np.linalg.norm(step, axis=1)
    assert (np.abs(field.at(here + step) - field.at(here)) <= most + 1e-9).all()
    assert field.at(here).max() <= 15.0 and field.at(here).min() >= field.least


def test_sources_have_their_own_size_or_less(scattered):
    field, points = scattered
    sizes = np.array([field.at(point[None])[0] for point in points])
    assert (sizes <= 15.0).all() and sizes.min() == pytest.approx(field.least)


def test_boxes_cover_the_part_and_interpolate_the_field(scattered):
    field, _ = scattered
    boxes = size_boxes(field, np.zeros(3), np.full(3, 100.0), RNG.uniform(0.0, 100.0, (40_000, 3)))
    low, high = boxes.corners[:, 0], boxes.corners[:, 6]
    points = RNG.uniform(0.0, 100.0, (400, 3))
    for point in points:
        own = np.flatnonzero(((low <= point) & (point <= high)).all(axis=1))
        assert len(own)
        at = (point - low[own[0]]) / (high - low)[own[0]]
        weights = [np.prod(np.where(corner, at, 1.0 - at)) for corner in
                   ((boxes.corners[own[0]] - low[own[0]]) > 0.5 * (high - low)[own[0]])]
        interpolated, exact = float(np.dot(weights, boxes.sizes[own[0]])), field.at(point[None])[0]
        assert interpolated == pytest.approx(exact, rel=0.5)
    assert len(size_boxes(field, np.zeros(3), np.full(3, 100.0), RNG.uniform(0.0, 100.0, (4000, 3)), 500).sizes) <= 500


def layered_box(layers, cells=4):
    """Tetrahedra in a plate with so many layers, six in each cell."""
    steps = [np.linspace(0, 10, cells + 1), np.linspace(0, 10, cells + 1), np.linspace(0, 1, layers + 1)]
    points = np.array(list(itertools.product(*steps)))
    number = np.arange(len(points)).reshape(cells + 1, cells + 1, layers + 1)
    tetrahedra = []
    for i, j, k in itertools.product(range(cells), range(cells), range(layers)):
        for way in itertools.permutations(range(3)):
            place, corners = np.array([i, j, k]), [number[i, j, k]]
            for axis in way:
                place = place + np.eye(3, dtype=int)[axis]
                corners.append(number[tuple(place)])
            tetrahedra.append(corners)
    return points, np.array(tetrahedra)


@pytest.mark.parametrize("layers", [1, 2, 3, 5])
def test_layers_are_counted(layers):
    points, tetrahedra = layered_box(layers)
    here = np.column_stack([RNG.uniform(2, 8, (20, 2)), np.zeros(20)])
    there = here + [0.0, 0.0, 1.0]
    # From node to node, half of an odd number of layers already lies beyond the middle.
    beyond = layers // 2 + 1
    assert (layers_through(points, tetrahedra, here, there, 9) >= min(beyond, layers)).all()
    assert (layers_through(points, tetrahedra, here, there, 1) == 1).all()


def test_the_condition_number_is_that_of_the_map_from_the_regular_tetrahedron():
    regular = np.array([[0, 0, 0], [1, 0, 0], [0.5, np.sqrt(0.75), 0], [0.5, np.sqrt(1 / 12), np.sqrt(2 / 3)]])
    one = np.array([[0, 1, 2, 3]])
    assert inverse_condition_numbers(regular, one)[0] == pytest.approx(1.0)
    assert inverse_condition_numbers(regular, one[:, [1, 0, 2, 3]])[0] == pytest.approx(-1.0)
    assert inverse_condition_numbers(regular * [1, 1, 0], one)[0] == 0.0
    points = RNG.normal(size=(40, 3))
    tetrahedra = np.array([RNG.choice(40, 4, replace=False) for _ in range(200)])
    ideal = np.linalg.inv((regular[1:] - regular[0]).T)
    for row, found in zip(tetrahedra, inverse_condition_numbers(points, tetrahedra)):
        mapped = (points[row[1:]] - points[row[0]]).T @ ideal
        expected = 3.0 / (np.linalg.norm(mapped) * np.linalg.norm(np.linalg.inv(mapped))) * np.sign(np.linalg.det(mapped))
        assert found == pytest.approx(expected, rel=1e-6)


def test_nodes_on_the_surface():
    points, tetrahedra = layered_box(2, 2)
    inner = np.setdiff1d(np.arange(len(points)), outer_nodes(tetrahedra))
    assert (points[inner] == [5.0, 5.0, 0.5]).all() and len(inner) == 1


def test_a_large_thin_plate_takes_few_boxes_and_keeps_its_size(plate):
    proposal = propose_sizes(plate, 10.0, LAYERED)
    mesh, inner = plate.field.mesh, proposal.inner.points.reshape(-1, 3)
    boxes = size_boxes(proposal.field, *(end(mesh.vertices, axis=0) + mesh.origin for end in (np.min, np.max)), inner)
    assert len(boxes.sizes) < 5000
    low, high = boxes.corners[:, 0], boxes.corners[:, 6]
    for point in inner[:: len(inner) // 200]:
        own = np.flatnonzero(((low <= point) & (point <= high)).all(axis=1))[0]
        assert boxes.sizes[own].max() <= 1.3 * 2.0 / divisions_of(2)


def test_points_within_a_part_have_its_volume(ribbed):
    inner = propose_sizes(ribbed, 5.0, LAYERED).inner
    assert inner.volumes.sum() == pytest.approx(ribbed.descriptors.volume, rel=1e-9)
