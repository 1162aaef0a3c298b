# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conditions of a profile that no part can meet: thresholds out of reach, and pairs that exclude each other."""

from typing import NamedTuple

from ..message import Message, message


class Impossible(NamedTuple):
    """A criterion that can never hold, and the reason.

    Attributes
    ----------
    category, criterion, condition : int
        Positions in the profile, each within the one before; the condition is the last of those that are the reason.
    problem : Message
    """

    category: int
    criterion: int
    condition: int
    problem: Message

    @property
    def path(self):
        """str: the place in the profile's file."""
        return f"categories[{self.category}].criteria[{self.criterion}].conditions[{self.condition}]"


def impossible_conditions(profile):
    """Find the criteria that no part can meet: list of Impossible, at most one for each criterion.

    Looked at are single conditions and pairs of them, by what is true of every part: shares lie between 0 and 1, sides of
    the box are in order, and there is no more surface over some walls than over more of them. Three conditions that exclude
    each other only together, as shares that add up to more than 1, are not found.
    """
    return [Impossible(number, place, *reason)
            for number, category in enumerate(profile.categories) for place, criterion in enumerate(category.criteria)
            for reason in [impossibility(criterion.conditions, profile.area_floor)] if reason is not None]


def impossibility(conditions, area_floor):
    """Why conditions cannot all hold: tuple of (int, Message) or None.

    Position of the last condition that takes part in it, and the reason; None where they may hold.

    Parameters
    ----------
    conditions : sequence of Condition
    area_floor : float
    """
    for number, condition in enumerate(conditions):
        reason = _out_of_reach(condition, area_floor)
        for other in conditions[:number]:
            reason = reason or _exclusion(other, condition, area_floor)
        if reason:
            return number, reason
    return None


def _out_of_reach(condition, area_floor):
    least, most = condition.quantity.limits
    threshold = condition.threshold(area_floor)
    if condition.comparison == ">" and threshold >= most:
        return message("{condition} never holds, because it is never above {limit:g}", condition=condition.text, limit=most)
    if condition.comparison == "<" and (threshold <= least or condition.value < least):
        return message("{condition} never holds, because it is never below {limit:g}", condition=condition.text, limit=least)
    return None


def _exclusion(first, second, area_floor):
    """The reason why one condition excludes the other; None where it does not."""
    for more, less in ((first, second), (second, first)):
        if ((more.comparison, less.comparison) == (">", "<") and more.quantity.is_never_more_than(less.quantity)
                and more.threshold(area_floor) >= less.threshold(area_floor)):
            return message("{first} and {second} exclude each other", first=first.text, second=second.text)
    return None
