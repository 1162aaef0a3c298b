# SPDX-License-Identifier: LGPL-2.1-or-later
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.tolerances import TOLERANCES

TURNED = Rotation.from_rotvec([0.5, 0.7, -0.3]).as_matrix()


def _strips(length=400.0, width=60.0, height=2.0, count=3000):
    """A plate whose sides are cut into slender triangles, 400 mm long and 0.02 mm wide."""
    y = np.linspace(0, width, count)
    outline = np.concatenate([
        np.column_stack([y, np.zeros(count)]), np.column_stack([y[::-1], np.full(count, height)])])
    points = np.concatenate([np.column_stack([np.full(len(outline), x), outline])
                             for x in (0.0, length)])
    around = len(outline)
    i = np.arange(around)
    j = (i + 1) % around
    sides = np.concatenate([np.stack([i, j, j + around], 1), np.stack([i, j + around, i + around], 1)])
    k = np.arange(count - 1)
    other = around - 1 - k
    caps = np.concatenate([np.stack([k, other, k + 1], 1), np.stack([k + 1, other, other - 1], 1)])
    return points, np.concatenate([sides[:, ::-1], caps[:, ::-1], caps + around])


def _rounded(shape):
    return shape[0].astype(np.float32).astype(np.float64), shape[1]


def test_rounding_does_not_tilt_the_triangles_of_a_plane():
    shape = made_meshes.moved(_strips(), TURNED)
    sides = np.array([[1, 0, 0], [0, 1, 0], [0, 0, 1]]) @ TURNED.T
    corners = _rounded(shape)[0][shape[1]]
    rough = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    rough /= np.linalg.norm(rough, axis=1)[:, None]
    mesh = surface_mesh(*_rounded(shape))
    for normals, limit in ((rough, None), (mesh.normals, 1e-4)):
        tilt = np.arccos(np.clip(np.abs(normals @ sides.T).max(axis=1), 0, 1)).max()
        assert tilt < limit if limit else np.degrees(tilt) > 0.05
    assert mesh.watertight
    descriptors = measure(mesh, AnalysisSettings()).descriptors
    assert descriptors.distribution.nonparallel == 0.0
    assert descriptors.volume == pytest.approx(400 * 60 * 2, rel=1e-5)


@pytest.mark.parametrize("shape", [
    made_meshes.tube(), made_meshes.spherical_shell(steps=60), made_meshes.wedge(12),
    made_meshes.ribbed_block(), made_meshes.box(100, 60, 40, cells=9),
])
@pytest.mark.parametrize("rounding", [False, True])
def test_no_point_moves_farther_than_rounding(shape, rounding):
    turned = made_meshes.moved(shape, TURNED, shift=(50, 20, 0))
    mesh = surface_mesh(*(_rounded(turned) if rounding else turned))
    moved = mesh.corners + mesh.origin - turned[0][turned[1]]
    limit = 8 * TOLERANCES.flat if rounding else 1e-13
    assert np.abs(moved).max() <= limit * np.linalg.norm([100, 60, 40])


def test_a_curved_surface_of_small_facets_stays_curved():
    shape = made_meshes.moved(made_meshes.tube(steps=1200), TURNED)
    mesh = surface_mesh(*_rounded(shape))
    radius = np.linalg.norm((mesh.vertices + mesh.origin) @ TURNED, axis=1)
    expected = np.linalg.norm(_rounded(shape)[0] @ TURNED, axis=1)
    assert np.sort(radius) == pytest.approx(np.sort(expected), abs=1e-4)
    assert len(np.unique(mesh.normals.round(6), axis=0)) > 1200


def test_a_step_higher_than_rounding_stays():
    step = 1e-5 * 100
    shape = made_meshes.prism([(0, 0), (100, 0), (100, 20), (50, 20), (50, 20 + step), (0, 20 + step)], 60)
    mesh = surface_mesh(*made_meshes.moved(shape, TURNED))
    volume = measure(mesh, AnalysisSettings()).descriptors.volume
    assert volume == pytest.approx((100 * 20 + 50 * step) * 60, rel=1e-9)
