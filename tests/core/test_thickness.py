# SPDX-License-Identifier: LGPL-2.1-or-later
import brute_force
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.descriptor_table import REPORTED_SHARES
from thinpart_workbench.core.descriptors.distribution import distribution
from thinpart_workbench.core.mesh.sampling import LEAST_ON_FACE, surface_samples
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.walls.thickness_field import measure_rays
from thinpart_workbench.core.walls.walls import walls_under

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
WATERTIGHT = len(SHAPES) - 2
"""All but the open box and the soup."""


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
    walls, reach = walls_under(mesh, InwardRays(mesh), samples)
    chosen = np.linspace(0, samples.count - 1, 700).astype(int)
    distance, _ = brute_force.first_hits(mesh, samples.points[chosen], -samples.normals[chosen])
    found, opposite = reach[chosen], walls.opposite[chosen]
    assert (np.isinf(found) == np.isinf(distance)).all()
    met = np.isfinite(distance)
    assert np.abs(found[met] - distance[met]).max(initial=0) <= 1e-9 * mesh.extent
    # A ray through an edge may name either neighbour: the point that it meets is on both.
    there = samples.points[chosen] - samples.normals[chosen] * np.where(met, found, 0.0)[:, None]
    off = np.einsum("ij,ij->i", there - mesh.corners[opposite, 0], mesh.normals[opposite])
    assert ((opposite >= 0) == met).all() and np.abs(off[met]).max(initial=0) <= 1e-9 * mesh.extent


def test_samples_stand_for_the_whole_area():
    mesh = surface_mesh(*made_meshes.ribbed_block())
    samples = surface_samples(mesh)
    per_triangle = np.bincount(samples.triangle, samples.area)
    assert per_triangle == pytest.approx(mesh.areas, rel=1e-12)
    assert samples.count >= 10_000
    assert np.bincount(samples.triangle).min() >= 4


def test_samples_do_not_grow_with_the_triangles():
    mesh = surface_mesh(*made_meshes.box(100, 60, 40, cells=160))
    samples = surface_samples(mesh)
    assert mesh.count > 300_000
    assert samples.count == pytest.approx(AnalysisSettings.minimum_samples, rel=1e-3)
    faces = np.bincount(mesh.face_of_triangle[samples.triangle], samples.area)
    assert faces == pytest.approx(np.bincount(mesh.face_of_triangle, mesh.areas), rel=1e-9)


def test_no_face_of_a_fine_mesh_goes_unseen():
    # Of a million, a plate's share would be none.
    points, triangles = made_meshes.joined(
        made_meshes.box(100, 60, 40, cells=160), made_meshes.moved(made_meshes.box(0.1, 0.1, 0.1), shift=(200, 0, 0)))
    faces = np.append(np.zeros(len(triangles) - 12, dtype=np.int64), np.arange(1, 13))
    mesh = surface_mesh(points, triangles, faces)
    samples = surface_samples(mesh, 5000)
    assert (np.bincount(mesh.face_of_triangle[samples.triangle], minlength=13)[1:] == LEAST_ON_FACE).all()
    assert samples.area.sum() == pytest.approx(mesh.areas.sum(), rel=1e-9)


def test_more_faces_than_samples_share_them_by_area():
    points, triangles = made_meshes.box(100, 60, 40, cells=20)
    mesh = surface_mesh(points, triangles, np.arange(len(triangles)))
    samples = surface_samples(mesh, 1000)
    assert mesh.count > 4000 and 900 <= samples.count <= 1100
    assert samples.area.sum() == pytest.approx(mesh.areas.sum(), rel=2e-3)


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
    seen, expected = [], []
    for shape, noticed in [(through, True), *((each, False) for each in SHAPES.values())]:
        mesh = surface_mesh(*made_meshes.moved(shape, turn))
        field = measure_rays(mesh, surface_samples(mesh))
        if mesh.watertight:  # of what is open, nothing can be said
            seen.append(len(field.entered) > 0)
            expected.append(noticed)
    assert seen == expected and len(seen) == WATERTIGHT + 1


@pytest.mark.parametrize("shape", [
    made_meshes.ribbed_block(), made_meshes.wedge(40), made_meshes.tube(steps=45),
    made_meshes.prism([(0, 0), (80, 0), (90, 30), (50, 12), (10, 45)], 25),
])
def test_shares_are_within_half_a_percent_of_a_very_dense_sampling(shape):
    mesh = surface_mesh(*made_meshes.moved(shape, TURNED))
    shares = []
    for minimum in (AnalysisSettings.minimum_samples, 500_000):
        field = measure_rays(mesh, surface_samples(mesh, minimum))
        shares.append(distribution(field, mesh.extent, mesh.extent))
    for low, high in REPORTED_SHARES:
        assert shares[0].share(low, high) == pytest.approx(shares[1].share(low, high), abs=0.005)


def test_the_thinnest_place_of_a_tapered_wall_is_its_end():
    # 10 mm at one end, 4 mm at the other, 400 mm long: two triangles to a side.
    mesh = surface_mesh(*made_meshes.moved(
        made_meshes.prism([(0, 0), (400, 0), (400, 4), (0, 10)], 300), TURNED))
    field = measure_rays(mesh, surface_samples(mesh))
    assert field.distance[field.parallel].min() == pytest.approx(4.0, abs=0.01)
