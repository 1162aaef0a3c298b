# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maps are sharp where the thickness jumps, and as thick as the wall is between the jumps."""

import made_meshes
import numpy as np
import pytest
from map_accuracy import share_off
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.seen_walls import seen_walls
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.thickness.measurement import measure

TURNED = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix()


def i_section(height=100.0, width=60.0, web=5.0, flange=8.0, length=150.0):
    right = [(width / 2, 0), (width / 2, flange), (web / 2, flange), (web / 2, height - flange),
             (width / 2, height - flange), (width / 2, height)]
    return made_meshes.prism(right + [(-x, y) for x, y in reversed(right)], length)


def ribbed_plate(ribs=7, rib=1.5, pitch=9.0, height=12.0, base=3.0, length=80.0):
    outline = [(0.0, 0.0), (ribs * pitch, 0.0), (ribs * pitch, base)]
    for number in reversed(range(ribs)):
        left = number * pitch + 3.0
        outline += [(left + rib, base), (left + rib, base + height), (left, base + height), (left, base)]
    return made_meshes.prism([*outline, (0.0, base)], length)


def stepped_tube():
    return made_meshes.revolved([(10, 0), (20, 0), (20, 30), (14, 30), (14, 80), (10, 80)])


def grooved_sheet(grooves=20, radius=1.0, pitch=3.0, height=1.5, length=60.0):
    """A sheet with half-round grooves across it: seen from above, its wall is nowhere straight, and jumps at each groove."""
    turn, outline = np.linspace(0.0, np.pi, 25), [(0.0, 0.0)]
    for number in range(grooves):
        outline += [((number + 0.5) * pitch - radius * np.cos(each), radius * np.sin(each)) for each in turn]
    return made_meshes.prism([*outline, (grooves * pitch, 0.0), (grooves * pitch, height), (0.0, height)], length)


@pytest.mark.parametrize("rotation", [np.eye(3), TURNED], ids=["as made", "turned"])
@pytest.mark.parametrize("shape", [i_section(), ribbed_plate(), stepped_tube(), made_meshes.ribbed_block()],
                         ids=["I-section", "ribbed plate", "stepped tube", "ribbed block"])
def test_a_map_is_what_rays_meet(shape, rotation):
    mesh = surface_mesh(*made_meshes.moved(shape, rotation))
    off, unmeasured = share_off(mesh, thickness_map(measure(mesh, AnalysisSettings())))
    assert off < 0.005 and unmeasured < 0.005


def test_a_map_follows_curved_walls_up_to_where_they_jump():
    mesh = surface_mesh(*grooved_sheet())
    off, unmeasured = share_off(mesh, thickness_map(measure(mesh, AnalysisSettings())))
    # 15 % where only walls without jumps are halved for their curvature.
    assert off < 0.04 and unmeasured < 0.03


def test_the_line_under_a_web_is_straight_and_in_its_place():
    shown = thickness_map(measure(surface_mesh(*i_section()), AnalysisSettings()))
    corners = shown.corners + shown.origin
    below = corners[:, :, 1].max(axis=1) < 1e-4
    web = below & (np.abs(shown.thickness - 100.0) < 0.1)
    flange = below & (np.abs(shown.thickness - 8.0) < 0.01)
    assert (web | flange)[below].all()
    diagonal = float(np.linalg.norm([100.0, 60.0, 150.0]))
    assert np.abs(corners[web][:, :, 0]).max() == pytest.approx(2.5, abs=diagonal / 300.0)
    assert np.abs(corners[flange][:, :, 0]).min() == pytest.approx(2.5, abs=diagonal / 300.0)
    assert shown.areas[web].sum() == pytest.approx(5.0 * 150.0, rel=0.1)


def test_the_line_around_a_boss_has_no_teeth():
    segments = 48
    stepped = made_meshes.revolved([(0, 0), (40, 0), (40, 5), (20, 5), (20, 15), (0, 15)], segments)
    shown = thickness_map(measure(surface_mesh(*stepped), AnalysisSettings()))
    corners = shown.corners + shown.origin
    below = np.abs(corners[:, :, 2]).max(axis=1) < 1e-4
    thick, thin = below & (np.abs(shown.thickness - 15.0) < 0.1), below & (np.abs(shown.thickness - 5.0) < 0.1)
    line = np.intersect1d(shown.facets[thick], shown.facets[thin])
    x, y = (shown.points[line].astype(float) + shown.origin)[:, :2].T
    # The boss is a polygon.
    turn = np.arctan2(y, x) % (2.0 * np.pi / segments) - np.pi / segments
    off = np.hypot(x, y) - 20.0 * np.cos(np.pi / segments) / np.cos(turn)
    assert len(line) > 100 and np.abs(off).max() < np.linalg.norm(np.ptp(shown.points, axis=0)) / 1500.0


def test_where_the_wall_is_even_there_is_one_value():
    shown = thickness_map(measure(surface_mesh(*made_meshes.moved(made_meshes.box(100, 80, 2), TURNED)), AnalysisSettings()))
    sheet = shown.thickness < 10.0
    assert np.ptp(shown.corner_thickness[sheet]) < 1e-4 * 2.0


def test_between_jumps_the_thickness_is_linear():
    shown = thickness_map(measure(surface_mesh(*made_meshes.wedge(20.0)), AnalysisSettings()))
    corners = shown.corners + shown.origin
    flank = np.abs(np.abs(corners[:, :, 1]) - corners[:, :, 0] * np.tan(np.radians(10.0))).max(axis=1) < 1e-3
    inner = flank & (corners[:, :, 0].min(axis=1) > 5.0) & np.isfinite(shown.thickness)
    expected = np.hypot(corners[inner][:, :, 0], corners[inner][:, :, 1]) * np.tan(np.radians(20.0))
    assert shown.corner_thickness[inner] == pytest.approx(expected, rel=0.03)


def test_a_band_that_is_narrower_than_the_facets_is_one_band():
    """Seen from above, the steep flanks of a groove in the lower side are no wall: two bands, each between two walls."""
    turn = np.linspace(0.0, np.pi, 97)
    groove = [(50.0 - 3.0 * np.cos(each), 3.0 * np.sin(each)) for each in turn]
    mesh = surface_mesh(*made_meshes.prism([(0.0, 0.0), *groove, (100.0, 0.0), (100.0, 60.0), (0.0, 60.0)], 80.0))
    shown = thickness_map(measure(mesh, AnalysisSettings()))
    corners = shown.corners + shown.origin
    band = (corners[:, :, 1].min(axis=1) > 60.0 - 1e-3) & ~shown.measured
    # By rays side by side.
    x = np.linspace(46.0, 54.0, 1001)
    above = np.flatnonzero((mesh.corners[:, :, 1] + mesh.origin[1] > 60.0 - 1e-6).all(axis=1))
    points = np.column_stack([x, np.full_like(x, 60.0), np.full_like(x, 33.0)]) - mesh.origin
    walls, _ = seen_walls(mesh, InwardRays(mesh), points, np.full(len(x), above[0]))
    lost = x[np.isinf(walls)]
    assert shown.areas[band].sum() == pytest.approx(80.0 * 8.0 * np.isinf(walls).mean(), rel=0.1)
    assert np.ptp(corners[band][:, :, 0]) == pytest.approx(np.ptp(lost), abs=2.0 * mesh.extent / 600.0)
