# SPDX-License-Identifier: LGPL-2.1-or-later
"""Criteria and categories as data: profiles, and whether their conditions hold."""

import hashlib
import json
import math
import os
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Optional

from ..analysis_settings import DEFAULT_PROFILE
from ..categories import NORMAL, UNKNOWN
from ..descriptors.quantity import Quantity
from ..errors import ProfileError
from ..kinds import file_marks
from ..kinds.compound_kinds import ListOf, Record
from ..kinds.json_file import UnreadableJson, read_json
from ..kinds.value_kinds import LARGEST_WHOLE, Either, Number, OneOf, Text, Whole
from ..message import message
from ..record.record_types import PROFILE
from .impossible_conditions import impossible_conditions
from .probability import PROBABILITY, ProbabilityModel, named_quantity, probability_model

PAPER = "paper"
"""The profile with the paper's own thresholds, whose verdict is always recorded beside."""
PROFILES = Path(__file__).resolve().parents[3] / "resources" / "profiles"

MARGIN_LIMIT = 1000.0
"""Margins are clipped to this: an absent quantity or a threshold of 0 would give infinity."""

MOST_CONDITIONS = 1000
"""Conditions of a profile. Every pair of those of a criterion is compared, and every verdict checks all of them."""

COMPARISONS = ("<", ">")

_CONTENT = Record({
    "name": Text(),
    "categories": ListOf(Record({
        "name": Text(),
        "criteria": ListOf(Record({
            "id": Either(Whole(-LARGEST_WHOLE), Text()),
            "conditions": ListOf(Record({"quantity": Text(), "comparison": OneOf(COMPARISONS), "value": Number()})),
        }, {"title": Text()})),
    }, {"title": Text(), "meaning": Text()}), most=1000, distinct="name"),
}, {"title": Text(), "source": Text(), "area_floor": Number(0, 1), "borderline_margin": Number(0, MARGIN_LIMIT),
    "probability": PROBABILITY})


@dataclass(frozen=True)
class Condition:
    """A quantity, ``>`` or ``<``, and a threshold."""

    quantity: Quantity
    comparison: str
    value: float

    def check(self, descriptors, area_floor):
        """Compare the quantity with the threshold: CheckedCondition."""
        value = self.quantity.evaluate(descriptors, area_floor)
        if value is None:
            value = self.quantity.absent_means
        threshold = self.threshold(area_floor)
        if value is None:
            return CheckedCondition(self, None, threshold, None, None)
        error = self.quantity.error(descriptors, area_floor)
        difference = self._difference(value, threshold)
        if abs(difference) <= self.quantity.rounding_share(descriptors) * abs(threshold):
            difference = 0.0
        relative = difference / abs(threshold) if threshold else math.copysign(math.inf, difference)
        relative = self.quantity.margin(relative, threshold, descriptors)
        slack = max(-MARGIN_LIMIT, min(MARGIN_LIMIT, relative))
        holds = difference > 0.0
        if not holds and self._may_hold_where_unmet(difference, descriptors.unmet, area_floor):
            holds = None
        checked = CheckedCondition(self, value, threshold, holds, slack, error=error)
        if not descriptors.length_error or holds is None:
            return checked
        by_lengths = self.quantity.error(replace(descriptors, precision=None), area_floor)
        if replace(checked, error=by_lengths).is_certain:
            return checked
        if self.quantity.is_only_blurred(descriptors):
            return replace(checked, margin=0.0)
        return replace(checked, holds=None, too_coarse=True)

    def threshold(self, area_floor):
        """What the quantity is compared with: float, the value, or the area floor where that is larger."""
        return max(self.value, area_floor) if self.quantity.is_area_share else self.value

    @property
    def text(self):
        """str, as in ``V/VBB > 0.5``."""
        return f"{self.quantity.symbol} {self.comparison} {self.value:g}"

    def _difference(self, value, threshold):
        return value - threshold if self.comparison == ">" else threshold - value

    def _may_hold_where_unmet(self, difference, unmet, area_floor):
        """Whether surface about which nothing is known could make the condition hold."""
        if unmet <= area_floor:
            return False  # no more than stray rays
        if self.quantity.is_area_share:
            return self.comparison == ">" and difference + unmet > 0.0
        return self.quantity.is_wall_distance


