# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall regions of parts whose walls are known."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.core.thickness.region_shape import region_shape
from thinpart_workbench.core.thickness.wall_graph import wall_links, wall_points
from thinpart_workbench.core.thickness.wall_regions import wall_regions, with_thinnest
from thinpart_workbench.core.walls.face_thickness import Witness

PLACES = {
    "as made": {},
    "turned and small": {"rotation": Rotation.from_rotvec([0.4, -1.1, 0.7]).as_matrix(), "scale": 0.01},
    "far away": {"shift": (1e5, -2e5, 5e4)},
}
LENGTH_TOLERANCE, AREA_TOLERANCE, VOLUME_TOLERANCE = 0.03, 0.03, 0.04
"""Of lengths and thicknesses, of areas, and of shares of the volume: points stand for the surface."""


def i_beam(height=100.0, width=60.0, web=5.0, flange=8.0, length=300.0):
    right = [(width / 2, 0), (width / 2, flange), (web / 2, flange), (web / 2, height - flange),
             (width / 2, height - flange), (width / 2, height)]
    return made_meshes.prism(right + [(-x, y) for x, y in reversed(right)], length)


def heat_sink(fins=6, fin=1.5, gap=4.0, height=25.0, base=5.0, length=60.0, thicker=1.0):
    """Each fin is so many times as thick as the one before."""
    right = np.cumsum(fin * thicker ** np.arange(fins) + gap) - gap
    outline = [(0.0, 0.0), (right[-1], 0.0)]
    for number in reversed(range(fins)):
        left = right[number] - fin * thicker**number
        outline += [(right[number], base), (right[number], base + height), (left, base + height), (left, base)]
    return made_meshes.prism([outline[0], outline[1], *outline[3:-1]], length)


def profile(*outline, length=200.0):
    return made_meshes.prism(outline, length)


def washer(inner=5.25, outer=10.0, height=2.0):
    return made_meshes.revolved([(inner, 0), (outer, 0), (outer, height), (inner, height)])


def ring(radius=30.0, wire=4.0):
    turn = np.linspace(0, 2 * np.pi, 181)[:-1]
    return made_meshes.wire(np.column_stack([radius * np.cos(turn), radius * np.sin(turn), 0 * turn]), wire, closed=True)


def spring(radius=15.0, wire=1.0, pitch=6.0, turns=6):
    turn = np.linspace(0, 2 * np.pi * turns, 60 * turns)
    return made_meshes.wire(
        np.column_stack([radius * np.cos(turn), radius * np.sin(turn), pitch * turn / (2 * np.pi)]), wire)


def shaft():
    return made_meshes.revolved([(0, 0), (8, 0), (8, 40), (15, 40), (15, 120), (5, 120), (5, 150), (0, 150)])


L_PROFILE = profile((0, 0), (50, 0), (50, 3), (3, 3), (3, 50), (0, 50))
U_PROFILE = profile((0, 0), (60, 0), (60, 40), (57, 40), (57, 3), (3, 3), (3, 40), (0, 40))
SHORT_L = profile((0, 0), (100, 0), (100, 3), (3, 3), (3, 100), (0, 100), length=20)
TURNS = 6 * np.hypot(2 * np.pi * 15, 6)

