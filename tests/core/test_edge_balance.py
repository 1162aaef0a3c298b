# SPDX-License-Identifier: LGPL-2.1-or-later
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.edge_balance import paired_sides, shared_sides, slit_area
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure

UNTURNED = np.eye(3)
TURNED = Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()


def _box_of_patches(turn=UNTURNED):
    """A box whose top is cut finer than its sides: its long edges meet several short ones."""
    coarse, fine = made_meshes.box(100, 60, 10), made_meshes.box(100, 60, 10, cells=4)
    kept = []
    for (points, triangles), is_top in ((coarse, False), (fine, True)):
        on_top = (points[triangles][:, :, 2] == 10).all(axis=1)
        kept.append((points, triangles[on_top == is_top]))
    return made_meshes.moved(made_meshes.joined(*kept), turn)


@pytest.mark.parametrize("turn", [np.eye(3), TURNED])
def test_edges_that_meet_several_short_ones_close_the_surface(turn):
    mesh = surface_mesh(*_box_of_patches(turn))
    assert mesh.watertight and mesh.cracked
    assert not any("open" in warning for warning in mesh.warnings)
    measurement = measure(mesh, AnalysisSettings())
    assert measurement.descriptors.volume == pytest.approx(100 * 60 * 10, rel=1e-9)
    assert measurement.descriptors.unmet == 0.0


def test_a_missing_triangle_still_leaves_it_open():
    points, triangles = _box_of_patches()
    for missing in (0, len(triangles) - 1):
        assert not surface_mesh(points, np.delete(triangles, missing, axis=0)).watertight


def test_a_slit_wider_than_the_tolerance_leaves_it_open():
    points, triangles = _box_of_patches()
    lifted = points.copy()
    lifted[(points[:, 2] == 10) & (points[:, 0] == 50)] += [0, 0, 0.01]
    assert not surface_mesh(lifted, triangles).watertight


@pytest.mark.parametrize("spread", [1, 30_000], ids=["few vertices", "many vertices"])
def test_sides_are_paired_on_closed_surfaces_only(spread):
    _, closed = made_meshes.tube()
    closed = closed * spread
    assert all((one == other).all() for one, other in zip(paired_sides(closed), shared_sides(closed)))
    for triangles in (closed[1:], closed[2:], np.concatenate([closed, closed[:1]]), np.concatenate([closed, closed]),
                      np.concatenate([closed, [[0, 0, spread]]]), np.concatenate([closed, closed[:1, ::-1], closed[:1]])):
        assert paired_sides(triangles) is None


def _welded_block(turn=UNTURNED, cells=20):
    mesh = surface_mesh(*made_meshes.moved(made_meshes.box(100, 60, 10, cells=cells), turn))
    return mesh.vertices, mesh.triangles


@pytest.mark.parametrize("turn", [UNTURNED, TURNED])
def test_the_area_of_what_is_missing_is_found(turn):
    points, triangles = _welded_block(turn)
    left_out = [0, 700, len(triangles) - 1]
    corners = points[triangles[left_out]]
    missing = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    assert slit_area(points, triangles) == 0.0
    assert slit_area(points, triangles[1:]) == pytest.approx(missing[0])
    assert slit_area(points, np.delete(triangles, left_out, axis=0)) == pytest.approx(missing.sum())


def test_openings_that_touch_or_turn_over_are_no_slits():
    points, triangles = _welded_block()
    uses = np.bincount(triangles.ravel())
    around = np.flatnonzero((triangles == uses.argmax()).any(axis=1))
    apart = next(other for other in around[1:] if len(np.intersect1d(triangles[around[0]], triangles[other])) == 1)
    assert slit_area(points, np.delete(triangles, [around[0], apart], axis=0)) == np.inf
    turned = triangles.copy()
    turned[5] = turned[5, ::-1]
    assert slit_area(points, turned) == np.inf


def test_a_slit_closes_the_mesh_of_a_solid_and_of_nothing_else():
    """A triangle has another within it, a millionth as large, that is missing, as those that OCC leaves out."""
    points, triangles = _welded_block(cells=1)
    corners = triangles[0]
    middle = points[corners].mean(axis=0)
    inner = np.arange(3) + len(points)
    points = np.concatenate([points, middle + 1e-3 * (points[corners] - middle)])
    pieces = [piece for k in range(3) for piece in (
        [corners[k], corners[k - 2], inner[k - 2]], [corners[k], inner[k - 2], inner[k]])]
    around, missing = np.concatenate([triangles[1:], pieces]), triangles[1:]
    faces = np.zeros(len(around), dtype=int)
    assert surface_mesh(points, around, faces, of_solid=True).watertight
    assert not surface_mesh(points, around, faces).watertight
    assert not surface_mesh(points, missing, faces[:len(missing)], of_solid=True).watertight
