# SPDX-License-Identifier: LGPL-2.1-or-later
"""How well each quantity foretells which of two groups a part belongs to."""

import math
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq
from scipy.stats import rankdata

from ..descriptors.descriptor_table import QUANTITIES, STATED_FLOOR

_NORMAL_QUANTILE = 1.959963984540054
"""Of the normal distribution, for intervals of 95 %."""


_INSIDE = 1e-9
"""How far from 0 and 1 the search for the ends of an interval begins."""


@dataclass(frozen=True)
class Foretelling:
    """How well a quantity separates parts with trouble from those without.

    Attributes
    ----------
    symbol, meaning : str
        Of the quantity.
    is_low : bool
        Whether low values mean trouble.
    area : float
        Area under the receiver operating characteristic, 0.5 to 1: the probability that a part with trouble has a lower
        (or higher, see `is_low`) value than one without.
    low, high : float
        Interval of 95 %.
    troubled, others : int
        Parts of each group whose value is known.
    """

    symbol: str
    meaning: str
    is_low: bool
    area: float
    low: float
    high: float
    troubled: int
    others: int


def foretellings(descriptors, has_trouble, more=()):
    """How well the quantities of the table foretell trouble: list of Foretelling.

    The best first. Quantities that are known of no part of one of the groups are left out.

    Parameters
    ----------
    descriptors : list of Descriptors, of length n
    has_trouble : sequence of bool, of length n
    more : iterable of Quantity, optional
        Further quantities, such as those of a profile's conditions: of the shares of walls, the table has no bounds.
    """
    trouble = np.asarray(has_trouble, bool)
    more = tuple(more)
    quantities = {quantity.symbol: quantity for quantity in (*QUANTITIES, *more)
                  if quantity.keys or quantity in more}
    found = []
    for quantity in quantities.values():
        values = np.array([_value(quantity, part) for part in descriptors], float)
        known = ~np.isnan(values)
        yes, no = values[known & trouble], values[known & ~trouble]
        if len(yes) and len(no):
            area = area_under_curve(yes, no)
            low, high = area_interval(max(area, 1.0 - area), len(yes), len(no))
            found.append(Foretelling(quantity.symbol, quantity.meaning, area < 0.5, max(area, 1.0 - area), low, high,
                                     len(yes), len(no)))
    return sorted(found, key=lambda each: -each.area)


def area_under_curve(yes, no):
    """The probability that a value of one group, an ndarray, exceeds one of the other, ties counting half: float.

    The statistic of Mann and Whitney (1947), doi:10.1214/aoms/1177730491, divided by m n.
    """
    ranks = rankdata(np.concatenate([yes, no]))[:len(yes)]
    return float((ranks.sum() - len(yes) * (len(yes) + 1) / 2) / (len(yes) * len(no)))


def area_interval(area, yes, no):
    """Interval of 95 % of an area under the curve.

    Returns `low` and `high` (float).

    Method 5 of Newcombe (2006), Confidence intervals for an effect size measure based on the Mann-Whitney statistic,
    part 2, doi:10.1002/sim.2324. Like Wilson's interval of a share, it solves for the area that the found one is just
    compatible with, so it does not vanish where the groups are separated completely.

    Parameters
    ----------
    area : float
    yes, no : int
        Sizes of the groups, at least 1.
    """
    half = 0.5 * (yes + no) - 1.0

    def excess(other):
        variance = other * (1.0 - other) * (
            1.0 + half * (1.0 - other) / (2.0 - other) + half * other / (1.0 + other)) / (yes * no)
        return abs(area - other) - _NORMAL_QUANTILE * math.sqrt(max(variance, 0.0))

    # At 0 and 1 the equation holds trivially.
    near = min(max(area, _INSIDE), 1.0 - _INSIDE)
    low = 0.0 if area <= 0.0 else brentq(excess, 0.0, near)
    high = 1.0 if area >= 1.0 else brentq(excess, near, 1.0)
    return float(low), float(high)


def _value(quantity, part):
    value = quantity.evaluate(part, STATED_FLOOR)
    if value is None:
        value = quantity.absent_means
    return math.nan if value is None else value
