import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import brute_force
import made_meshes
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors import REPORTED_SHARES
from thinpart_workbench.core.distribution import distribution
from thinpart_workbench.core.sampling import MAXIMUM_EXTRA_SAMPLES, surface_samples
from thinpart_workbench.core.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness import measure_rays

TURNED = Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()


def random_soup(rng, count=400):
    """Small triangles anywhere, needles among them: nothing is closed, nothing is in order."""
    centre = rng.uniform(-50, 50, (count, 1, 3))
    corners = centre + rng.normal(size=(count, 3, 3)) * rng.choice([0.5, 5, 25], (count, 1, 1))
    corners[::7, 2] = corners[::7, 1] + (corners[::7, 0] - corners[::7, 1]) * 1e-3 + 1e-4
    return corners.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3)


SHAPES = {
    "box": made_meshes.box(100, 60, 40),
    "fine box": made_meshes.box(100, 60, 40, cells=9),
    "plate": made_meshes.box(100, 100, 2, cells=5),
    "ribbed block": made_meshes.ribbed_block(),
    "wedge": made_meshes.wedge(),
    "tube": made_meshes.tube(steps=60),
    "shell": made_meshes.spherical_shell(steps=40),
    "two boxes that touch": made_meshes.joined(
        made_meshes.box(10, 10, 10), made_meshes.moved(made_meshes.box(10, 10, 10), shift=(0, 0, 10))
    ),
    "open box": (made_meshes.box(10, 10, 10)[0], made_meshes.box(10, 10, 10)[1][2:]),
    "soup": random_soup(np.random.default_rng(5)),
}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("place", ["as made", "turned", "far away", "tiny", "huge"])
def test_identical_to_brute_force(name, place):
    placed = {
        "as made": {}, "turned": {"rotation": TURNED},
        "far away": {"rotation": TURNED, "shift": (1e6, 2e6, -1e6)},
        "tiny": {"scale": 0.001}, "huge": {"scale": 1000.0, "rotation": TURNED},
    }[place]
    mesh = surface_mesh(*made_meshes.moved(SHAPES[name], **placed))
    samples = surface_samples(mesh, minimum=300)
    field = measure_rays(mesh, samples)
    chosen = np.linspace(0, samples.count - 1, 700).astype(int)
    distance, triangle = brute_force.first_hits(
        mesh, samples.points[chosen], -mesh.normals[samples.triangle[chosen]]
    )
    found, opposite = field.distance[chosen], field.opposite[chosen]
    assert (np.isinf(found) == np.isinf(distance)).all()
    met = np.isfinite(distance)
    assert np.abs(found[met] - distance[met]).max(initial=0) <= 1e-9 * mesh.extent
    # A ray through an edge may name either neighbour; both are then equally far.
    other = met & (opposite != triangle)
    assert other.mean() < 0.2


def test_samples_stand_for_the_whole_area():
    mesh = surface_mesh(*made_meshes.ribbed_block())
    samples = surface_samples(mesh)
    per_triangle = np.bincount(samples.triangle, samples.area)
    assert per_triangle == pytest.approx(mesh.areas, rel=1e-12)
    assert samples.count >= 10_000
    assert np.bincount(samples.triangle).min() >= 4


def test_samples_per_triangle_fall_on_very_fine_meshes():
    mesh = surface_mesh(*made_meshes.box(100, 60, 40, cells=160))
    samples = surface_samples(mesh)
    per_triangle = np.bincount(samples.triangle, minlength=mesh.count)
    assert mesh.count > 300_000
    assert per_triangle.min() >= 1
    assert samples.count <= mesh.count + MAXIMUM_EXTRA_SAMPLES
    assert samples.area.sum() == pytest.approx(mesh.areas.sum())
    # The large triangles keep their four.
    assert per_triangle[mesh.areas > np.quantile(mesh.areas, 0.7)].min() >= 4


def test_samples_have_no_random_seed_in_them():
    mesh = surface_mesh(*made_meshes.tube())
    assert (surface_samples(mesh).points == surface_samples(mesh).points).all()


def test_touching_solids_do_not_measure_the_contact():
    mesh = surface_mesh(*SHAPES["two boxes that touch"])
    field = measure_rays(mesh, surface_samples(mesh))
    assert field.distance.min() == pytest.approx(10, rel=1e-9)


def test_progress_rises_to_one_and_can_stop_it():
    mesh = surface_mesh(*made_meshes.spherical_shell(steps=60))
    samples = surface_samples(mesh)
    seen = []
    measure_rays(mesh, samples, seen.append)
    assert seen == sorted(seen) and seen[-1] == pytest.approx(1.0) and len(seen) > 3

    class Stop(Exception):
        pass

    def stop(fraction):
        raise Stop

    with pytest.raises(Stop):
        measure_rays(mesh, samples, stop)


def test_wedge_angle_is_that_of_the_wedge():
    mesh = surface_mesh(*made_meshes.moved(made_meshes.wedge(30), TURNED))
    field = measure_rays(mesh, surface_samples(mesh))
    slanted = field.wedge_angle[field.nonparallel]
    assert np.degrees(slanted) == pytest.approx(30, abs=1e-6)


@pytest.mark.parametrize("turn", [np.eye(3), TURNED])
def test_a_surface_that_passes_through_itself_is_noticed(turn):
    through = made_meshes.joined(
        made_meshes.box(10, 10, 10), made_meshes.moved(made_meshes.box(10, 10, 10), shift=(5, 5, 5))
    )
    for shape, noticed in [(through, True), *((each, False) for each in SHAPES.values())]:
        mesh = surface_mesh(*made_meshes.moved(shape, turn))
        field = measure_rays(mesh, surface_samples(mesh))
        assert (len(field.entered) > 0) == noticed or not mesh.watertight


@pytest.mark.parametrize("shape", [
    made_meshes.ribbed_block(), made_meshes.wedge(40), made_meshes.tube(steps=45),
    made_meshes.prism([(0, 0), (80, 0), (90, 30), (50, 12), (10, 45)], 25),
])
def test_shares_are_within_half_a_percent_of_a_very_dense_sampling(shape):
    mesh = surface_mesh(*made_meshes.moved(shape, TURNED))
    shares = []
    for minimum in (AnalysisSettings.minimum_samples, 500_000):
        field = measure_rays(mesh, surface_samples(mesh, minimum))
        shares.append(distribution(field, mesh.extent))
    for low, high in REPORTED_SHARES:
        assert shares[0].share(low, high) == pytest.approx(shares[1].share(low, high), abs=0.005)


def test_the_thinnest_place_of_a_tapered_wall_is_its_end():
    # 10 mm at one end, 4 mm at the other, 400 mm long: two triangles to a side.
    mesh = surface_mesh(*made_meshes.moved(
        made_meshes.prism([(0, 0), (400, 0), (400, 4), (0, 10)], 300), TURNED))
    field = measure_rays(mesh, surface_samples(mesh))
    assert field.distance[field.parallel].min() == pytest.approx(4.0, abs=0.01)
