# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness distribution of a part as the bars of a chart."""

import math
from dataclasses import dataclass

from .bins import BINS

MOST_BARS = 40


@dataclass(frozen=True)
class Bar:
    """A range of thickness and the share of the area over it.

    Attributes
    ----------
    low, high : int
        Bins of x, `high` excluded.
    area : float
    """

    low: int
    high: int
    area: float


def bars(bins, area, limit):
    """Group the bins of a distribution into bars of one width: list of Bar, from x = 0 on, without gaps.

    Parameters
    ----------
    bins : list of int
    area : list of float
    limit : float
        x of the thin limit; a bar ends there if possible.
    """
    limit_bin = round(limit * BINS)
    end = max([*bins, limit_bin], default=0) + 1
    least = math.ceil(end / MOST_BARS)
    width = next((candidate for candidate in range(least, 3 * least + 1) if limit_bin % candidate == 0), least)
    shares = [0.0] * math.ceil(end / width)
    for index, share in zip(bins, area):
        shares[index // width] += share
    return [Bar(number * width, (number + 1) * width, share) for number, share in enumerate(shares)]


def round_up(value):
    """Round up to 1, 2, 2.5 or 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    return next(factor * power for factor in (1.0, 2.0, 2.5, 5.0, 10.0)
                if factor * power >= value * (1.0 - 1e-9))
