# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures by thickness: their colours, and where the thinnest wall is in them."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.maps.thickness_map import ThicknessMap
from thinpart_workbench.core.rendering.camera import FROM_BEHIND, ISOMETRIC, framing, looking_from
from thinpart_workbench.core.rendering.part_views import PartPictures, thickness_scale, thinnest_wall
from thinpart_workbench.core.rendering.picture import draw

WIDTH, HEIGHT = 180, 120
RIB = 6.0


def shown(shape, thickness=lambda middle: np.full(len(middle), 10.0)):
    """A map of a shape whose facets have the thickness that a function of their middles gives."""
    points, facets = shape
    middle = points[facets].mean(axis=1)
    return ThicknessMap(
        points.astype(np.float32), facets.astype(np.int32), thickness(middle).astype(np.float32),
        np.full(len(facets), -1, dtype=np.int32), np.zeros(len(facets), dtype=np.int32))


def record(*walls, watertight=True):
    """As much of a part record as pictures want, with the ends of walls."""
    return {"descriptors": {"watertight": watertight}, "faces": [
        {"face": f"Face{k + 1}", "witness": wall and {
            "distance": float(np.linalg.norm(np.subtract(*wall))), "points": [list(wall[0]), list(wall[1])]}}
        for k, wall in enumerate(walls)]}


@pytest.mark.parametrize("axes", [ISOMETRIC, FROM_BEHIND] + [
    looking_from(np.array(towards)) for towards in ((1.0, 2.0, 3.0), (0.0, 0.0, 5.0), (0.0, 0.0, -1.0))])
def test_axes_are_a_rotation(axes):
    assert axes @ axes.T == pytest.approx(np.eye(3)) and np.linalg.det(axes) == pytest.approx(1.0)


def test_the_two_views_show_every_side_of_a_box():
    normals = np.vstack([np.eye(3), -np.eye(3)])
    assert ((normals @ ISOMETRIC[2] > 0.1) != (normals @ FROM_BEHIND[2] > 0.1)).all()


def test_a_point_is_drawn_where_it_is_projected():
    points, facets = made_meshes.box(10, 10, 10)
    camera = framing(points, ISOMETRIC, WIDTH, HEIGHT)
    right, down, _ = camera.project(np.array([10.0, 0.0, 10.0]))
    assert (right, down) == pytest.approx((WIDTH / 2, HEIGHT / 2), abs=1e-6)
    marked = made_meshes.joined((points, facets), made_meshes.moved(
        made_meshes.box(2, 2, 2), shift=(4, 4, 10.001)))
    normals = np.cross(*(np.diff(marked[0][marked[1]], axis=1).transpose(1, 0, 2)))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    colours = np.zeros((len(normals), 3))
    colours[len(facets):, 0] = 1.0
    image = draw(marked[0][marked[1]], normals, colours, camera)
    place = camera.project(np.array([5.0, 5.0, 12.0]))[:2].astype(int)
    assert image[place[1], place[0], 0] > 200 and image[..., 0].astype(bool).mean() < 0.05


def test_the_scale_leaves_out_the_thickest_few():
    points, facets = made_meshes.box(10, 10, 10, cells=10)
    values = np.linspace(2.0, 10.0, len(facets))
    values[-10:] = 500.0
    scale = thickness_scale(shown((points, facets), lambda middle: values), record())
    assert scale.low == pytest.approx(2.16, abs=0.02) and scale.high == pytest.approx(9.84, abs=0.02)
    assert thickness_scale(shown((points, facets), lambda middle: np.full(len(middle), np.nan)), record()) is None


def test_the_thinnest_wall_is_the_least_of_all_faces():
    walls = record(None, ((0, 0, 0), (0, 0, 3)), ((0, 0, 0), (0, 2, 0)), None)
    assert thinnest_wall(walls)["distance"] == 2.0
    assert thinnest_wall(record(None)) is None


@pytest.mark.parametrize("turn", [(0, 0, 0), (1.0, 0.4, -2.0), (0, 0, 2.2), (3.0, 0, 0)])
def test_the_thinnest_wall_is_seen_in_its_picture(turn):
    rotation = Rotation.from_rotvec(turn).as_matrix()
    shape = made_meshes.moved(made_meshes.ribbed_block(rib=RIB), rotation)
    ends = [rotation @ (30.0 - side * RIB / 2, 55.0, 40.0) for side in (-1, 1)]
    pictures = PartPictures(shown(shape), record(ends))
    view = pictures.views(WIDTH, HEIGHT)[-1]
    assert view.name == "thinnest"
    for right, down in (view.thinnest.point, view.thinnest.opposite):
        assert 0.1 * WIDTH < right < 0.9 * WIDTH and 0.1 * HEIGHT < down < 0.9 * HEIGHT
    right, down = map(int, view.thinnest.point)
    assert view.pixels[down, right, 3] == 255
    length = np.hypot(*np.subtract(view.thinnest.point, view.thinnest.opposite))
    assert length > 2.0  # it is not looked at along itself
    assert (view.pixels[..., 3] > 0).mean() > 0.2


def test_a_wall_is_marked_only_where_nothing_lies_before_it():
    box = made_meshes.box(10, 10, 10)
    above = ((5.0, 5.0, 10.0), (5.0, 5.0, 0.0))
    front, back, _ = PartPictures(shown(box), record(above)).views(WIDTH, HEIGHT)
    assert front.thinnest is not None and back.thinnest is None
    front, back, _ = PartPictures(shown(box), record(above[::-1])).views(WIDTH, HEIGHT)
    assert front.thinnest is None and back.thinnest is not None
    roofed = made_meshes.joined(box, made_meshes.moved(made_meshes.box(60, 60, 1), shift=(-25, -25, 20)))
    front, _, _ = PartPictures(shown(roofed), record(above)).views(WIDTH, HEIGHT)
    assert front.thinnest is None


def test_without_any_wall_there_are_two_pictures_in_the_colour_of_the_unmeasured():
    pictures = PartPictures(shown(made_meshes.box(5, 5, 5), lambda middle: np.full(len(middle), np.nan)),
                            record(None))
    views = pictures.views(WIDTH, HEIGHT)
    assert [view.name for view in views] == ["front", "back"] and pictures.scale is None
    seen = views[0].pixels[views[0].pixels[..., 3] == 255][:, :3]
    assert (seen[:, 0] == seen[:, 1]).all() and (seen[:, 1] == seen[:, 2]).all()
    assert pictures.small(60, 40).shape == (40, 60, 4)