@dataclass(frozen=True)
class CheckedCondition:
    """A condition and the result of its check.

    Attributes
    ----------
    condition : Condition
    value : float or None
        None where the quantity could not be measured.
    threshold : float
        The value compared with: that of the condition, or the area floor where that is larger.
    holds : bool or None
        None where it is undecided.
    margin : float or None
        Distance of the value from the threshold, relative to it; positive where the condition holds.
    too_coarse : bool
        Whether it is undecided because the surface mesh is too coarse for the part.
    error : float or None
        How far the value may be off.
    """

    condition: Condition
    value: Optional[float]
    threshold: float
    holds: Optional[bool]
    margin: Optional[float]
    too_coarse: bool = False
    error: Optional[float] = None

    @property
    def is_certain(self):
        """Whether the error of the value cannot turn the result."""
        return self.error is None or self.value is None or abs(self.value - self.threshold) > self.error


@dataclass(frozen=True)
class Criterion:
    """Conditions that must all hold."""

    id: object
    title: str
    category: str
    conditions: tuple

    def check(self, descriptors, area_floor):
        """Check every condition: CheckedCriterion."""
        checked = tuple(condition.check(descriptors, area_floor) for condition in self.conditions)
        verdicts = [row.holds for row in checked]
        holds = False if False in verdicts else (None if None in verdicts else True)
        margins = [row.margin for row in checked if row.margin is not None]
        # The margin of an "and" is that of its weakest condition, whether it holds or not.
        return CheckedCriterion(self, checked, holds, min(margins) if margins else None)


@dataclass(frozen=True)
class CheckedCriterion:
    """A criterion with its checked conditions; ``holds`` and ``margin`` as in `CheckedCondition`."""

    criterion: Criterion
    conditions: tuple
    holds: Optional[bool]
    margin: Optional[float]


@dataclass(frozen=True)
class Category:
    """A name and the criteria; the category applies if any of them holds."""

    name: str
    title: str
    meaning: str
    criteria: tuple


@dataclass(frozen=True)
class Profile:
    """An ordered list of categories; a part gets the first one that has a criterion which holds.

    Attributes
    ----------
    name, title, source : str
    area_floor : float
        Share of the area that "more than 0" means.
    borderline_margin : float
        Margin under which a verdict is called borderline, where the profile has no probabilities.
    categories : tuple of Category
    content : dict
        The profile as read; it is stored with every result.
    probability : ProbabilityModel or None
    """

    name: str
    title: str
    source: str
    area_floor: float
    borderline_margin: float
    categories: tuple
    content: dict
    probability: Optional[ProbabilityModel] = None

    @property
    def criteria(self):
        """All criteria in order."""
        return [criterion for category in self.categories for criterion in category.criteria]

    def is_certain_of_wall_distances(self, descriptors):
        """Whether no condition on a least distance between walls is within its error."""
        return all(condition.check(descriptors, self.area_floor).is_certain
                   for criterion in self.criteria for condition in criterion.conditions
                   if condition.quantity.is_wall_distance)


def load_profile(name_or_file=DEFAULT_PROFILE):
    """Read a profile by a shipped one's name, or from a JSON file; raises ProfileError."""
    path = PROFILES / f"{name_or_file}.json"
    if not os.path.isfile(path):  # Path.is_file raises an error for a name that is too long
        path = Path(name_or_file)
    try:
        content = read_json(path)
    except FileNotFoundError:
        shipped = ", ".join(sorted(path.stem for path in PROFILES.glob("*.json")))
        raise ProfileError(
            message("There is no profile {profile!r}: give a file or one of {known}.",
                    profile=str(name_or_file), known=shipped)
        ) from None
    except UnreadableJson as problem:
        raise ProfileError(message("The profile {profile} cannot be read ({problem}).",
                                   profile=path, problem=str(problem))) from None
    return usable_profile(content, str(path))


