# SPDX-License-Identifier: LGPL-2.1-or-later
"""The categories of many measured parts by one profile after another, of which each differs little from the one before."""

from collections import OrderedDict

import numpy as np

from ..categories import NORMAL, UNKNOWN

MOST_CONDITIONS = 256
"""Conditions whose results are kept: those of a few profiles. Each takes a byte per part."""

_FAILS, _HOLDS, _UNDECIDED = 0, 1, 2

_PARTS_AT_ONCE = 500
"""Parts between two calls of `check`: a few milliseconds."""


class VerdictTable:
    """Measured parts, and which conditions they meet.

    The category is that of `classify`. A condition is checked once on each part: so a profile with one new threshold takes
    about 20 microseconds per part.
    """

    def __init__(self):
        self._parts: list = []
        self._results: OrderedDict = OrderedDict()

    def __len__(self):
        return len(self._parts)

    def add(self, descriptors):
        """Add parts: iterable of Descriptors."""
        self._parts += descriptors

    def categories(self, profile, check=lambda: None):
        """Judge all parts.

        Parameters
        ----------
        profile : Profile
        check : callable, optional
            Called every few milliseconds; may raise to stop.

        Returns
        -------
        names : list of str
            The categories of the profile, ``normal`` and ``unknown``.
        numbers : ndarray of int, shape (n,)
            Position of each part's category among them.
        undecided : dict of Condition to ndarray of bool, shape (n,)
            For every condition, the parts that are ``unknown`` because it, perhaps with others, is undecided.
        """
        count = len(self._parts)
        normal, unknown = len(profile.categories), len(profile.categories) + 1
        numbers, is_open = np.full(count, normal), np.ones(count, bool)
        undecided: dict = {}
        for number, category in enumerate(profile.categories):
            holds, undecided_here = np.zeros(count, bool), []
            for criterion in category.criteria:
                results = [self._checked(condition, profile.area_floor, check) for condition in criterion.conditions]
                holds |= np.logical_and.reduce([result == _HOLDS for result in results])
                possible = np.logical_and.reduce([result != _FAILS for result in results])
                undecided_here += [(condition, possible & (result == _UNDECIDED))
                                   for condition, result in zip(criterion.conditions, results)]
            numbers[is_open & holds] = number
            is_open &= ~holds
            for condition, parts in undecided_here:
                undecided[condition] = undecided.get(condition, np.zeros(count, bool)) | (is_open & parts)
            is_undecided = is_open & np.logical_or.reduce([parts for _, parts in undecided_here], initial=False)
            numbers[is_undecided] = unknown
            is_open &= ~is_undecided
        return [*(category.name for category in profile.categories), NORMAL, UNKNOWN], numbers, undecided

    def _checked(self, condition, area_floor, check):
        """Results of a condition on all parts, ndarray of uint8."""
        key = condition.quantity.name, condition.quantity.bounds, condition.comparison, condition.value, area_floor
        known = self._results.pop(key, np.zeros(0, np.uint8))
        found = [known]
        for start in range(len(known), len(self._parts), _PARTS_AT_ONCE):
            check()
            found.append(np.array([_code(condition.check(part, area_floor).holds)
                                   for part in self._parts[start:start + _PARTS_AT_ONCE]], np.uint8))
        self._results[key] = np.concatenate(found)
        while len(self._results) > MOST_CONDITIONS:
            self._results.popitem(last=False)
        return self._results[key]


def _code(holds):
    return _UNDECIDED if holds is None else _HOLDS if holds else _FAILS
