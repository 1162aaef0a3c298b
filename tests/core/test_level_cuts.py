# SPDX-License-Identifier: LGPL-2.1-or-later
"""Maps and sections are cut where colours change in steps, along lines of equal thickness."""

import made_meshes
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.maps.level_cuts import EVEN, cut_at_levels, section_at_levels, within_steps
from thinpart_workbench.core.maps.map_section import SectionPlane, map_section
from thinpart_workbench.core.maps.thickness_map import thickness_map
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rendering.colour_scale import ColourScale
from thinpart_workbench.core.thickness.measurement import measure

LEVELS = [2.0, 3.5, 5.0, 5.1]
TURNED = Rotation.from_rotvec([0.3, -0.8, 0.5]).as_matrix()


def made(shape):
    return thickness_map(measure(surface_mesh(*shape), AnalysisSettings()))


@pytest.fixture(scope="module")
def wedge():
    """Its walls get thicker evenly."""
    return made(made_meshes.wedge(20.0))


def areas(corners):
    return 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)


def test_pieces_fill_their_facets_and_keep_their_sides(wedge):
    cuts = cut_at_levels(wedge, LEVELS)
    corners = cuts.at_corners(wedge.corners)
    filled = np.bincount(cuts.facet, areas(corners), minlength=wedge.count)
    cut = np.unique(cuts.facet)
    assert len(cut) > 50 and filled[cut] == pytest.approx(wedge.areas[cut], rel=1e-6, abs=1e-12)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    seen = areas(corners) > 1e-6
    assert (np.einsum("ij,ij->i", normals, wedge.normals[cuts.facet])[seen] > 0.0).all()


def test_no_piece_and_no_whole_facet_passes_a_level(wedge):
    cuts = cut_at_levels(wedge, LEVELS)
    whole = np.setdiff1d(np.arange(wedge.count), cuts.facet)
    values = np.concatenate([cuts.thickness, wedge.corner_thickness[whole].astype(float)])
    values = values[np.isfinite(values).all(axis=1)]
    for level in LEVELS:
        assert not ((values.min(axis=1) < level * (1 - 2 * EVEN)) & (values.max(axis=1) > level * (1 + 2 * EVEN))).any()


def test_values_of_pieces_are_those_of_the_places(wedge):
    cuts = cut_at_levels(wedge, LEVELS)
    values = cuts.at_corners(wedge.corner_thickness[:, :, None].astype(float))[:, :, 0]
    assert cuts.thickness == pytest.approx(values, rel=1e-5)


def test_a_level_is_a_straight_line_on_a_plane_flank(wedge):
    cuts = cut_at_levels(wedge, [4.0])
    corners = cuts.at_corners(wedge.corners + wedge.origin)
    # The thickness of this wedge is a multiple of the distance from its edge.
    thin = cuts.thickness.mean(axis=1) < 4.0
    flank = np.isfinite(cuts.thickness).all(axis=1) & (np.abs(wedge.normals[cuts.facet][:, 2]) < 1e-6)
    from_edge = np.hypot(corners[:, :, 0], corners[:, :, 1])
    line = 4.0 / np.tan(np.radians(20.0))
    assert from_edge[thin & flank].max() == pytest.approx(line, rel=0.01)
    assert from_edge[~thin & flank].min() == pytest.approx(line, rel=0.01)


@pytest.mark.parametrize("level", [2.0, 2.0 * (1 + 3e-5), 2.0 * (1 - 3e-5)])
def test_an_even_wall_stays_whole_at_its_own_thickness(level):
    plate = made(made_meshes.moved(made_meshes.box(100, 80, 2), TURNED))
    assert len(cut_at_levels(plate, [level]).facet) == 0


def test_without_levels_and_without_walls_nothing_is_cut(wedge):
    assert len(cut_at_levels(wedge, []).facet) == 0
    assert len(cut_at_levels(wedge, [1e6]).facet) == 0


def test_a_piece_has_one_colour_where_colours_have_bands(wedge):
    scale = ColourScale(1.0, 8.0, bands=7)
    cuts = cut_at_levels(wedge, scale.steps)
    values = within_steps(cuts.thickness, scale.steps)
    colours = scale.colours(values.ravel()).reshape(-1, 3, 3)
    assert (colours == colours[:, :1]).all()
    assert (colours[:, 0] == scale.colours(cuts.thickness.mean(axis=1))).all()
    assert len(np.unique(colours[:, 0], axis=0)) >= 5


def test_a_wall_as_thick_as_a_level_is_not_below_it():
    thickness = np.full((1, 3), 2.1, dtype=np.float32)
    assert within_steps(thickness, [2.1]).min() >= 2.1


@pytest.mark.parametrize("scale, steps", [
    (ColourScale(1.0, 5.0, bands=4), [2.0, 3.0, 4.0]), (ColourScale(1.0, 16.0, bands=4, logarithmic=True), [2.0, 4.0, 8.0]),
    (ColourScale(1.0, 5.0), []), (ColourScale(2.0, 2.0, bands=4), []), (ColourScale(1.0, 5.0, bands=1), []),
], ids=["even", "logarithmic", "smooth", "no range", "one band"])
def test_steps_of_a_scale(scale, steps):
    assert scale.steps == pytest.approx(steps)
    for step in steps:
        below, above = scale.colours([step * 0.999, step * 1.001])
        assert (below != above).any()


def test_the_edge_of_a_section_is_cut_too(wedge):
    section = map_section(wedge, SectionPlane((0.0, 0.0, 1.0), float(wedge.origin[2] + wedge.points[:, 2].mean())))
    cut = section_at_levels(section, LEVELS)
    assert len(cut.ends) > len(section.ends)
    lengths = np.linalg.norm(cut.ends[:, 1] - cut.ends[:, 0], axis=1)
    whole = np.linalg.norm(section.ends[:, 1] - section.ends[:, 0], axis=1)
    assert lengths.sum() == pytest.approx(whole.sum())
    for level in LEVELS:
        low, high = cut.thickness.min(axis=1), cut.thickness.max(axis=1)
        assert not ((low < level * (1 - 2 * EVEN)) & (high > level * (1 + 2 * EVEN))).any()
    # Each end has the thickness of its place: between the ends of its line it is linear.
    start, end = section.ends[:, 0], section.ends[:, 1]
    for row in np.flatnonzero(np.isfinite(cut.thickness).all(axis=1))[:200]:
        line = np.flatnonzero(section.facet == cut.facet[row])[0]
        share = np.linalg.norm(cut.ends[row] - start[line], axis=1) / np.linalg.norm(end[line] - start[line])
        expected = section.thickness[line, 0] + share * np.diff(section.thickness[line])[0]
        assert cut.thickness[row] == pytest.approx(expected, rel=1e-5)
    assert len(section_at_levels(section, []).ends) == len(section.ends)
