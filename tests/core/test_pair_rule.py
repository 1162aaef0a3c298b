# SPDX-License-Identifier: LGPL-2.1-or-later
import brute_force
import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.thickness.pair_rule import pairs_of

PAIRS, RAYS = AnalysisSettings(measure="pairs"), AnalysisSettings()


@pytest.mark.parametrize("shape", [
    made_meshes.box(10, 10, 2, cells=2), made_meshes.wedge(), made_meshes.ribbed_block(),
    made_meshes.tube(steps=22), made_meshes.spherical_shell(steps=14),
])
def test_same_pairs_as_a_literal_loop(shape):
    mesh = surface_mesh(*shape)
    parallel, slanted = pairs_of(mesh, np.arange(mesh.count))
    expected = brute_force.pairs(mesh)
    for found, loop in zip((parallel, slanted), expected):
        mine = dict(zip(zip(found.first.tolist(), found.second.tolist()), found.distance))
        assert mine.keys() == loop.keys()
        assert all(mine[pair] == pytest.approx(loop[pair], rel=1e-9) for pair in loop)


@pytest.mark.parametrize("shape", [made_meshes.box(100, 100, 2), made_meshes.box(30, 20, 10)])
def test_agrees_with_rays_on_plates_and_convex_parts(shape):
    mesh = surface_mesh(*shape)
    pairs, rays = (measure(mesh, each).descriptors.distribution for each in (PAIRS, RAYS))
    assert pairs.bins.tolist() == rays.bins.tolist()
    assert pairs.area == pytest.approx(rays.area, abs=1e-9)


def test_sees_across_a_void_as_the_paper_does_and_rays_do_not():
    plates = made_meshes.joined(
        made_meshes.box(100, 100, 2), made_meshes.moved(made_meshes.box(100, 100, 2),
                                                        shift=(0, 0, 32))
    )
    mesh = surface_mesh(*plates)
    rays = measure(mesh, RAYS)
    assert set(np.round(rays.field.distance, 9)) == {2.0, 100.0}
    diagonal = rays.descriptors.box.diagonal
    # Lower side of the one, upper side of the other: 34 mm with a void between.
    assert measure(mesh, PAIRS).descriptors.distribution.share(
        33 / diagonal, 35 / diagonal) > 0.4
