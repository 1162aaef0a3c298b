# SPDX-License-Identifier: LGPL-2.1-or-later
"""Search for the thresholds of a profile by which most parts get the verdict that people gave them."""

import copy
from dataclasses import dataclass, replace
from itertools import chain
from typing import NamedTuple

import numpy as np

from ..descriptors.quantity import MiddleShare
from ..kinds.value_kinds import Number, OrNull
from .criteria import Condition, Profile, profile_from
from .impossible_conditions import impossibility

PULL = 0.5
"""Parts that a step away from the start has to win: where labels do not speak, the start is kept."""

DROPPED = 2.0
"""Parts that leaving out a condition or a criterion has to win."""

ODDS_STEP, RATIO_STEP, FLOOR_STEP, BOUND_STEP = 1.5, 1.2, 3.0, 1.2
"""Factors from one candidate to the next: of the odds of an area share, of other thresholds, of an area share that starts at
0, and of the upper bound of walls. Each is a change that a part's picture just shows."""

_SHARES = Number(0, 1), OrNull(Number(0, 1))

_STEPS, _BOUND_STEPS = 4, 2
"""Greatest number of steps from the start."""


@dataclass(frozen=True)
class _Candidates:
    """What a condition may become, that of the start first.

    Attributes
    ----------
    conditions : list of Condition, of length m
    steps : ndarray of shape (m,)
        Distance from the start.
    holds, may_hold : ndarray of bool, shape (m, n)
        For each of n parts whether the condition holds, and whether it holds or is undecided.
    """

    conditions: list
    steps: np.ndarray
    holds: np.ndarray
    may_hold: np.ndarray


class FoundProfile(NamedTuple):
    """The profile that was found.

    Attributes
    ----------
    profile : Profile
        With the categories of the start and its other entries.
    conditions : tuple of (Criterion, Condition, Condition or None)
        Every criterion and condition of the start, and what it became; None where it was left out.
    """

    profile: Profile
    conditions: tuple


class ThresholdSearch:
    """A coordinate search near the thresholds of a profile.

    The errors of lengths, which make some verdicts of `classify` unknown, are left out of account here.

    Parameters
    ----------
    profile : Profile
        The start.
    descriptors : list of Descriptors, of length n
    """

    def __init__(self, profile, descriptors):
        self._profile = profile
        self._candidates: list[_Candidates] = []
        self._criteria: list[tuple] = []
        for number, category in enumerate(profile.categories):
            for criterion in category.criteria:
                first = len(self._candidates)
                self._candidates += [_measured(condition, descriptors, profile.area_floor)
                                     for condition in criterion.conditions]
                self._criteria.append((number, range(first, len(self._candidates))))

    def best(self, worth):
        """Find the profile that is worth most: FoundProfile.

        Parameters
        ----------
        worth : ndarray of shape (n, categories + 1)
            Of each verdict on each part; the last one is normal. The verdict unknown is worth nothing.
        """
        worth = np.column_stack([worth, np.zeros(len(worth))])
        choice = [0] * len(self._candidates)
        best = self._value(choice, worth)
        while True:
            before = best
            for varied in range(len(choice)):
                if choice[varied] is None:
                    continue
                values = self._value(choice, worth, varied)
                if values.max() > best + 1e-9:
                    choice[varied], best = int(np.argmax(values)), float(values.max())
            if best == before:
                choice, best = self._restructured(choice, best, worth)
            if best == before:
                return self._chosen(self._possible(choice))

    def _possible(self, choice):
        """The choice without criteria whose thresholds have passed each other: no part meets them any more."""
        choice = list(choice)
        for category, conditions in self._criteria:
            used = [each for each in conditions if choice[each] is not None]
            if impossibility([self._candidates[each].conditions[choice[each]] for each in used], self._profile.area_floor):
                others = any(choice[each] is not None for number, more in self._criteria
                             if number == category and more != conditions for each in more)
                for each in conditions:
                    choice[each] = None if others else 0  # a category keeps a criterion: that of the start
        return choice

    def _restructured(self, choice, best, worth):
        """The first better choice with one condition or criterion less or more, or else two; and its value.

        Two, because where one condition never holds and another always does, leaving out one of them wins nothing.
        """
        single = list(self._with_and_without(choice))
        for other in chain(single, (more for each in single for more in self._with_and_without(each))):
            value = self._value(other, worth)
            if value > best + 1e-9:
                return other, value
        return choice, best

    def _with_and_without(self, choice):
        """The choices with one condition or one criterion less, or more."""
        for category, conditions in self._criteria:
            used = [each for each in conditions if choice[each] is not None]
            others = any(choice[each] is not None for number, more in self._criteria
                         if number == category and more != conditions for each in more)
            changes: list[dict] = []
            if not used:
                changes.append(dict.fromkeys(conditions, 0))
            else:
                changes += [{each: 0} for each in conditions if choice[each] is None]
                changes += [{each: None} for each in used if len(used) > 1]
                changes += [dict.fromkeys(conditions, None)] * others
            for change in changes:
                yield [change.get(number, each) for number, each in enumerate(choice)]

    def _value(self, choice, worth, varied=None):
        """What a choice is worth less what it costs: float, or with `varied` an ndarray over its candidates."""
        verdicts = self._verdicts(choice, len(worth), varied)
        steps = 0.0 if varied is None else self._candidates[varied].steps
        cost = PULL * (steps + sum(self._candidates[number].steps[each] for number, each in enumerate(choice)
                                   if each is not None and number != varied))
        for _, conditions in self._criteria:
            missing = sum(choice[each] is None for each in conditions)
            cost = cost + DROPPED * (1 if missing == len(conditions) else missing)
        values = worth[np.arange(len(worth)), verdicts].sum(axis=-1) - cost
        return float(values[0]) if varied is None else values

    def _verdicts(self, choice, count, varied):
        """Columns of the worth, ndarray of int of shape (m, n), m being 1 without `varied`; as `classify` decides."""
        categories = len(self._profile.categories)
        held, possible = [np.zeros((1, count), bool)] * categories, [np.zeros((1, count), bool)] * categories
        for category, conditions in self._criteria:
            used = [each for each in conditions if choice[each] is not None]
            if not used:
                continue
            rows = [slice(None) if each == varied else slice(choice[each], choice[each] + 1) for each in used]
            holds = may_hold = np.ones((1, count), bool)
            for each, row in zip(used, rows):
                holds = holds & self._candidates[each].holds[row]
                may_hold = may_hold & self._candidates[each].may_hold[row]
            held[category] = held[category] | holds
            possible[category] = possible[category] | may_hold
        verdicts = np.full((1, count), categories)
        for category in reversed(range(categories)):
            verdicts = np.where(held[category], category, np.where(possible[category], categories + 1, verdicts))
        return verdicts

    def _chosen(self, choice):
        content = copy.deepcopy(self._profile.content)
        criteria = [criterion for category in content["categories"] for criterion in category["criteria"]]
        dropped = set()
        for criterion, (_, conditions) in zip(criteria, self._criteria):
            kept = [_content(written, self._candidates[each].conditions[choice[each]])
                    for written, each in zip(criterion["conditions"], conditions) if choice[each] is not None]
            criterion["conditions"] = kept
            if not kept:
                dropped.add(id(criterion))
        for category in content["categories"]:
            category["criteria"] = [each for each in category["criteria"] if id(each) not in dropped]
        return FoundProfile(profile_from(content), tuple(
            (criterion, condition, None if chosen is None else candidates.conditions[chosen])
            for (criterion, condition), candidates, chosen in zip(
                [(criterion, condition) for criterion in self._profile.criteria for condition in criterion.conditions],
                self._candidates, choice)))


