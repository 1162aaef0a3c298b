# SPDX-License-Identifier: LGPL-2.1-or-later
"""How probable the verdict on a part is, and what else the part may be."""

from typing import NamedTuple


class VerdictChances(NamedTuple):
    """Of a part record.

    Attributes
    ----------
    own, others : float
        Probabilities of the category of the verdict, and of the likeliest other one.
    other : str
        That one.
    """

    own: float
    other: str
    others: float


def verdict_chances(record):
    """The chances of a verdict: VerdictChances; None where its profile has no probabilities, or it is unknown.

    Parameters
    ----------
    record : PartRecord
    """
    if record["margin"] is None or not record.get("probabilities"):
        return None
    chances = {each["category"]: each["probability"] for each in record["probabilities"]}
    own = chances.pop(record["category"])
    other = max(chances, key=lambda each: chances[each])
    return VerdictChances(own, other, chances[other])


def open_between(record):
    """The two categories between which an unsure verdict leaves a part, with their probabilities, the likelier first.

    Returns a list of two tuples of str and float; None where the verdict is sure, or has no probabilities.

    Parameters
    ----------
    record : PartRecord
    """
    chances = verdict_chances(record) if record["borderline"] else None
    if chances is None:
        return None
    return sorted([(record["category"], chances.own), (chances.other, chances.others)], key=lambda each: -each[1])


def named_between(record):
    """The two categories of `open_between`, by their names: tuple of str, empty where the verdict is sure.

    Parameters
    ----------
    record : PartRecord
    """
    return tuple(category for category, _ in open_between(record) or ())
