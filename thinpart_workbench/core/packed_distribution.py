"""Distributions as bytes: how an index of many parts keeps them, and asks them for any bounds."""

import struct

import numpy as np

from .distribution import Distribution

_NOTHING = (b"", b"", b"")


def packed_walls(content):
    """Bins and areas of a record's ``distribution``, two bytes objects."""
    return _packed(content["bins"], "H"), _packed(content["area"], "f")


def packed_slanted(content):
    """Bins, angles and areas of a record's ``nonparallel``, three bytes objects."""
    return _packed(content["bins"], "H"), _packed(content["angles"], "H"), _packed(content["area"], "f")


def wall_share(bins, area, low, high):
    """`Distribution.share` of packed walls."""
    return _distribution(walls=(bins, area)).share(low, high)


def least_slanted(bins, angles, area, floor, low, high):
    """`Distribution.nonparallel_minimum` of packed slanted walls; inf where there is none."""
    least = _distribution(slanted=(bins, angles, area)).nonparallel_minimum(floor, low, high)
    return np.inf if least is None else least


def _packed(numbers, kind):
    return struct.pack(f"<{len(numbers)}{kind}", *numbers)


def _distribution(walls=_NOTHING[1:], slanted=_NOTHING):
    return Distribution(*_unpacked(*walls), *_unpacked(*slanted), 0.0, 0.0, 0.0, 0.0)


def _unpacked(*columns):
    *whole, area = columns
    return [*(np.frombuffer(each, "<u2").astype(np.int64) for each in whole),
            np.frombuffer(area, "<f4").astype(float)]
