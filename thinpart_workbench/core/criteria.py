"""Criteria and categories as data: profiles, and whether their conditions hold."""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from .categories import NORMAL, UNKNOWN
from .descriptors import quantity_named
from .errors import ProfileError

FORMAT = "thinpart-profile"
PROFILES = Path(__file__).resolve().parents[2] / "resources" / "profiles"
MARGIN_LIMIT = 1000.0
"""Margins are cut off here: a quantity that is absent or a threshold of 0 would give infinity."""


@dataclass(frozen=True)
class Condition:
    """A quantity, ``>`` or ``<``, and a threshold."""

    quantity: object
    comparison: str
    value: float

    def check(self, descriptors, area_floor):
        """Compare.

        Returns
        -------
        CheckedCondition
        """
        value = self.quantity.evaluate(descriptors, area_floor)
        if value is None:
            value = self.quantity.absent_means
        threshold = self.value
        if self.quantity.is_area_share:
            threshold = max(threshold, area_floor)
        if value is None:
            return CheckedCondition(self, None, threshold, None, None)
        difference = value - threshold if self.comparison == ">" else threshold - value
        relative = difference / abs(threshold) if threshold else math.copysign(math.inf, difference)
        slack = max(-MARGIN_LIMIT, min(MARGIN_LIMIT, relative))
        holds = difference > 0.0
        if not holds and self._may_hold_unseen(difference, descriptors.unmet, area_floor):
            holds = None
        return CheckedCondition(self, value, threshold, holds, slack)

    def _may_hold_unseen(self, difference, unmet, area_floor):
        """Whether surface that nothing is known about could make it hold."""
        if self.quantity.is_area_share:
            return self.comparison == ">" and difference + unmet > 0.0
        return self.quantity.name == "min_nonparallel" and unmet > area_floor


@dataclass(frozen=True)
class CheckedCondition:
    """A condition with what it met.

    Attributes
    ----------
    condition : Condition
    value : float or None
        None where the quantity could not be measured.
    threshold : float
        Against which was compared: the condition's value, or the area floor where that is larger.
    holds : bool or None
        None where it cannot be told.
    margin : float or None
        How far the value lies inside (positive) or outside, relative to the threshold.
    """

    condition: Condition
    value: Optional[float]
    threshold: float
    holds: Optional[bool]
    margin: Optional[float]


@dataclass(frozen=True)
class Criterion:
    """Conditions that must all hold."""

    id: object
    title: str
    category: str
    conditions: tuple

    def check(self, descriptors, area_floor):
        """Check every condition.

        Returns
        -------
        CheckedCriterion
        """
        checked = tuple(each.check(descriptors, area_floor) for each in self.conditions)
        verdicts = [each.holds for each in checked]
        holds = False if False in verdicts else (None if None in verdicts else True)
        margins = [each.margin for each in checked if each.margin is not None]
        # The weakest condition decides how far an "and" lies from flipping, held or not.
        return CheckedCriterion(self, checked, holds, min(margins) if margins else None)


@dataclass(frozen=True)
class CheckedCriterion:
    """A criterion with its checked conditions; ``holds`` and ``margin`` as there."""

    criterion: Criterion
    conditions: tuple
    holds: Optional[bool]
    margin: Optional[float]


@dataclass(frozen=True)
class Category:
    """A name, and criteria of which one is enough."""

    name: str
    title: str
    meaning: str
    criteria: tuple


@dataclass(frozen=True)
class Profile:
    """An ordered list of categories; a part takes the first of which one criterion holds.

    Attributes
    ----------
    name, title, source : str
    area_floor : float
        Share of the area that "more than 0" means.
    borderline_margin : float
        Margin under which a verdict is called borderline.
    categories : tuple of Category
    content : dict
        The profile as read, to be kept with every result.
    """

    name: str
    title: str
    source: str
    area_floor: float
    borderline_margin: float
    categories: tuple
    content: dict

    @property
    def criteria(self):
        """All criteria in order."""
        return [criterion for category in self.categories for criterion in category.criteria]


def load_profile(name_or_file="paper"):
    """Read a profile.

    Parameters
    ----------
    name_or_file : str or Path
        A shipped profile's name, or a JSON file.

    Raises
    ------
    ProfileError
    """
    path = PROFILES / f"{name_or_file}.json"
    if not path.is_file():
        path = Path(name_or_file)
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        shipped = ", ".join(sorted(each.stem for each in PROFILES.glob("*.json")))
        raise ProfileError(
            f"There is no profile {str(name_or_file)!r}: give a file or one of {shipped}."
        ) from None
    except (OSError, ValueError) as error:
        raise ProfileError(f"The profile {path} cannot be read ({error}).") from None
    return profile_from(content, str(path))


def profile_from(content, where="the profile"):
    """Check a profile's content.

    Parameters
    ----------
    content : dict
    where : str
        Named in errors.

    Raises
    ------
    ProfileError
    """
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise ProfileError(f"{where} is not a ThinPart profile.")
    if content.get("version") != 1:
        raise ProfileError(f"{where} has version {content.get('version')!r}; this reads version 1.")
    try:
        categories = tuple(_category(each) for each in content["categories"])
        profile = Profile(
            str(content["name"]), str(content.get("title", content["name"])),
            str(content.get("source", "")), float(content.get("area_floor", 1e-4)),
            float(content.get("borderline_margin", 0.1)), categories, content,
        )
    except KeyError as error:
        raise ProfileError(f"{where} lacks or does not know {error}.") from None
    except (TypeError, ValueError, AttributeError) as error:
        raise ProfileError(f"{where} is not well formed: {error}.") from None
    ids = [criterion.id for criterion in profile.criteria]
    if len(set(ids)) != len(ids):
        raise ProfileError(f"{where} uses a criterion's id twice.")
    if {NORMAL, UNKNOWN} & {category.name for category in categories}:
        raise ProfileError(f"{where} defines 'normal' or 'unknown', which stand for themselves.")
    return profile


def _category(content):
    criteria = tuple(
        Criterion(
            each["id"], str(each.get("title", each["id"])), str(content["name"]),
            tuple(_condition(condition) for condition in each["conditions"]),
        )
        for each in content["criteria"]
    )
    if not all(criterion.conditions for criterion in criteria):
        raise ValueError("a criterion without conditions would always hold")
    return Category(str(content["name"]), str(content.get("title", content["name"])),
                    str(content.get("meaning", "")), criteria)


def _condition(content):
    if content["comparison"] not in ("<", ">"):
        raise ValueError(f"comparison {content['comparison']!r} is neither < nor >")
    value = float(content["value"])
    if not math.isfinite(value):
        raise ValueError("a threshold must be finite")
    return Condition(quantity_named(content["quantity"]), content["comparison"], value)
