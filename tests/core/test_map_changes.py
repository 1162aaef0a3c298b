# SPDX-License-Identifier: LGPL-2.1-or-later
"""What became thinner between two maps of a part."""

import made_meshes
import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.map_changes import thinner_walls
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure


def of(mesh):
    return thickness_map(measure(surface_mesh(*mesh), AnalysisSettings()))


def pocketed(left, right):
    """A block of 100 x 40 x 20 with a floor of its own thickness under each of two pockets."""
    profile = np.array([(0, 0), (100, 0), (100, 20), (80, 20), (80, right), (55, right), (55, 20), (45, 20), (45, left),
                        (20, left), (20, 20), (0, 20)], dtype=float)
    return made_meshes.prism(profile, 40.0)


def test_what_stayed_as_it_was_is_not_listed():
    assert thinner_walls(of(pocketed(4, 6)), of(pocketed(4, 6))) == []
    assert thinner_walls(of(made_meshes.tube()), of(made_meshes.tube(steps=72))) == []


def test_a_shorter_pad_is_one_wall_with_both_of_its_sides():
    wall, = thinner_walls(of(made_meshes.box(60, 40, 5)), of(made_meshes.box(60, 40, 3)))
    assert (wall.before, wall.now, wall.least) == pytest.approx((5.0, 3.0, 3.0), rel=0.02)
    assert wall.area == pytest.approx(2 * 60 * 40, rel=0.1)
    one, other = (np.asarray(end) for end in wall.ends)
    assert np.linalg.norm(one - other) == pytest.approx(3.0, rel=0.02)


def test_deeper_pockets_are_walls_of_their_own_and_thicker_ones_are_none():
    before = of(pocketed(6, 8))
    left, = (wall for wall in thinner_walls(before, of(pocketed(3, 8))) if wall.before < 10.0)
    assert (left.before, left.now) == pytest.approx((6.0, 3.0), rel=0.03)
    walls = thinner_walls(before, of(pocketed(3, 6)))
    floors = sorted((wall.before, wall.now) for wall in walls if wall.before < 10.0)
    assert floors == [pytest.approx((6.0, 3.0), rel=0.03), pytest.approx((8.0, 6.0), rel=0.03)]
    # Beside the pockets, what was solid from end to end is a wall where they are deeper.
    assert all(wall.before > 50.0 and wall.now < 0.6 * wall.before for wall in walls if wall.before >= 10.0)
    assert thinner_walls(before, of(pocketed(7, 9))) == []


def test_a_wall_of_which_both_sides_moved_is_found():
    before = of(made_meshes.tube(20.0, 17.0))
    wall, = thinner_walls(before, of(made_meshes.tube(19.5, 18.0)))
    assert (wall.before, wall.now) == pytest.approx((3.0, 1.5), rel=0.05)


def test_a_map_without_walls_has_nothing_to_compare():
    plate = of(made_meshes.box(60, 40, 5))
    unknown = np.full(plate.count, np.nan, dtype=np.float32)
    nothing = type(plate)(plate.points, plate.facets, unknown, plate.opposite, plate.face)
    assert thinner_walls(nothing, plate) == thinner_walls(plate, nothing) == []
