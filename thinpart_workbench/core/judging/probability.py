# SPDX-License-Identifier: LGPL-2.1-or-later
"""How probable each category is, by a model that a profile may bring."""

import math
from dataclasses import dataclass

from ..categories import NORMAL
from ..descriptors.descriptor_table import quantity_named, quantity_symbols
from ..descriptors.quantity import Quantity
from ..kinds.compound_kinds import ListOf, Record
from ..kinds.value_kinds import LARGEST, Number, OrNull, Text
from ..message import message

TERM, OFFSET = {"quantity": Text(), "weight": Number()}, {"log_offset": OrNull(Number(1 / LARGEST))}
"""Kinds of the keys of a term, those that it has and that it may have."""

PROBABILITY = Record({
    "unsure_under": Number(0, 1),
    "steps": ListOf(Record({
        "category": Text(),
        "intercept": Number(),
        "terms": ListOf(Record(TERM, OFFSET)),
    }), most=1000),
})
"""Kind of the entry ``probability`` of a profile."""


@dataclass(frozen=True)
class WeightedQuantity:
    """A quantity's part in a sum.

    Attributes
    ----------
    quantity : Quantity
    weight : float
    log_offset : float or None
        None for the quantity itself; otherwise the logarithm to base 10 of the quantity and this offset together.
    """

    quantity: Quantity
    weight: float
    log_offset: object = None

    def value(self, descriptors, area_floor):
        """The weighted value, float; None where the quantity could not be measured."""
        value = self.quantity.evaluate(descriptors, area_floor)
        if value is None:
            value = self.quantity.absent_means
        if value is None or math.isinf(value):
            return None
        if self.log_offset is not None:
            value = math.log10(max(value, 0.0) + self.log_offset)
        return self.weight * value


@dataclass(frozen=True)
class Step:
    """How probable a category is where none of those before it applies: the logistic function of a sum of terms."""

    category: str
    intercept: float
    terms: tuple


@dataclass(frozen=True)
class ProbabilityModel:
    """One logistic regression per category, in the order of the profile; what none takes is normal.

    Continuation-ratio logits (Fienberg 1980, The Analysis of Cross-Classified Categorical Data, chapter 6): they follow the
    order of the categories, of which a part takes the first that applies.

    Attributes
    ----------
    unsure_under : float
        A verdict that is less probable than this is unsure.
    steps : tuple of Step
    """

    unsure_under: float
    steps: tuple

    def probabilities(self, descriptors, area_floor):
        """Probability of every category: dict of str to float or None.

        They sum to 1. None where a quantity could not be measured.

        Parameters
        ----------
        descriptors : Descriptors
        area_floor : float
        """
        found, remaining = {}, 1.0
        for step in self.steps:
            values = [term.value(descriptors, area_floor) for term in step.terms]
            if None in values:
                return None
            share = logistic(step.intercept + math.fsum(values))
            found[step.category] = remaining * share
            remaining *= 1.0 - share
        found[NORMAL] = remaining
        return found


def probability_model(content, categories):
    """Read the model of a profile: ProbabilityModel.

    Raises ValueError where it names an unknown quantity, or its steps are not those of the categories.

    Parameters
    ----------
    content : dict
        Entry ``probability`` of a profile, of the kind `PROBABILITY`.
    categories : sequence of str
        The profile's own, in order.
    """
    steps = tuple(
        Step(step["category"], float(step["intercept"]), tuple(
            weighted_quantity(term, f"probability.steps[{number}].terms[{place}]")
            for place, term in enumerate(step["terms"])))
        for number, step in enumerate(content["steps"]))
    if [step.category for step in steps] != list(categories):
        raise ValueError(message("its probabilities are not of its categories, in their order"))
    return ProbabilityModel(float(content["unsure_under"]), steps)


def weighted_quantity(content, place):
    """The term of a model: WeightedQuantity; raises ValueError as `named_quantity` does.

    Parameters
    ----------
    content : dict
        Keys of `TERM` and `OFFSET`.
    place : str
        Of the term in its file.
    """
    offset = content.get("log_offset")
    return WeightedQuantity(named_quantity(content["quantity"], place), float(content["weight"]),
                            None if offset is None else float(offset))


def named_quantity(text, place):
    """The quantity that an entry of a profile names: Quantity.

    Raises ValueError: a sentence that names the place, and the quantities that there are.

    Parameters
    ----------
    text : str
    place : str
        Of the entry in the profile.
    """
    try:
        return quantity_named(text)
    except (KeyError, ValueError):  # the latter where bounds have two points
        raise ValueError(message("{place} names {quantity!r}, which is no quantity: there are {known}, a below b",
                                 place=place, quantity=text, known=quantity_symbols())) from None


def logistic(x):
    """The probability, float, whose odds have the logarithm x."""
    return 1.0 / (1.0 + math.exp(-x)) if x >= 0.0 else math.exp(x) / (1.0 + math.exp(x))
