# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts whose measures and verdicts are known in closed form, in every place and size."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure

PAPER = load_profile("paper")

PLACES = {
    "as made": {},
    "turned": {"rotation": Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()},
    "turned otherwise": {"rotation": Rotation.from_rotvec([-2.1, 0.4, 1.3]).as_matrix()},
    "far away": {"rotation": Rotation.from_rotvec([1, 1, 1]).as_matrix(),
                 "shift": (1e6, -2e6, 5e5)},
    "in micrometres": {"scale": 1000.0},
    "in metres": {"scale": 0.001, "rotation": Rotation.from_rotvec([0, 0, 0.7]).as_matrix()},
}


def analysed(shape, place="as made"):
    mesh = surface_mesh(*made_meshes.moved(shape, **PLACES[place]))
    measurement = measure(mesh, AnalysisSettings())
    return measurement, classify(measurement.descriptors, PAPER)


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("cells", [1, 4, 12])
def test_plate(place, cells):
    measurement, verdict = analysed(made_meshes.box(100, 100, 2, cells), place)
    scale = PLACES[place].get("scale", 1.0)
    descriptors = measurement.descriptors
    assert descriptors.box.dimensions / scale == pytest.approx([100, 100, 2], rel=1e-6)
    assert descriptors.value("V/VBB") == pytest.approx(1.0, rel=1e-6)
    assert descriptors.value("F[0;0.05]") == pytest.approx(20000 / 20800, abs=0.005)
    assert measurement.thinnest_mm / scale == pytest.approx(2.0, rel=1e-6)
    assert (verdict.category, verdict.criteria) == ("thin", (1, 4, 5))


@pytest.mark.parametrize("place", PLACES)
def test_cube(place):
    measurement, verdict = analysed(made_meshes.box(10, 10, 10), place)
    shares = measurement.descriptors.distribution
    assert shares.bins.tolist() == [577] and shares.parallel == pytest.approx(1.0)
    assert (verdict.category, verdict.criteria) == ("normal", ())


@pytest.mark.parametrize("place", PLACES)
def test_spherical_shell(place):
    measurement, verdict = analysed(made_meshes.spherical_shell(steps=120), place)
    scale = PLACES[place].get("scale", 1.0)
    walls = measurement.field.distance[measurement.field.parallel] / scale
    assert measurement.descriptors.value("V/VBB") == pytest.approx(0.0747, rel=5e-3)
    assert measurement.descriptors.distribution.parallel == pytest.approx(1.0, abs=1e-9)
    assert walls.min() > 0.97 and walls.max() < 1.03
    assert (verdict.category, verdict.criteria) == ("thin", (3, 4))


@pytest.mark.parametrize("steps", [60, 90, 180])
def test_tube(steps):
    measurement, verdict = analysed(made_meshes.tube(steps=steps), "turned")
    field = measurement.field
    near = field.distance < 10
    assert field.distance[near] == pytest.approx(2.0, abs=0.06)
    assert field.distance[~near] == pytest.approx(60.0, rel=1e-9)
    rings = 2 * np.pi * (20 ** 2 - 18 ** 2)
    walls = 2 * np.pi * 38 * 60
    assert field.area[near].sum() / field.area.sum() == pytest.approx(
        walls / (walls + rings), abs=2e-3)
    assert (verdict.category, verdict.criteria) == ("thin", (3, 4))


@pytest.mark.parametrize("place", PLACES)
def test_ribbed_block(place):
    measurement, verdict = analysed(made_meshes.ribbed_block(), place)
    scale = PLACES[place].get("scale", 1.0)
    assert measurement.thinnest_mm / scale == pytest.approx(6.0, rel=1e-6)
    assert verdict.category == "thin_features" and 5 in verdict.criteria
    rib = 2 * 20 * 100
    assert measurement.descriptors.value("F[0;0.05]") == pytest.approx(
        rib / (measurement.descriptors.area / scale ** 2), abs=0.005)


@pytest.mark.parametrize("place", PLACES)
def test_wedge(place):
    measurement, verdict = analysed(made_meshes.wedge(30), place)
    assert verdict.category == "thin_features" and 7 in verdict.criteria
    assert measurement.descriptors.value("min_nonparallel[10;55]") <= 0.01


def test_wedge_of_70_degrees_is_no_thin_feature():
    _, verdict = analysed(made_meshes.wedge(70))
    assert 7 not in verdict.criteria


def test_sphere():
    measurement, verdict = analysed(made_meshes.sphere(20, 120), "turned")
    assert measurement.descriptors.value("V/VBB") == pytest.approx(np.pi / 6, rel=3e-3)
    assert measurement.descriptors.value("F[0.57;0.58]") == pytest.approx(1.0, abs=0.01)
    assert (verdict.category, verdict.criteria) == ("normal", ())


def test_rod():
    rod = made_meshes.revolved([(0, 0), (5, 0), (5, 100), (0, 100)], 90)
    measurement, verdict = analysed(rod, "turned")
    assert measurement.wall_range[1] == pytest.approx(10, rel=2e-3)
    assert verdict.category == "thin" and 4 in verdict.criteria


def test_shares_sum_to_one_exactly():
    for shape in (made_meshes.ribbed_block(), made_meshes.wedge(), made_meshes.tube()):
        shares = analysed(shape, "turned")[0].descriptors.distribution
        assert shares.parallel + shares.nonparallel + shares.unmeasured == pytest.approx(
            1.0, abs=1e-15)
        assert shares.area.sum() == pytest.approx(shares.parallel, abs=1e-12)


@pytest.mark.parametrize("wall", [1.0, 5.0, 29.0])
def test_a_wall_exactly_on_a_bin_edge_falls_on_the_same_side_everywhere(wall):
    # A plate whose wall is a round share of its diagonal, which the paper's thresholds are.
    side = np.sqrt((100.0 ** 2 - wall ** 2) / 2)
    bins = set()
    for place in PLACES:
        measurement, _ = analysed(made_meshes.box(side, side, wall), place)
        bins.add(int(measurement.descriptors.distribution.bins[0]))
    assert bins == {round(10 * wall)}


def test_open_box_keeps_its_thickness_and_is_unknown():
    points, triangles = made_meshes.box(100, 100, 80)
    measurement, verdict = analysed((points, triangles[2:]))
    assert measurement.descriptors.volume is None
    assert verdict.category == "unknown" and "V/VBB" in verdict.reason


def test_open_plate_is_thin_all_the_same():
    points, triangles = made_meshes.box(100, 100, 2, cells=5)
    _, verdict = analysed((points, triangles[1:]))
    assert verdict.category == "thin" and 4 in verdict.criteria


def test_bare_sheet_is_unknown():
    points, triangles = made_meshes.box(100, 100, 2)
    measurement, verdict = analysed((points, triangles[:2]))
    assert verdict.category == "unknown"
    assert measurement.descriptors.distribution.unmet == pytest.approx(1.0)