def _content(written, condition):
    return {**written, "quantity": condition.quantity.symbol if condition.quantity.bounds else written["quantity"],
            "value": condition.value}


def _measured(condition, descriptors, area_floor):
    conditions, steps = zip(*sorted(_near(condition, area_floor), key=lambda each: each[1]))
    values = {}
    for each in conditions:
        quantity = each.quantity
        if quantity.symbol not in values:
            found = [quantity.evaluate(part, area_floor) for part in descriptors]
            values[quantity.symbol] = np.array([quantity.absent_means if value is None else value for value in found], float)
    value = np.array([values[each.quantity.symbol] for each in conditions])
    threshold = np.array([[each.threshold(area_floor)] for each in conditions])
    with np.errstate(invalid="ignore"):
        holds = value > threshold if condition.comparison == ">" else value < threshold
    return _Candidates(list(conditions), np.array(steps, float), holds, holds | np.isnan(value))


def _near(condition, area_floor):
    """Pairs of a condition and its steps from the start, which is among them."""
    quantities = [(condition.quantity, 0)]
    quantity = condition.quantity
    if isinstance(quantity, MiddleShare) and quantity.bounds[0] == 0.0:
        name, high = quantity.symbol.partition("[")[0], quantity.bounds[1]
        for step in _both_ways(_BOUND_STEPS):
            bound = _readable(high * BOUND_STEP ** step)
            quantities.append((quantity.bounded(f"{name}[0;{bound:g}]", 0.0, bound), abs(step)))
    for other, steps in quantities:
        yield replace(condition, quantity=other), steps
        for step in _both_ways(_STEPS):
            value = _threshold(condition, step, area_floor)
            if value is not None:
                yield Condition(other, condition.comparison, value), steps + abs(step)


def _threshold(condition, step, area_floor):
    start = condition.value
    is_share = condition.quantity.is_area_share or condition.quantity.kind in _SHARES
    if is_share and 0.0 < start < 1.0:
        odds = start / (1.0 - start) * ODDS_STEP ** step
        return _readable(odds / (1.0 + odds))
    if start == 0.0:
        return _readable(max(area_floor, 1e-6) * FLOOR_STEP ** step) if is_share and step > 0 else None
    return _readable(start * RATIO_STEP ** step)


def _both_ways(most):
    return [step for step in range(-most, most + 1) if step]


def _readable(value):
    """Two digits are as many as the labels can tell apart."""
    return float(f"{value:.2g}")