def profile_version(content):
    """A text that differs where the content of a profile, dict, does: str, twelve hexadecimal digits."""
    return hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:12]


def shipped_versions():
    """The `profile_version` of each shipped profile, dict of str to str, by its name."""
    return {path.stem: profile_version(load_profile(path.stem).content) for path in sorted(PROFILES.glob("*.json"))}


def given_profile(profile=DEFAULT_PROFILE):
    """The Profile that a shipped one's name, a JSON file, its content, or a Profile stands for; raises ProfileError."""
    if isinstance(profile, Profile):
        return profile
    return usable_profile(profile) if isinstance(profile, dict) else load_profile(profile)


def usable_profile(content, where=message("the profile")):
    """Like `profile_from`, for a profile to judge by: conditions that no part can meet are refused too; raises ProfileError.

    Parameters
    ----------
    content : dict
    where : str
        Name of the profile in error messages.
    """
    profile = profile_from(content, where)
    for found in impossible_conditions(profile):
        raise ProfileError(message("{profile} cannot be used: {problem} ({place}).",
                                   profile=where, problem=found.problem, place=found.path))
    return profile


def profile_from(content, where=message("the profile")):
    """Read a profile's content, as an info file may have it too.

    Raises ProfileError: one sentence that names the profile, the place in it and what is wrong there.

    Parameters
    ----------
    content : dict
    where : str
        Name of the profile in error messages.
    """
    if not file_marks.PROFILE.is_of(content):
        raise ProfileError(message("{profile} is not a ThinPart profile.", profile=where))
    if content.get("version") != 1:
        raise ProfileError(message("{profile} has version {version}; ThinPart reads version 1.",
                                   profile=where, version=repr(content.get("version"))))
    fault = _CONTENT.fault(content, "") or PROFILE.fault(content, "")
    if fault:
        raise ProfileError(message("{profile} is not well formed: {problem}.", profile=where, problem=fault))
    count = sum(len(criterion["conditions"]) for category in content["categories"] for criterion in category["criteria"])
    if count > MOST_CONDITIONS:
        raise ProfileError(message("{profile} has {count} conditions, more than {most}: leave some out.",
                                   profile=where, count=count, most=MOST_CONDITIONS))
    try:
        categories = tuple(_category(category, f"categories[{number}]")
                           for number, category in enumerate(content["categories"]))
        probability = probability_model(content["probability"], [category.name for category in categories]) \
            if "probability" in content else None
    except ValueError as error:
        raise ProfileError(message("{profile} is not well formed: {problem}.", profile=where, problem=error)) from None
    _check_names(categories, where)
    return Profile(content["name"], str(content.get("title", content["name"])), str(content.get("source", "")),
                   float(content.get("area_floor", 1e-4)), float(content.get("borderline_margin", 0.1)), categories,
                   content, probability)


def _check_names(categories, where):
    known: set = set()
    for criterion in (each for category in categories for each in category.criteria):
        if criterion.id in known:
            raise ProfileError(message("{profile} uses a criterion's id twice: {id!r}.",
                                       profile=where, id=str(criterion.id)))
        known.add(criterion.id)
    if {NORMAL, UNKNOWN} & {category.name for category in categories}:
        raise ProfileError(message("{profile} defines 'normal' or 'unknown', which are reserved: rename the category.",
                                   profile=where))


def _category(content, place):
    criteria = tuple(
        Criterion(criterion["id"], str(criterion.get("title", criterion["id"])), content["name"],
                  _conditions(criterion["conditions"], f"{place}.criteria[{number}].conditions"))
        for number, criterion in enumerate(content["criteria"]))
    return Category(content["name"], content.get("title", content["name"]), content.get("meaning", ""), criteria)


def _conditions(content, place):
    if not content:
        raise ValueError(message("{place} is empty, and a criterion without conditions would always hold", place=place))
    return tuple(_condition(condition, f"{place}[{number}]") for number, condition in enumerate(content))


def _condition(content, place):
    return Condition(named_quantity(content["quantity"], place), content["comparison"], float(content["value"]))
