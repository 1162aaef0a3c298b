# SPDX-License-Identifier: LGPL-2.1-or-later
"""The local thickness of solids of which it is known."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import Descriptors
from thinpart_workbench.core.descriptors.local_distribution import local_distribution
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.thickness.local_thickness import local_thickness
from thinpart_workbench.core.thickness.measurement import measure

TURN = Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix()
PIN = [(np.cos(angle), np.sin(angle)) for angle in np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)]
PLACES = pytest.mark.parametrize("rotation, scale", [(np.eye(3), 1.0), (TURN, 0.01), (TURN, 1000.0)])


def _measured(shape, rotation=None, scale=1.0, **settings):
    return measure(surface_mesh(*made_meshes.moved(shape, rotation, (30.0, -20.0, 10.0), scale)),
                   AnalysisSettings(**settings))


def _local(measurement):
    """Points of samples, their share of the surface and local thickness, mm."""
    field = measurement.field
    counted = field.area > 0.0
    own = local_thickness(field.mesh, field, InwardRays(field.mesh), measurement.box_mm[2])
    return field.samples.points[counted] + field.mesh.origin, field.area[counted] / field.area.sum(), own


@PLACES
@pytest.mark.parametrize("shape, thick, within", [
    (made_meshes.box(100.0, 80.0, 2.0), 2.0, 0.001), (made_meshes.box(200.0, 20.0, 5.0, 3), 5.0, 0.001),
    (made_meshes.tube(20.0, 18.0, 60.0), 2.0, 0.01), (made_meshes.spherical_shell(20.0, 1.0, 60), 1.0, 0.01),
    (made_meshes.sphere(20.0, 72), 40.0, 0.01),
    (made_meshes.prism(PIN, 30.0), 2.0, 0.01),
    # Only the ball at the very middle of a side is as large as the cube.
    (made_meshes.box(10.0, 10.0, 10.0, 12), 10.0, 0.06)],
    ids=["plate", "bar", "tube", "shell", "sphere", "pin", "cube"])
def test_a_solid_of_one_thickness_has_it_all_over(shape, thick, within, rotation, scale):
    measurement = _measured(shape, rotation, scale)
    _, share, own = _local(measurement)
    off = np.abs(own / (thick * scale) - 1.0)
    assert share[off > within].sum() < 0.1, "only where three faces of a block meet"
    assert measurement.value("T50") * measurement.box_mm[1] == pytest.approx(thick * scale, rel=max(within, 0.002))


@PLACES
def test_a_rib_has_its_own_thickness_and_the_block_below_it_is_as_thick_as_the_block(rotation, scale):
    measurement = _measured(made_meshes.ribbed_block(60.0, 40.0, 6.0, 40.0, 100.0), rotation, scale)
    points, share, own = _local(measurement)
    height = ((points - (30.0, -20.0, 10.0)) @ rotation / scale)[:, 1]
    on_rib, below = height > 55.0, height < 35.0
    # A ball in the block, 20 mm in radius with its centre 20 mm below its top, reaches 10 mm up the rib.
    assert np.average(np.abs(own[on_rib] / scale - 6.0) < 0.01) > 0.995
    assert np.average(own[below] / scale > 35.0, weights=share[below]) > 0.98
    middle = measurement.box_mm[1]
    rib = share[on_rib].sum()
    assert measurement.value("L[0;0.1]") == pytest.approx(rib, abs=0.03) and middle == pytest.approx(80.0 * scale, rel=1e-3)


def test_a_wedge_grows_from_its_edge():
    measurement = _measured(made_meshes.wedge(30.0, 100.0, 60.0))
    points, _, own = _local(measurement)
    from_edge = np.linalg.norm((points - (30.0, -20.0, 10.0))[:, :2], axis=1)
    on_side = (from_edge > 15.0) & (from_edge < 60.0) & (np.abs(points[:, 2] - 40.0) < 15.0)
    # The ball that touches both sides at d from the edge has the radius d tan 15, and reaches 1.5 radii around its centre.
    half = np.tan(np.radians(15.0))
    farther = 1.0 + half * np.sqrt(1.25) / (1.0 - half * np.sqrt(1.25))
    ratio = own[on_side] / (2.0 * half * from_edge[on_side])
    assert 1.0 < np.median(ratio) < farther * 1.1 and ratio.min() > 0.95


def test_threads_and_teeth_are_thinner_than_what_they_are_on():
    screw = _measured(made_meshes.screw())
    points, share, own = _local(screw)
    core = np.hypot(*(points - (30.0, -20.0, 10.0))[:, :2].T) < 4.2
    assert np.average(own[core], weights=share[core]) > 0.9 * 2.0 * 4.08
    turn = np.linspace(0.0, 2.0 * np.pi, 80, endpoint=False)
    wheel = [(r * np.cos(a), r * np.sin(a)) for a, r in zip(turn, np.tile([20.0, 20.0, 28.0, 28.0], 20))]
    gear = _measured(made_meshes.prism(wheel, 12.0))
    points, share, own = _local(gear)
    radius = np.hypot(*(points - (30.0, -20.0, 10.0))[:, :2].T)
    assert own[radius > 27.0].max() < 5.0 and np.average(own[radius < 15.0], weights=share[radius < 15.0]) > 11.0
    assert gear.value("L[0;0.1]") > 0.2 > 0.05 > _measured(made_meshes.tube(28.0, 4.0, 12.0)).value("L[0;0.1]")


@pytest.mark.parametrize("shape", [made_meshes.ribbed_block(), made_meshes.screw(), made_meshes.wedge()],
                         ids=["rib", "screw", "wedge"])
def test_it_is_the_same_turned_scaled_and_at_any_accuracy_within_its_error(shape):
    found = [_measured(shape, rotation, scale, minimum_samples=samples) for rotation, scale, samples in (
        (None, 1.0, 12_000), (TURN, 1.0, 12_000), (TURN, 300.0, 12_000), (None, 1.0, 4_000), (None, 1.0, 36_000))]
    for quantity in ("L[0;0.08]", "L[0;0.12]", "L[0;0.3]"):
        values = [each.value(quantity) for each in found]
        assert max(values) - min(values) < 0.03, (quantity, values)
    for quantity in ("T05", "T50", "T75", "T99"):
        values = [each.value(quantity) for each in found]
        assert max(values) - min(values) < 0.03, (quantity, values)


def test_quantiles_and_shares_agree():
    measured: Descriptors = _measured(made_meshes.ribbed_block()).descriptors
    assert list(measured.local.quantiles.values()) == sorted(measured.local.quantiles.values())
    for name, share in (("T05", 0.05), ("T50", 0.5), ("T75", 0.75), ("T99", 0.99)):
        value = measured.value(name)
        assert measured.local.share(0.0, value - 0.011) <= share <= measured.local.share(0.0, value + 0.011) + 1e-9
    assert measured.value("L[0;1]") == pytest.approx(1.0)


def test_a_ball_as_large_as_the_box_is_no_larger_by_rounding():
    local = local_distribution(np.array([1.0, 1.0 + 1e-8]), np.ones(2), 1.0)
    assert max(local.quantiles.values()) == 1.0 and local.share(0.0, 1.0) == pytest.approx(1.0)


def test_pairs_have_no_local_thickness():
    measured = _measured(made_meshes.box(10.0, 10.0, 10.0, 4), measure="pairs")
    assert measured.value("L[0;0.5]") is None and measured.value("T50") is None
