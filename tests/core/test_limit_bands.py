# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ranges into which limits of the wall divide all thicknesses."""

import math

import pytest

from thinpart_workbench.core.judging.limit_bands import ABOVE, FAILS, JUST_ABOVE, PASSES, TOO_THICK, limit_bands


@pytest.mark.parametrize("least, most, names", [
    (2.0, 0.0, [FAILS, JUST_ABOVE, PASSES]), (2.0, 4.0, [FAILS, JUST_ABOVE, PASSES, TOO_THICK]),
    (0.0, 4.0, [PASSES, TOO_THICK]), (0.0, 0.0, [PASSES]), (2.0, 2.1, [FAILS, JUST_ABOVE, PASSES, TOO_THICK])])
def test_every_thickness_is_in_one_band(least, most, names):
    bands = limit_bands(least, most)
    assert [band.name for band in bands] == names
    across = [band for band in bands if band.name != TOO_THICK]
    assert across[0].low == 0.0 and across[-1].high == math.inf
    assert all(one.high == other.low for one, other in zip(across, across[1:]))
    assert all(band.low <= band.high for band in bands)


def test_what_is_too_thick_is_a_range_of_balls_over_those_of_walls():
    band = limit_bands(2.0, 4.0)[-1]
    assert (band.name, band.high, band.limit) == (TOO_THICK, math.inf, 4.0) and band.low == pytest.approx(4.0, rel=1e-3)


def test_a_wall_at_the_limit_is_just_above_it():
    def band_of(thickness):
        return next(band.name for band in limit_bands(2.0, 4.0) if band.low <= thickness < band.high)

    end = 2.0 * (1 + ABOVE)
    assert [band_of(each) for each in (1.99, 1.99995, 2.0, end - 0.001, end + 0.001, 4.0, 40.0)] == [
        FAILS, JUST_ABOVE, JUST_ABOVE, JUST_ABOVE, PASSES, PASSES, PASSES]
