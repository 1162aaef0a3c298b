# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures show the part: what is in front, in three dimensions, thin faces coloured."""

import brute_force
import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rendering.camera import MARGIN
from thinpart_workbench.core.rendering.picture import HEIGHT, PLAIN, WIDTH, picture
from thinpart_workbench.core.rendering.rasterizer import nearest_triangles

RED, ORANGE = (0.84, 0.15, 0.12), (0.96, 0.60, 0.11)
SHAPES = {
    "cube": made_meshes.box(10, 10, 10), "fine box": made_meshes.box(30, 20, 10, cells=6),
    "ribbed block": made_meshes.ribbed_block(), "wedge": made_meshes.wedge(),
    "tube": made_meshes.tube(steps=24), "shell": made_meshes.spherical_shell(steps=16),
    "one behind another": made_meshes.joined(
        made_meshes.box(10, 10, 10), made_meshes.moved(made_meshes.box(10, 10, 10), shift=(3, -14, 5))),
}


def shown(shape, face_colours=None):
    return picture(surface_mesh(*shape), face_colours)


def shades(image, least=500):
    """Colours that cover at least so many pixels: of sides, not of edges."""
    solid = image[image[..., 3] == 255][:, :3]
    colours, count = np.unique(solid, axis=0, return_counts=True)
    return colours[count >= least]


def box_of(image):
    """Rows and columns between which there is something."""
    rows, columns = np.flatnonzero(image[..., 3].any(axis=1)), np.flatnonzero(image[..., 3].any(axis=0))
    return rows[0], rows[-1], columns[0], columns[-1]


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("turn", [(0, 0, 0), (0.4, -0.7, 1.1), (2.0, 0.3, -0.8), (1e-4, 1e-3, 0)])
def test_what_is_nearest_is_shown(name, turn):
    points, triangles = made_meshes.moved(SHAPES[name], Rotation.from_rotvec(turn).as_matrix())
    points = (points - points.mean(axis=0)) / np.ptp(points, axis=0).max() * 55 + [30.2, 24.1, 0]
    corners = points[triangles]
    sides = np.diff(corners[..., :2], axis=1)
    corners = corners[np.abs(np.linalg.det(sides)) > 1e-9]
    triangle, depth = nearest_triangles(corners, 60, 48)
    expected = brute_force.nearest_depth(corners, 60, 48)
    covered = np.isfinite(expected)
    assert covered.any() and ((triangle >= 0) == np.isfinite(depth)).all()
    # Just on an outline it may be one or the other.
    assert np.count_nonzero((triangle >= 0) != covered) <= 3
    both = covered & (triangle >= 0)
    assert depth[both] == pytest.approx(expected[both], abs=1e-3)


def test_more_triangles_than_fit_at_once():
    one = np.array([[-100.0, -100.0, 0.0], [900.0, -100.0, 0.0], [-100.0, 900.0, 0.0]])
    many = one + np.linspace(0.0, 1.0, 40)[:, None, None] * [0.0, 0.0, 1.0]
    triangle, depth = nearest_triangles(many[[*range(1, 40, 2), *range(0, 40, 2)]], 200, 150)
    assert (triangle == 19).all() and depth == pytest.approx(1.0)


def test_no_gap_between_triangles():
    mesh = surface_mesh(*made_meshes.box(100, 100, 40, cells=45))
    image = picture(mesh)
    inside = image[30:90, 50:110, 3]
    assert (inside == 255).all()
    assert len(shades(image)) == 3


@pytest.mark.parametrize("place", [{}, {"scale": 1000.0}, {"scale": 0.001}, {"shift": (5000, 1e4, -300)}])
def test_a_cube_has_three_shades_brightest_above_and_darkest_on_the_right(place):
    image = shown(made_meshes.moved(made_meshes.box(10, 10, 10), **place))
    assert image.shape == (HEIGHT, WIDTH, 4) and image.dtype == np.uint8
    assert len(shades(image)) == 3
    above, left, right = (image[row, column].astype(int) for row, column in (
        (30, 80), (75, 55), (75, 105)))
    assert above[0] > left[0] + 20 > right[0] + 40
    assert (above / above[2] == pytest.approx(np.append(PLAIN, PLAIN[2] / above[2] * 255) / PLAIN[2],
                                              abs=0.02))
    assert (image[0, 0] == 0).all() and (image[:, :, 3] == 0).mean() > 0.3


