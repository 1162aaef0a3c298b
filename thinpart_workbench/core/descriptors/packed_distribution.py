# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distributions as bytes, as the index of a library stores them, and queries on them for any bounds."""

import struct
from dataclasses import replace

import numpy as np

from .distribution import Distribution, MiddleDistribution
from .local_distribution import LocalDistribution

_NOTHING = (b"", b"", b"")


def packed_walls(content):
    """Pack the bins and areas of a record's ``distribution`` into two bytes objects."""
    return _packed(content["bins"], "H"), _packed(content["area"], "f")


def packed_slanted(content):
    """Pack the bins, angles and areas of a record's ``nonparallel`` into three bytes objects."""
    return _packed(content["bins"], "H"), _packed(content["angles"], "H"), _packed(content["area"], "f")


def wall_share(bins, area, low, high):
    """`Distribution.share` of packed walls."""
    return _distribution(walls=(bins, area)).share(low, high)


def packed_middle(content):
    """Pack a record's ``middle`` into three bytes objects; of None, three times None."""
    if content is None:
        return None, None, None
    return (*packed_walls({"bins": content["bins"], "area": content["parallel"]}), _packed(content["nonparallel"], "f"))


def middle_share(walls, wall_area, bins, angles, area, middle_bins, middle_parallel, middle_nonparallel, unit, low, high,
                 slanted):
    """`Distribution.middle_share` of packed walls."""
    found = _distribution((walls, wall_area), (bins, angles, area))
    if middle_bins is not None:
        numbers, parallel = _unpacked(middle_bins, middle_parallel)
        found = replace(found, middle=MiddleDistribution(numbers, parallel, _unpacked(middle_nonparallel)[0]))
    return found.middle_share(low, high, unit, slanted)


def packed_local(content):
    """Pack a record's ``local`` into two bytes objects; of None and of an empty one, twice None."""
    if content is None or not content["bins"]:
        return None, None
    return packed_walls(content)


def local_share(bins, area, low, high):
    """`LocalDistribution.share` of packed local thicknesses, float or None: None where there are none."""
    if bins is None:
        return None
    number, share = _unpacked(bins, area)
    return LocalDistribution(number, share, {}).share(low, high)


def least_slanted(bins, angles, area, floor, low, high):
    """`Distribution.nonparallel_minimum` of packed slanted walls; inf where there is none."""
    least = _distribution(slanted=(bins, angles, area)).nonparallel_minimum(floor, low, high)
    return np.inf if least is None else least


def _packed(numbers, kind):
    return struct.pack(f"<{len(numbers)}{kind}", *numbers)


def _distribution(walls=_NOTHING[1:], slanted=_NOTHING):
    bins, area = _unpacked(*walls)
    slanted_bins, angles, slanted_area = _unpacked(*slanted)
    return Distribution(bins, area, slanted_bins, angles, slanted_area, 0.0, 0.0, 0.0, 0.0)


def _unpacked(*columns):
    *integers, area = columns
    return [*(np.frombuffer(column, "<u2").astype(np.int64) for column in integers),
            np.frombuffer(area, "<f4").astype(float)]
