# SPDX-License-Identifier: LGPL-2.1-or-later
import json
from dataclasses import replace

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import LOCAL, RAY, SPHERE, AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.maps.facet_refinement import FACETS, MOST_FACETS, cut_sides, side_keys
from thinpart_workbench.core.maps.map_summary import (
    are_between,
    area_by_thickness,
    between,
    face_summaries,
    share_between,
    thickness_range,
    typical_range,
)
from thinpart_workbench.core.maps.mapped_part import MappedPart
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rendering.colour_scale import COLOUR_MAPS, ColourScale, colour_table
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.storage.map_file import read_maps, write_maps

TURNED = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix()


def _map(shape, **settings):
    return thickness_map(measure(surface_mesh(*shape), AnalysisSettings(**settings)))


def _closed(shown):
    """Whether every side belongs to two facets, so that the picture has no cracks."""
    return set(np.unique(side_keys(shown.facets.astype(np.int64), len(shown.points)),
                         return_counts=True)[1]) == {2}


def _open_lengths(points, facets, face):
    """By face, the length of the sides that belong to one of its facets only."""
    sides = points[np.stack([facets, np.roll(facets, -1, axis=1)], axis=2)]
    lengths = np.linalg.norm(sides[:, :, 1] - sides[:, :, 0], axis=2).ravel()
    keys = (side_keys(facets, len(points)) * (int(face.max()) + 1) + face[:, None]).ravel()
    _, first, count = np.unique(keys, return_index=True, return_counts=True)
    assert count.max() <= 2
    return np.bincount(np.repeat(face, 3)[first[count == 1]], lengths[first[count == 1]], int(face.max()) + 1)


@pytest.mark.parametrize("shape", [
    made_meshes.box(100, 60, 40), made_meshes.ribbed_block(), made_meshes.tube(), made_meshes.wedge(),
    made_meshes.sphere(), made_meshes.spherical_shell(),
])
def test_facets_cover_the_surface_without_cracks(shape):
    mesh = surface_mesh(*made_meshes.moved(shape, TURNED, (1000.0, 0.0, 0.0)))
    shown = thickness_map(measure(mesh, AnalysisSettings()))
    # Between two faces, the facets of one may have corners on the straight sides of those of the other.
    assert _open_lengths(shown.points.astype(float), shown.facets.astype(np.int64), shown.face.astype(np.int64)) == \
        pytest.approx(_open_lengths(mesh.vertices, mesh.triangles, mesh.face_of_triangle), rel=1e-4, abs=1e-3)
    assert shown.areas.sum() == pytest.approx(mesh.areas.sum(), rel=1e-5)
    assert FACETS / 4 < shown.count < 1.2 * max(MOST_FACETS, mesh.count)
    for face in np.unique(mesh.face_of_triangle):
        assert shown.areas[shown.face == face].sum() == pytest.approx(
            mesh.areas[mesh.face_of_triangle == face].sum(), rel=1e-4)


@pytest.mark.parametrize("measure_by", ["rays", "pairs"])
def test_a_plate_is_as_thick_as_it_is(measure_by):
    shown = _map(made_meshes.box(100, 100, 2), measure=measure_by)
    corners = shown.corners + shown.origin
    on_top = np.abs(np.ptp(corners[:, :, 2], axis=1)) < 1e-6
    assert shown.thickness[on_top] == pytest.approx(2.0, abs=1e-4)
    assert shown.thickness[~on_top] == pytest.approx(100.0, abs=1e-3)


@pytest.mark.parametrize("wall", [0.7, 0.9, 1.4, 1.8])
def test_a_wall_on_an_edge_of_the_histogram_is_above_it_everywhere(wall):
    """As float32, these are a little less than their decimals."""
    sheet = MappedPart({}, _map(made_meshes.box(50, 40, wall)), [], np.eye(4)[None])
    shares, _ = area_by_thickness([sheet], np.arange(5) * wall)
    assert shares[0] == 0.0 and shares[1] > 0.9
    assert share_between([sheet], 0.0, wall) == 0.0
    assert share_between([sheet], wall, 2 * wall) == pytest.approx(shares[1])
    assert are_between(sheet.map.thickness, wall, np.inf)[sheet.map.measured].all()
    assert all(each.thin_share == 0.0 for each in face_summaries(sheet.map, wall))


