# SPDX-License-Identifier: LGPL-2.1-or-later
"""How often verdicts are those of people, on parts that were not learned from."""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...core.categories import UNKNOWN

MOST_FOLDS = 10
"""Times that parts are left out; more groups than this are put together."""

_NORMAL_QUANTILE = 1.959963984540054
"""Of the normal distribution, for intervals of 95 %."""


@dataclass(frozen=True)
class CountedShare:
    """A share, with its interval of 95 % confidence.

    Attributes
    ----------
    count, total : int
    low, high : float
        Bounds, 0 and 1 where `total` is 0.
    """

    count: int
    total: int
    low: float
    high: float


@dataclass(frozen=True)
class Scores:
    """How the verdicts of a profile compare with labels.

    Attributes
    ----------
    sure : CountedShare
        Of the parts whose label is sure: those whose verdict is the label.
    either : CountedShare
        Of all parts: those whose verdict is the label or the second answer.
    confusion : dict of str to dict of str to int
        Number of parts by label, then by verdict.
    calibration_error : float or None
        Expected calibration error of the stated probabilities; None where there are none.
    """

    sure: CountedShare
    either: CountedShare
    confusion: Mapping
    calibration_error: Optional[float]


def share_of(flags):
    """How many of some flags, sequence of bool, are true, with the interval of Wilson: CountedShare.

    Wilson (1927), Probable Inference, the Law of Succession, and Statistical Inference, doi:10.1080/01621459.1927.10502953.
    It takes parts as independent; those of one folder resemble each other, so the true interval is somewhat wider.
    """
    count, total = sum(map(bool, flags)), len(flags)
    if not total:
        return CountedShare(0, 0, 0.0, 1.0)
    share, square = count / total, _NORMAL_QUANTILE ** 2
    centre = (share + square / (2 * total)) / (1 + square / total)
    half = _NORMAL_QUANTILE / (1 + square / total) * math.sqrt(share * (1 - share) / total + square / (4 * total ** 2))
    return CountedShare(count, total, max(0.0, centre - half), min(1.0, centre + half))


@dataclass(frozen=True)
class Bin:
    """Verdicts whose stated probabilities are alike: a row of a reliability diagram.

    Attributes
    ----------
    low, high : float
        Bounds of the probability.
    count : int
    stated, right : float
        Means of the stated probability, and of how far the verdict is right.
    """

    low: float
    high: float
    count: int
    stated: float
    right: float


def scores(parts, verdicts, categories):
    """Compare verdicts with labels: Scores.

    Parameters
    ----------
    parts : list of LabelledPart
    verdicts : list of Classification
        In the same order.
    categories : sequence of str
    """
    confusion = {label: dict.fromkeys((*categories, UNKNOWN), 0) for label in categories}
    for part, verdict in zip(parts, verdicts):
        confusion[part.category][verdict.category] += 1
    stated = [(verdict.probabilities[verdict.category], truth_of(part, verdict.category))
              for part, verdict in zip(parts, verdicts) if verdict.probabilities]
    return Scores(
        share_of([part.category == verdict.category for part, verdict in zip(parts, verdicts) if part.is_sure]),
        share_of([verdict.category in (part.category, part.second) for part, verdict in zip(parts, verdicts)]),
        confusion, calibration_error(*np.array(stated).T) if stated else None)


def reliability(stated, right, bins=10):
    """What a reliability diagram shows: how often verdicts are right, by stated probability.

    Returns a list of Bin: those that are not empty.

    Parameters
    ----------
    stated, right : ndarray of shape (n,)
    bins : int
        Of equal width.
    """
    which = np.minimum((stated * bins).astype(int), bins - 1)
    return [Bin(each / bins, (each + 1) / bins, int(np.count_nonzero(which == each)),
                float(stated[which == each].mean()), float(right[which == each].mean())) for each in np.unique(which)]


def calibration_error(stated, right):
    """Expected calibration error: mean difference of stated and found shares, shape (n,), over bins of equal width, float.

    Naeini, Cooper, Hauskrecht (2015), Obtaining Well Calibrated Probabilities Using Bayesian Binning, AAAI.
    """
    return sum(each.count * abs(each.stated - each.right) for each in reliability(stated, right)) / len(stated)


def folds(groups):
    """Divide n parts such that groups, sequence of str, stay together: list of ndarray of bool, shape (n,).

    At most `MOST_FOLDS`, of like size: whether a part is left out.
    """
    names, counts = np.unique(np.asarray(groups), return_counts=True)
    sizes = [0] * min(MOST_FOLDS, len(names))
    fold = {}
    for index in np.argsort(-counts, kind="stable"):
        smallest = sizes.index(min(sizes))
        fold[names[index]] = smallest
        sizes[smallest] += int(counts[index])
    which = np.array([fold[group] for group in groups])
    return [which == each for each in range(len(sizes))]


def truth_of(part, category):
    """How far a category is right, 0 to 1, where the second answer counts half of the first."""
    share = {part.category: 1.0} if part.second is None else {part.category: 2 / 3, part.second: 1 / 3}
    return share.get(category, 0.0)