# By name: the mesh, and kind, thickness, length, developed width and share of the volume of each region.
KNOWN = {
    "plate": (made_meshes.box(200, 100, 2), [("plate", 2, 200, 100, 1)]),
    "fine plate": (made_meshes.box(200, 100, 2, cells=12), [("plate", 2, 200, 100, 1)]),
    "cube": (made_meshes.box(10, 10, 10), [("block", 10, 10, 30, 1)]),
    "box": (made_meshes.box(40, 30, 20), [("block", 20, 40, 30, 1)]),
    "flat bar": (made_meshes.box(100, 20, 10), [("bar", 10, 100, 20, 1)]),
    "square bar": (made_meshes.box(10, 10, 100), [("bar", 10, 100, 20, 1)]),
    "closed box": (made_meshes.joined(made_meshes.box(100, 100, 100), made_meshes.inverted(
        made_meshes.moved(made_meshes.box(96, 96, 96), shift=(2, 2, 2)))), [("plate", 2, None, None, 0.96)]),
    "tube": (made_meshes.tube(20, 18, 60), [("tube", 2, 60, 2 * np.pi * 19, 1)]),
    "short tube": (made_meshes.tube(20, 18, 6), [("tube", 2, 6, 2 * np.pi * 19, 1)]),
    "L profile": (L_PROFILE, [("plate", 3, 200, 94, 0.97)]),
    "short L profile": (SHORT_L, [("plate", 3, 200, 19.5, 0.985)]),
    "U profile": (U_PROFILE, [("plate", 3, 200, 128, 0.955)]),
    "I beam": (i_beam(), [("plate", 5, 300, 84, 0.304), ("plate", 8, 300, 55, 0.319), ("plate", 8, 300, 55, 0.319)]),
    "ribbed block": (made_meshes.ribbed_block(60, 40, 2, 20, 100),
                     [("plate", 2, 100, 20, 0.016), ("block", 40, 100, 58, 0.95)]),
    "heat sink": (heat_sink(), [("plate", 1.5, 60, 25, 0.101)] * 6 + [("plate", 5, 60, None, None)]),
    "shaft": (shaft(), [
        ("bar", 10, 30, 5 * np.pi, 0.035), ("bar", 16, 40, 8 * np.pi, 0.120), ("bar", 30, None, 15 * np.pi, None)]),
    "torus": (ring(), [("bar", 8, 60 * np.pi, 4 * np.pi, 1)]),
    "spring": (spring(), [("bar", 2, TURNS, np.pi, 1)]),
    "washer": (washer(), [("plate", 2, 15.25 * np.pi, 4.75, 1)]),
    "washer M3": (washer(1.6, 3.5, 0.5), [("plate", 0.5, 7, None, 1)]),
    "low tube": (washer(8, 10, 3), [("bar", 2, 18 * np.pi, None, None)]),
    "wall round a bore": (made_meshes.revolved(
        [(0, 0), (20, 0), (20, 25), (5, 25), (5, 28), (3, 28), (3, 25), (0, 25)]),
        [("bar", 2, 8 * np.pi, None, None), ("block", 25, 40, None, None)]),
    "notched tab": (profile((0, 0), (12, 0), (12, 8), (6.6, 8), (6.6, 1.2), (5.4, 1.2), (5.4, 8), (0, 8), length=1),
                    [("plate", 1, 12, 7.4, 1)]),
    "flat angle": (profile((0, 0), (60, 0), (60, 6), (6, 6), (6, 60), (0, 60), length=1), [("plate", 1, 112, 6.1, 1)]),
    "disc with a bore": (washer(10, 50, 5), [("plate", 5, 100, 75.4, 1)]),
    "shell": (made_meshes.spherical_shell(20, 1, 60), [("plate", 1, None, None, 1)]),
    "ball": (made_meshes.sphere(20, 60), [("block", 40, 40, 20 * np.pi, 1)]),
}


def measured(shape, **place):
    mesh = surface_mesh(*made_meshes.moved(shape, **place))
    return measure(mesh, AnalysisSettings())


def regions_of(shape, **place):
    return measured(shape, **place).regions


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("name", KNOWN)
def test_known_regions(name, place):
    shape, expected = KNOWN[name]
    scale = PLACES[place].get("scale", 1.0)
    found = regions_of(shape, **PLACES[place])
    assert [region.kind for region in found.listed] == [kind for kind, *_ in expected]
    for region, (_, thickness, length, width, volume_share) in zip(found.listed, expected):
        assert region.least / scale == pytest.approx(thickness, rel=LENGTH_TOLERANCE)
        assert region.median / scale == pytest.approx(thickness, rel=LENGTH_TOLERANCE)
        if length is not None:
            assert region.length / scale == pytest.approx(length, rel=LENGTH_TOLERANCE)
        if width is not None:
            assert region.width / scale == pytest.approx(width, rel=AREA_TOLERANCE + LENGTH_TOLERANCE)
        if volume_share is not None:
            assert region.volume_share == pytest.approx(volume_share, rel=VOLUME_TOLERANCE)
        assert region.area == pytest.approx(2.0 * region.length * region.width, rel=1e-9)


def test_a_thread_is_a_tooth_on_a_bar():
    tooth, core = regions_of(made_meshes.screw(10.0, 1.5, 20, 0.92)).listed
    assert tooth.kind == "tooth" and tooth.median < 1.0
    assert tooth.length == pytest.approx(20 * 2 * np.pi * 4.6, rel=0.05)
    assert core.kind == "bar" and core.length == pytest.approx(30.0, rel=0.03)
    assert 8.1 < core.median < 10.0


def test_a_region_with_nothing_half_way_along_has_a_length():
    """Two ends of a wall of which only one link is known, longer than both."""
    points, _ = wall_points(measure(surface_mesh(*made_meshes.box(100, 80, 2)), AnalysisSettings()).field)
    ends = np.flatnonzero(np.abs(points.points[:, 0]) > 40.0)
    points, links = points.chosen(ends), wall_links(points.chosen(ends)).tolil()
    links[0, int(np.argmax(np.abs(points.points[:, 0] - points.points[0, 0])))] = 500.0
    shape = region_shape(points, links.tocsr(), None)
    assert shape.length > 100.0 and shape.kind in ("plate", "bar")


@pytest.mark.filterwarnings("error")
def test_one_row_of_points_about_an_axis_is_no_tube():
    points, _ = wall_points(measure(surface_mesh(*made_meshes.tube(20.0, 18.0, 10.0)), AnalysisSettings()).field)
    points = points.chosen(np.abs(points.normals[:, 2]) < 0.1)
    for rows in (points.points, points.middle):
        rows[:, 2] = 5.0
    assert region_shape(points, wall_links(points), None).kind != "tube"


def test_a_wedge_is_a_taper():
    taper, = regions_of(made_meshes.wedge(30.0, 100.0, 200.0)).listed
    assert taper.kind == "taper" and taper.least < 5.0 < taper.median


