# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for thickness: even, of rising lightness, told apart by the colour-blind; logarithmic scales."""

import numpy as np
import pytest

from thinpart_workbench.core.rendering.alike_colours import is_alike
from thinpart_workbench.core.rendering.colour_maps import RED_IS_THIN
from thinpart_workbench.core.rendering.colour_scale import UNMEASURED, ColourScale, colour_table

TO_XYZ = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]])
"""From linear sRGB, white D65 (IEC 61966-2-1)."""

SEEN_WITHOUT = {
    "red": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "green": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "blue": [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]],
}
"""What people see who lack a kind of cones, from linear sRGB (Machado, Oliveira, Fernandes 2009, doi:10.1109/TVCG.2009.113,
severity 1)."""


def linear(colours):
    colours = np.asarray(colours, dtype=float) / 255.0
    return np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)


def cielab(light):
    """CIELAB of linear sRGB: ndarray of shape (m, 3)."""
    share = light @ TO_XYZ.T / TO_XYZ.sum(axis=1)
    root = np.where(share > (6 / 29) ** 3, np.cbrt(share), share / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * root[:, 1] - 16, 500 * (root[:, 0] - root[:, 1]), 200 * (root[:, 1] - root[:, 2])], axis=1)


@pytest.fixture
def table():
    return colour_table(RED_IS_THIN)


def test_thin_is_dark_red_and_thick_is_light_blue(table):
    thin, thick = table[0].astype(int), table[-1].astype(int)
    assert thin[0] > 4 * max(thin[1:]) and thick[2] > thick[1] > thick[0] > 150
    assert np.array_equal(ColourScale(1.0, 2.0).colours([0.5, 3.0]), table[[0, -1]]), "it is the default"


def test_lightness_rises_all_along(table):
    lightness = cielab(linear(table))[:, 0]
    assert np.diff(lightness).min() > -0.3, "but for rounding to 8 bits"
    assert np.diff(lightness[::15]).min() > 1.0 and lightness[-1] - lightness[0] > 55.0


def test_equal_steps_look_equal(table):
    steps = np.linalg.norm(np.diff(cielab(linear(table))[::15], axis=0), axis=1)
    assert steps.max() / steps.min() < 1.3


@pytest.mark.parametrize("missing", SEEN_WITHOUT)
def test_the_colour_blind_see_order_and_differences(table, missing):
    seen = cielab(np.clip(linear(table) @ np.array(SEEN_WITHOUT[missing]).T, 0.0, 1.0))
    assert np.diff(seen[::15, 0]).min() > 0.0, "lightness rises"
    eighths = seen[np.linspace(0, 255, 9).astype(int)]
    apart = np.linalg.norm(eighths[:, None] - eighths[None], axis=2)
    assert apart[np.triu_indices(9, 1)].min() > 7.0


def test_no_colour_is_grey_or_that_of_the_unmeasured(table):
    found = cielab(linear(table))
    assert np.hypot(found[:, 1], found[:, 2]).min() > 15.0
    unmeasured = cielab(linear(255.0 * np.array([UNMEASURED])))
    assert np.linalg.norm(found - unmeasured, axis=1).min() > 20.0


def test_a_logarithmic_scale_has_equal_ratios_equally_far_apart():
    scale = ColourScale(0.5, 8.0, logarithmic=True)
    assert scale.positions([0.1, 0.5, 1.0, 2.0, 4.0, 8.0, 20.0]) == pytest.approx([0, 0, 0.25, 0.5, 0.75, 1, 1])
    values = np.array([0.5, 0.7, 3.0, 8.0])
    assert scale.thickness_at(scale.positions(values)) == pytest.approx(values)
    assert np.array_equal(scale.colours([2.0]), ColourScale(0.0, 1.0).colours([0.5]))


def test_a_range_from_nothing_on_stays_linear():
    scale = ColourScale(0.0, 8.0, logarithmic=True)
    assert not scale.is_logarithmic and scale.positions([4.0]) == pytest.approx([0.5])
    assert scale.thickness_at([0.25]) == pytest.approx([2.0])


@pytest.mark.parametrize("colour, is_taken_for_red", [
    ((1.0, 0.0, 0.0), True), ((0.5, 0.05, 0.1), True), ((0.9, 0.3, 0.5), True), ((1.0, 0.5, 0.0), True),
    ((0.8, 0.8, 0.86), False), ((0.05, 0.0, 0.0), False), ((0.9, 0.8, 0.75), False), ((0.1, 0.6, 0.2), False),
    ((0.2, 0.3, 0.9), False)])
def test_what_may_be_taken_for_red(colour, is_taken_for_red):
    assert is_alike(colour, (0.84, 0.15, 0.12)) == is_taken_for_red
