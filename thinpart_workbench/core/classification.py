"""The verdict on a part by a profile. Judging only: nothing is measured here."""

from dataclasses import dataclass
from typing import Optional

from .categories import NORMAL, UNKNOWN

DEFAULT_THIN_LIMIT = 0.05
"""The paper's bound on thin features, criteria 5 and 7."""

THICK_FROM = 0.3
"""From this x on, the paper speaks of the thick body beside a thin feature (criterion 6)."""


@dataclass(frozen=True)
class Classification:
    """A part's category and how it came about.

    Attributes
    ----------
    category : str
        A category of the profile, ``normal`` or ``unknown``.
    criteria : tuple
        Ids of all criteria that hold, whichever decided.
    checked : tuple of CheckedCriterion
        Every criterion of the profile, in order: the evidence.
    margin : float or None
        How far, relative to the thresholds, the deciding quantities lie from another verdict;
        None where the verdict is ``unknown``.
    borderline : bool
        Whether the margin is under the profile's.
    reason : str
        Why the category is ``unknown``; empty otherwise.
    thin_limit : float
        The x under which a wall counts as thin, so that what is shown as thin is what the verdict
        rests on: the least bound that the criteria which decided put on a distance, or
        `DEFAULT_THIN_LIMIT` where that already covers most of the area under it.
    """

    category: str
    criteria: tuple
    checked: tuple
    margin: Optional[float]
    borderline: bool
    reason: str
    thin_limit: float


def _thin_bound(checked):
    condition = checked.condition
    if condition.quantity.name == "min_nonparallel" and condition.comparison == "<":
        return condition.value
    if condition.quantity.name == "F" and condition.comparison == ">":
        high = condition.quantity.bounds[1]
        # A share of thick walls, such as F[0.3;0.7] beside them, is not what is thin.
        return high if high < THICK_FROM else None
    return None


def classify(descriptors, profile):
    """Judge a part.

    Parameters
    ----------
    descriptors : Descriptors
    profile : Profile

    Returns
    -------
    Classification

    Notes
    -----
    After Giannini, Petton, Pernot (TMCE 2012), section 5. The paper's classes overlap and the
    first wins. A category is skipped only when all its criteria are known not to hold; where one
    cannot be told, neither can the verdict, and the part is ``unknown`` rather than ``normal``.
    """
    checked = tuple(each.check(descriptors, profile.area_floor) for each in profile.criteria)
    holding = tuple(each.criterion.id for each in checked if each.holds)
    category, reason, decided_by, ruled_out = NORMAL, "", (), []
    for candidate in profile.categories:
        own = [each for each in checked if each.criterion.category == candidate.name]
        decided_by = [each for each in own if each.holds]
        if decided_by:
            category = candidate.name
            break
        untold = [each for each in own if each.holds is None]
        if untold:
            return Classification(
                UNKNOWN, holding, checked, None, False, _reason(untold), DEFAULT_THIN_LIMIT
            )
        ruled_out += own
    margin = _margin(decided_by, ruled_out)
    borderline = margin is not None and margin < profile.borderline_margin
    return Classification(
        category, holding, checked, margin, borderline, reason, _thin_limit(decided_by, descriptors)
    )


def _thin_limit(decided_by, descriptors):
    bounds = [_thin_bound(condition) for each in decided_by for condition in each.conditions]
    limit = min((bound for bound in bounds if bound is not None), default=DEFAULT_THIN_LIMIT)
    shares = descriptors.distribution
    if shares.share(0.0, DEFAULT_THIN_LIMIT) >= 0.5 * shares.share(0.0, limit):
        return min(limit, DEFAULT_THIN_LIMIT)
    return limit


def _margin(decided_by, ruled_out):
    """Distance to the nearest other verdict.

    It flips when the strongest criterion that decided fails (the others hold less firmly), or when
    one that was ruled out comes to hold.
    """
    distances = [-each.margin for each in ruled_out]
    if decided_by:
        distances.append(max(each.margin for each in decided_by))
    return max(0.0, min(distances)) if distances else None


def _reason(untold):
    quantities = []
    for each in untold:
        for condition in each.conditions:
            symbol = condition.condition.quantity.symbol
            if condition.holds is None and symbol not in quantities:
                quantities.append(symbol)
    ids = ", ".join(str(each.criterion.id) for each in untold)
    return f"{', '.join(quantities)} could not be measured, so criterion {ids} cannot be told."