def test_both_faces_of_a_wall_and_no_rims_are_its_faces():
    mesh = surface_mesh(*made_meshes.box(100, 80, 2))
    region, = wall_regions(measure(mesh, AnalysisSettings()).field).listed
    normals = [mesh.normals[mesh.face_of_triangle == face][0] for face in region.faces]
    assert sorted(round(float(normal[2])) for normal in normals) == [-1, 1]
    assert region.place[2] in (pytest.approx(0.0, abs=1e-9), pytest.approx(2.0))
    assert region.place[:2] == pytest.approx([50, 40], abs=3)


def test_one_triangle_over_two_walls_belongs_to_both():
    # The plane below the step is two triangles; the wall above it is 2 mm and 8 mm thick.
    step = made_meshes.prism([(0, 0), (100, 0), (100, 8), (50, 8), (50, 2), (0, 2)], 80)
    thin, thick = regions_of(step).listed
    assert (thin.median, thick.median) == (pytest.approx(2.0), pytest.approx(8.0))
    assert thin.width * thin.length == pytest.approx(50 * 80, rel=0.05)
    assert thick.width * thick.length == pytest.approx(50 * 80, rel=0.08)
    assert len(set(thin.faces) & set(thick.faces)) == 1


def test_walls_across_a_slot_are_two():
    # Two plates of 3 mm, 0.5 mm apart, on a thick foot.
    slotted = made_meshes.prism(
        [(0, 0), (40, 0), (40, 20), (23.25, 20), (23.25, 60), (20.25, 60), (20.25, 20), (19.75, 20), (19.75, 60),
         (16.75, 60), (16.75, 20), (0, 20)], 50)
    kinds = [(region.kind, round(region.median, 3)) for region in regions_of(slotted).listed]
    assert kinds == [("plate", 3.0), ("plate", 3.0), ("block", 20.0)]


def test_the_list_is_short_and_says_how_many_are_left_out():
    found = regions_of(heat_sink(fins=30, fin=0.5, gap=1.5, thicker=1.04))
    assert len(found.listed) == 20 and found.others == 11
    assert found.others_share == pytest.approx(0.95 * 11 / 31, abs=0.15)
    assert [region.median for region in found.listed] == sorted(region.median for region in found.listed)


def test_equal_regions_count_as_one_of_the_list():
    found = regions_of(heat_sink(fins=30, fin=0.5, gap=1.5))
    assert len(found.listed) == 31 and (found.others, found.others_share) == (0, 0.0)


def test_the_equals_of_the_thinnest_region_are_listed_however_small():
    studs = [made_meshes.moved(made_meshes.box(4, 4, 4), shift=(10 * number, 0, 80)) for number in range(8)]
    found = regions_of(made_meshes.joined(made_meshes.box(100, 60, 40), *studs))
    assert [round(region.median, 6) for region in found.listed] == [4.0] * 8 + [40.0]
    assert all(region.area < 0.005 * 25568.0 for region in found.listed[:8]) and found.others == 0


def test_no_region_is_thinner_than_the_thinnest_wall():
    whole = measured(made_meshes.box(100, 80, 2))
    wall = whole.thinnest_wall
    moved = Witness(2.1, wall.point, wall.opposite, wall.face, wall.opposite_face)
    region, = with_thinnest(wall_regions(whole.field), moved).listed
    assert (region.least, region.median) == (2.1, 2.1)


def test_a_part_without_walls_has_no_regions():
    open_surface = (np.array([[0, 0, 0], [10, 0, 0], [10, 10, 0], [0, 10, 0.0]]), np.array([[0, 1, 2], [0, 2, 3]]))
    found = wall_regions(measure(surface_mesh(*open_surface), AnalysisSettings()).field)
    assert (found.listed, found.others, found.others_share) == ((), 0, 0.0)


@pytest.mark.parametrize("coarse, fine", [
    (made_meshes.tube(steps=90), made_meshes.tube(steps=400)),
    (made_meshes.box(100, 60, 3), made_meshes.box(100, 60, 3, cells=30)),
    (made_meshes.sphere(20, 60), made_meshes.sphere(20, 160)),
])
def test_another_tessellation_has_the_same_regions(coarse, fine):
    one, other = (regions_of(shape).listed[0] for shape in (coarse, fine))
    assert one.kind == other.kind
    for name in ("area", "median", "length", "width", "volume_share"):
        assert getattr(one, name) == pytest.approx(getattr(other, name), rel=LENGTH_TOLERANCE)


def test_each_region_knows_where_it_is_thinnest():
    mesh = surface_mesh(*i_beam())
    measured = measure(mesh, AnalysisSettings())
    found = measured.regions.listed
    assert len(found) >= 3
    for region in found:
        witness = region.witness
        assert witness.distance == region.least
        assert np.linalg.norm(witness.point - witness.opposite) == pytest.approx(region.least, rel=0.03)
        assert witness.face in region.faces or witness.opposite_face in region.faces