def test_a_rib_is_seen_where_it_is():
    """Under the block's lower side lies the block, and the block and the rib where the rib stands."""
    shown = _map(made_meshes.ribbed_block())
    corners = shown.corners + shown.origin
    x, below = corners.mean(axis=1)[:, 0], corners[:, :, 1].max(axis=1) < 1e-4
    assert below.any()
    under_rib = np.abs(x - 30.0) < 3.0
    assert set(np.round(shown.thickness[below & under_rib], 3)) == {60.0}
    assert set(np.round(shown.thickness[below & ~under_rib], 3)) == {40.0}
    beside = np.abs(np.abs(x - 30.0) - 3.0) < 1.0
    sizes = shown.areas[below & beside].mean(), shown.areas[below & ~beside].mean()
    assert sizes[0] < 0.5 * sizes[1]  # its outline is drawn finer


def test_the_wall_under_any_point_is_exact():
    """In a wedge the wall grows from point to point, and stands at an angle."""
    shown, flank = _wedge()
    # Beside a jump there are facets of some micrometres, whose normals are no better than their points, which are float32.
    measured = np.flatnonzero(flank & shown.measured & (shown.areas > 0.01))
    assert len(measured) > 100 and shown.areas[measured].sum() > 0.999 * shown.areas[flank & shown.measured].sum()
    for facet in measured[:: len(measured) // 50]:
        for corner in shown.corners[facet] + shown.origin:
            thickness, opposite = shown.wall_at(facet, corner)
            assert thickness == pytest.approx(np.hypot(*corner[:2]) * np.tan(np.radians(30.0)), abs=1e-3)
            assert np.linalg.norm(opposite - corner) == pytest.approx(thickness, abs=1e-3)
            assert np.hypot(*opposite[:2]) * np.cos(np.radians(30.0)) == pytest.approx(
                np.hypot(*corner[:2]), abs=1e-3)


def _wedge():
    """Map of a wedge of 30 degrees, and which of its facets lie on the flanks that meet at its tip."""
    shown = _map(made_meshes.wedge(30.0))
    corners = shown.corners + shown.origin
    off = np.abs(np.abs(corners[:, :, 1]) - corners[:, :, 0] * np.tan(np.radians(15.0))).max(axis=1)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return shown, (off < 1e-3) & (np.abs(normal[:, 2]) < 1e-6)


def test_what_cannot_be_measured_has_no_value():
    points, triangles = made_meshes.box(10, 10, 10)
    shown = thickness_map(measure(surface_mesh(points, triangles[:-2]), AnalysisSettings()))
    assert not shown.measured.all() and shown.measured.any()
    facet = int(np.flatnonzero(~shown.measured)[0])
    assert shown.opposite[facet] == -1 and shown.wall_at(facet, (0, 0, 0)) == (None, None)


def test_a_fine_mesh_keeps_its_triangles_and_what_was_measured():
    measured = measure(surface_mesh(*made_meshes.sphere(steps=400)), AnalysisSettings())
    shown = thickness_map(measured)
    mesh = measured.field.mesh
    assert shown.count == mesh.count > MOST_FACETS
    assert np.array_equal(shown.facets, mesh.triangles)
    assert shown.thickness == pytest.approx(40.0, abs=0.1)


def test_sides_are_cut_on_both_facets_that_share_them():
    points = np.array([[0.0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]])
    facets = np.array([[0, 1, 2], [0, 2, 3]])
    for code in range(8):
        cut = np.array([[bool(code & 1 << k) for k in range(3)], [False] * 3])
        new, pieces, parent = cut_sides(points, facets, cut)
        corners = new[pieces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]
        assert (across > 0.0).all() and 0.5 * across.sum() == pytest.approx(4.0)
        assert np.bincount(parent, weights=0.5 * across) == pytest.approx([2.0, 2.0])
        assert (np.unique(side_keys(pieces, len(new)), return_counts=True)[1] <= 2).all()
        assert len(new) == 4 + cut.sum()


def _part(shape, places=1):
    mesh = surface_mesh(*shape)
    return MappedPart({"name": "Body", "label": "Plate \u00fc"}, thickness_map(measure(mesh, AnalysisSettings())),
                      ["Pad", "Pad"], np.tile(np.eye(4), (places, 1, 1)))


def test_summaries_agree_with_each_other():
    plate, cube = _part(made_meshes.box(100, 100, 2)), _part(made_meshes.box(10, 10, 10), places=3)
    shares, unmeasured = area_by_thickness([plate, cube], np.array([0.0, 5.0, 50.0, 200.0]))
    assert shares.sum() + unmeasured == pytest.approx(1.0)
    total = 20800.0 + 3 * 600.0
    assert shares == pytest.approx([20000 / total, 1800 / total, 800 / total], rel=1e-4)
    assert share_between([plate, cube], 5.0, 50.0) == pytest.approx(shares[1])
    assert thickness_range([plate, cube]) == pytest.approx((2.0, 100.0), rel=1e-4)
    assert typical_range([plate]) == pytest.approx((2.0, 4.0), rel=1e-4)
    assert typical_range([cube]) == pytest.approx((10.0, 10.0), rel=1e-4)
    # The thinnest wall of some extent, where the record names one.
    measured = replace(plate, record={"descriptors": {"thickness_mm": {"min": 3.0}}})
    assert typical_range([measured]) == pytest.approx((3.0, 6.0), rel=1e-4)
    faces = face_summaries(plate.map, 5.0)
    assert sum(each.area for each in faces) == pytest.approx(20800.0, rel=1e-5)
    thin = plate.map.areas[between(plate.map, 0.0, 5.0)].sum()
    assert sum(each.area * each.thin_share for each in faces) == pytest.approx(thin, rel=1e-6)


def test_a_face_knows_its_thinnest_wall_and_its_median():
    shown, flank = _wedge()
    number = int(shown.face[np.flatnonzero(flank)[0]])
    face = next(each for each in face_summaries(shown, 10.0) if each.face == number)
    assert 0.0 < face.thinnest < 1.5 < face.median
    assert 0.0 < face.thin_share < 1.0


def test_a_map_goes_through_a_file(tmp_path):
    part = _part(made_meshes.box(100, 100, 2), places=2)
    path = str(tmp_path / "map.npz")
    write_maps(path, [part, part])
    for read in read_maps(path):
        assert read.record == part.record and read.features == part.features
        assert np.array_equal(read.matrices, part.matrices)
        assert np.array_equal(read.map.thickness, part.map.thickness, equal_nan=True)
        assert read.map.wall_at(0, read.map.corners[0].mean(axis=0)) is not None


@pytest.mark.parametrize("damage", [b"", b"no archive", b"PK\x03\x04cut off"])
def test_a_damaged_file_is_told(tmp_path, damage):
    path = tmp_path / "map.npz"
    path.write_bytes(damage)
    with pytest.raises(ThinPartError, match="map.npz cannot be read"):
        read_maps(str(path))


@pytest.mark.parametrize("name", COLOUR_MAPS)
def test_a_scale_runs_from_end_to_end(name):
    scale = ColourScale(1.0, 3.0, name)
    table = colour_table(name)
    assert np.array_equal(scale.colours([0.0, 1.0, 3.0, 9.0]), table[[0, 0, -1, -1]])
    turned = ColourScale(1.0, 3.0, name, reversed=True)
    assert np.array_equal(turned.colours([1.0, 3.0]), table[[-1, 0]])
    lightness = table @ [0.2126, 0.7152, 0.0722]
    assert lightness[-1] - lightness[0] > 120  # readable without any colour


def test_bands_and_the_unmeasured():
    scale = ColourScale(0.0, 10.0, bands=4, unmeasured=(1.0, 0.0, 0.5))
    values = np.linspace(0.0, 10.0, 400)
    assert len(np.unique(scale.colours(values), axis=0)) == 4
    assert np.array_equal(scale.colours([2.4]), scale.colours([0.1]))
    assert not np.array_equal(scale.colours([2.6]), scale.colours([2.4]))
    assert scale.colours([np.nan]).tolist() == [[255, 0, 128]]


def test_a_range_of_no_width_still_has_colours():
    assert ColourScale(2.0, 2.0).colours([1.0, 2.0, 3.0]).shape == (3, 3)


def test_large_triangles_of_a_fine_surface_mesh_are_cut_all_the_same(monkeypatch):
    fine = made_meshes.moved(made_meshes.box(10, 10, 10, cells=12), shift=(300.0, 0.0, 0.0))
    mesh = surface_mesh(*made_meshes.joined(made_meshes.ribbed_block(), fine))
    monkeypatch.setattr("thinpart_workbench.core.maps.facet_refinement.MOST_FACETS", mesh.count // 2)
    shown = thickness_map(measure(mesh, AnalysisSettings()))
    assert mesh.count < shown.count <= 1.5 * mesh.count + 1
    assert shown.areas.max() < 0.2 * mesh.areas.max()


@pytest.mark.parametrize("shape", [made_meshes.ribbed_block(), made_meshes.tube(), made_meshes.wedge()])
def test_balls_cover_the_surface_and_are_no_larger_than_walls(shape):
    measured = measure(surface_mesh(*made_meshes.moved(shape, TURNED)), AnalysisSettings())
    walls, balls = thickness_map(measured), thickness_map(measured, by=SPHERE)
    assert (walls.measure, balls.measure) == (RAY, SPHERE)
    assert _closed(balls) and balls.measured.all()
    assert balls.areas.sum() == pytest.approx(walls.areas.sum(), rel=1e-5)
    assert balls.ends[1] <= walls.ends[1] * (1.0 + 1e-3)


def test_a_ball_of_a_map_ends_at_its_diameter():
    shown = thickness_map(measure(surface_mesh(*made_meshes.box(100, 100, 2)), AnalysisSettings()), by=SPHERE)
    on_top = np.flatnonzero(shown.normals[:, 2] > 0.9)
    middle = on_top[np.argmin(np.linalg.norm((shown.corners.mean(axis=1) + shown.origin)[on_top, :2] - 50.0, axis=1))]
    point = shown.corners[middle].mean(axis=0) + shown.origin
    value, end = shown.wall_at(middle, point)
    assert value == pytest.approx(2.0, rel=1e-5)
    assert end == pytest.approx(point - (0.0, 0.0, 2.0), abs=1e-4)


def test_by_local_thickness_a_plate_is_as_thick_at_its_rim_and_balls_that_touch_are_no_larger():
    measured = measure(surface_mesh(*made_meshes.moved(made_meshes.box(100, 80, 2), TURNED)), AnalysisSettings())
    local, balls = (thickness_map(measured, by=by) for by in (LOCAL, SPHERE))
    assert local.measure == LOCAL and _closed(local) and local.ends == pytest.approx((2.0, 2.0), rel=1e-4)
    assert balls.ends[0] < 1.0, "at the edges of the rim, balls that touch go down to nothing"
    low, high = typical_range([MappedPart({}, local)])
    assert low == high, "one thickness has one colour"


@pytest.mark.parametrize("by", [SPHERE, LOCAL])
def test_a_map_file_keeps_the_measure(by, tmp_path):
    shown = thickness_map(measure(surface_mesh(*made_meshes.wedge()), AnalysisSettings()), by=by)
    write_maps(str(tmp_path / "maps.npz"), [MappedPart({}, shown)])
    read, = read_maps(str(tmp_path / "maps.npz"))
    assert read.map.measure == by
    np.testing.assert_array_equal(read.map.thickness, shown.thickness)


def test_a_map_file_of_an_earlier_version_is_by_rays(tmp_path):
    path = tmp_path / "maps.npz"
    write_maps(str(path), [MappedPart({}, _map(made_meshes.wedge()))])
    with np.load(path) as file:
        arrays = dict(file)
    content = json.loads(str(arrays["content"]))
    del content["parts"][0]["measure"]
    np.savez(path, **{**arrays, "content": np.array(json.dumps(content))})
    assert read_maps(str(path))[0].map.measure == RAY