@pytest.mark.parametrize("size", [(10, 10, 10), (2, 2, 100), (100, 2, 2), (100, 80, 1), (1, 80, 100)])
def test_a_part_fills_the_picture_whatever_its_form(size):
    top, bottom, left, right = box_of(shown(made_meshes.box(*size)))
    margin = MARGIN * HEIGHT
    assert top >= margin - 1 and left >= margin - 1
    assert abs(top - (HEIGHT - 1 - bottom)) <= 1 and abs(left - (WIDTH - 1 - right)) <= 1
    assert min(top, left) <= margin + 1


def test_z_is_upwards():
    top, bottom, left, right = box_of(shown(made_meshes.box(5, 5, 100)))
    assert bottom - top > 8 * (right - left)
    image = shown(made_meshes.joined(
        made_meshes.box(60, 60, 5), made_meshes.moved(made_meshes.box(10, 10, 50), shift=(25, 25, 5.1))))
    wide = (image[..., 3] > 0).sum(axis=1)
    assert wide[10:40].max() < 0.4 * wide.max() and wide.argmax() > 60


def test_faces_have_their_colours():
    mesh = surface_mesh(*made_meshes.box(10, 10, 10))
    top = mesh.face_of_triangle[mesh.normals[:, 2].argmax()]
    front = mesh.face_of_triangle[mesh.normals[:, 1].argmin()]
    image = picture(mesh, {int(top): RED, int(front): ORANGE, 77: RED})
    above, left, right = (image[place][:3] / image[place][0] for place in ((30, 80), (75, 55), (75, 105)))
    assert above == pytest.approx(np.array(RED) / RED[0], abs=0.02)
    assert left == pytest.approx(np.array(ORANGE) / ORANGE[0], abs=0.02)
    assert right == pytest.approx(np.array(PLAIN) / PLAIN[0], abs=0.02)


def test_edges_are_drawn_where_the_surface_bends_and_not_on_a_curved_one():
    # The edge towards the viewer runs down the middle of the picture.
    row = shown(made_meshes.box(10, 10, 10))[75, 60:100, 0].astype(int)
    darkest = row.argmin()
    assert darkest in (19, 20) and len(set(row[:darkest])) == len(set(row[darkest + 1:])) == 1
    assert row[darkest] < 0.9 * min(row[0], row[-1])
    ball = shown(made_meshes.sphere(10, 180))[40:80, 60:100]
    assert (ball[..., 3] == 255).all()
    for axis in (0, 1):
        assert np.abs(np.diff(ball[..., 0].astype(int), axis=axis)).max() < 12


def test_a_step_is_an_edge_though_both_levels_face_the_same_way():
    image = shown(made_meshes.prism([(0, 0), (60, 0), (60, 12), (30, 12), (30, 20), (0, 20)], 80))
    assert len(shades(image, least=100)) == 3
    shifted = made_meshes.joined(
        made_meshes.box(60, 60, 4), made_meshes.moved(made_meshes.box(20, 20, 4), shift=(20, 20, 12)))
    image = shown(shifted)
    # Along a column through both plates there is a dark line where the upper one ends.
    column = image[:, 80, 0].astype(int)[image[:, 80, 3] == 255]
    assert (np.diff(np.flatnonzero(column < 0.75 * column.max())) > 3).sum() >= 2


def test_of_an_open_surface_the_inside_is_seen():
    points, triangles = made_meshes.box(10, 10, 10)
    mesh = surface_mesh(points, triangles)
    opened = surface_mesh(points, triangles[:-2])  # the last two are the top
    assert mesh.watertight and not opened.watertight
    assert np.count_nonzero(picture(opened)[..., 3]) == np.count_nonzero(picture(mesh)[..., 3])
    assert (picture(opened)[30, 80] != picture(mesh)[30, 80]).any()


def test_a_sheet_that_is_seen_edge_on_gives_an_empty_picture():
    sheet = np.array([[0.0, 0, 0], [1, -1, 1], [1, 1, 0]]), np.array([[0, 1, 2]])
    assert not shown(sheet).any()


def test_the_same_part_gives_the_same_picture_wherever_it_stands():
    first = shown(made_meshes.ribbed_block())
    assert (first == shown(made_meshes.ribbed_block())).all()
    moved = shown(made_meshes.moved(made_meshes.ribbed_block(), shift=(640, 256, -128), scale=8.0))
    assert np.abs(first.astype(int) - moved).max() <= 1
