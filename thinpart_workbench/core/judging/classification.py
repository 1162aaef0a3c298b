# SPDX-License-Identifier: LGPL-2.1-or-later
"""Classify a part by a profile. Nothing is measured here."""

from dataclasses import dataclass
from typing import Optional

from ..analysis_settings import MOST_TRIANGLES
from ..categories import NORMAL, UNKNOWN
from ..descriptors.quantity import MiddleShare, RidgeRatio
from ..figures import Length
from ..message import message

DEFAULT_THIN_LIMIT_X = 0.05
"""The paper's bound on thin features, criteria 5 and 7: for profiles that put no bound on a thickness."""


@dataclass(frozen=True)
class Classification:
    """A part's category and the evidence for it.

    Attributes
    ----------
    category : str
        A category of the profile, ``normal`` or ``unknown``.
    criteria : tuple
        Ids of all criteria that hold, not only those that decided.
    checked : tuple of CheckedCriterion
        The evidence: every criterion of the profile, in order.
    margin : float or None
        Distance of the deciding quantities from another verdict, relative to the thresholds; None where the
        verdict is ``unknown``.
    borderline : bool
        Whether the verdict is unsure: less probable than the profile asks for, or where the profile has no probabilities,
        with a margin below its ``borderline_margin``.
    reason : str
        Why the category is ``unknown``; empty otherwise.
    thin_limit_x : float
        Limit, in diagonals, under which a wall is shown as thin, so that the display agrees with the verdict: the least
        bound that the deciding criteria put on a thickness, or the least bound of all criteria where none decided. Also
        where it covers most of the area under the other, if that is by the diagonal: a quarter of it is no thin wall.
    probabilities : dict of str to float, or None
        Of every category, where the profile has a model of them and the verdict is not ``unknown``.
    """

    category: str
    criteria: tuple
    checked: tuple
    margin: Optional[float]
    borderline: bool
    reason: str
    thin_limit_x: float
    probabilities: Optional[dict] = None

    @property
    def is_certain(self):
        """Whether no condition that the verdict rests on is within its error: finer measuring would give the same."""
        return all(self._is_certain(row) for row in self.checked)

    def _is_certain(self, row):
        # A criterion that fails by one certain condition fails, whatever the others do.
        if any(condition.holds is False and condition.is_certain for condition in row.conditions):
            return True
        return all(condition.is_certain for condition in row.conditions)


def _thin_bound(checked, descriptors):
    condition = checked.condition
    quantity = condition.quantity
    return quantity.thin_bound(condition.value, descriptors) if condition.comparison == quantity.thin_where else None


def classify(descriptors, profile):
    """Classify a part: Classification.

    After Giannini, Petton, Pernot (TMCE 2012), section 5. The paper's classes overlap and the first one
    wins. A category is skipped only when all its criteria are known not to hold. If one of them is undecided,
    so is the verdict, and the part is ``unknown`` rather than ``normal``.
    """
    checked = tuple(criterion.check(descriptors, profile.area_floor) for criterion in profile.criteria)
    holding = tuple(row.criterion.id for row in checked if row.holds)
    category, reason = NORMAL, ""
    decided_by: list = []
    ruled_out: list = []
    for candidate in profile.categories:
        own = [row for row in checked if row.criterion.category == candidate.name]
        decided_by = [row for row in own if row.holds]
        if decided_by:
            category = candidate.name
            break
        undecided = [row for row in own if row.holds is None]
        if undecided:
            return Classification(UNKNOWN, holding, checked, None, False, _reason(undecided, descriptors),
                                  _thin_limit_x((), checked, descriptors))
        ruled_out += own
    margin = _margin(decided_by, ruled_out)
    probabilities = profile.probability and profile.probability.probabilities(descriptors, profile.area_floor)
    return Classification(
        category, holding, checked, margin, _is_unsure(profile, category, margin, probabilities), reason,
        _thin_limit_x(decided_by, checked, descriptors), probabilities,
    )


def _is_unsure(profile, category, margin, probabilities):
    if probabilities is None:
        return margin is not None and margin < profile.borderline_margin
    # A margin of 0 is that of lengths whose error could turn the verdict.
    return probabilities[category] < profile.probability.unsure_under or margin == 0.0


def _thin_limit_x(decided_by, checked, descriptors):
    least = _least_bound(checked, descriptors, DEFAULT_THIN_LIMIT_X)
    limit = _least_bound(decided_by, descriptors, least)
    if any(isinstance(row.condition.quantity, (MiddleShare, RidgeRatio))
           for checked in decided_by for row in checked.conditions):
        return limit  # what the verdict speaks of
    shares = descriptors.distribution
    if shares.share(0.0, least) >= 0.5 * shares.share(0.0, limit):
        return least
    return limit


def _least_bound(criteria, descriptors, default):
    bounds = [_thin_bound(condition, descriptors) for each in criteria for condition in each.conditions]
    return min((bound for bound in bounds if bound is not None), default=default)


def _margin(decided_by, ruled_out):
    """Distance to the nearest other verdict.

    The verdict changes when the strongest deciding criterion fails (the others have smaller margins), or when a
    criterion that was ruled out comes to hold.
    """
    distances = [-row.margin for row in ruled_out]
    if decided_by:
        distances.append(max(row.margin for row in decided_by))
    return max(0.0, min(distances)) if distances else None


def _reason(undecided, descriptors):
    conditions = [condition for row in undecided for condition in row.conditions]
    if any(condition.too_coarse for condition in conditions):
        return too_fine_reason(descriptors.length_error)
    quantities = []
    for row in undecided:
        for condition in row.conditions:
            symbol = condition.condition.quantity.symbol
            if condition.holds is None and symbol not in quantities:
                quantities.append(symbol)
    return unmeasured_reason(quantities, [row.criterion.id for row in undecided])


def too_fine_reason(length_error):
    """Message: why a part is ``unknown`` whose lengths may be off by `length_error` mm."""
    return message("The part is too slender or too fine to be measured: it needs more than {triangles:,} triangles, "
                   "with fewer its lengths are accurate to {mm:.2g} only.",
                   triangles=MOST_TRIANGLES, mm=Length(length_error))


def unmeasured_reason(quantities, criteria):
    """Message: why a part is ``unknown`` when missing quantities leave some criteria undecided."""
    return message("{quantities} could not be measured, so criterion {criteria} cannot be decided.",
                   quantities=", ".join(quantities), criteria=", ".join(map(str, criteria)))
