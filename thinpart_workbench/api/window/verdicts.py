# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be said of the verdict on a part: why it is so, how sure it is, and what the paper would say."""

from typing import NamedTuple, Optional

from ...core.categories import UNKNOWN
from ...core.judging import paper_verdict
from ...core.judging.criteria import Profile
from ...core.judging.verdict_reasons import deciding_criteria, nearest_other, reason_of
from ...core.judging.verdict_sentence import verdict_sentence
from ...core.message import Message
from ...core.record import thinnest_sentence
from ...core.record.record_types import PartRecord
from ...core.record.verdict_chances import named_between, verdict_chances
from ...core.risk.risk_sentence import risk_sentence


class Why(NamedTuple):
    """Why a part has its category: a ``sentence``, empty where none says it; then ``criteria`` do, list of EvidenceRow."""

    sentence: str
    criteria: list


class Sureness(NamedTuple):
    """How sure a verdict is: ``margin`` from the limit, or None where ``probability`` says it; the ``other`` category that
    the part might have, and ``other_probability``; whether it is ``borderline``."""

    margin: Optional[float]
    probability: Optional[float]
    other: str
    other_probability: Optional[float]
    borderline: bool


def why(record: PartRecord) -> Why:
    """Why a part has its category, or why that is unknown.

    Examples
    --------
    >>> "% of the surface: consider shells" in why(record).sentence
    True
    """
    if record["category"] == UNKNOWN:
        return Why(reason_of(record), [])
    return Why(verdict_sentence(record) or "", deciding_criteria(record))


def sureness(record: PartRecord) -> Optional[Sureness]:
    """How sure the verdict on a part is; None where that is unknown.

    Examples
    --------
    >>> sureness(record).borderline
    False
    """
    if record["margin"] is None:
        return None
    chances = verdict_chances(record)
    if chances is not None:
        return Sureness(None, chances.own, chances.other, chances.others, record["borderline"])
    return Sureness(record["margin"], None, nearest_other(record), None, record["borderline"])


def between(record: PartRecord) -> tuple[str, ...]:
    """The two categories that an unsure verdict leaves open, the likelier first; empty where it is sure.

    Examples
    --------
    >>> between(record)
    ()
    """
    return named_between(record)


def thinnest_kind(record: PartRecord) -> str:
    """What the thinnest wall is: ``taper``, ``edge``, or empty for a wall between parallel sides.

    Examples
    --------
    >>> thinnest_kind(record)
    ''
    """
    return thinnest_sentence.thinnest_kind(record)


def mesh_risk(record: PartRecord) -> str:
    """The risk of the automatic mesh of a part, and what raises it; or why it is unknown.

    Examples
    --------
    >>> mesh_risk(record).startswith("Risk of the automatic mesh: ")
    True
    """
    return risk_sentence(record)


def paper_sentence(record: PartRecord, profile: Profile) -> str:
    """What the paper's criteria make of a part, with the figure that decides; empty where that is what the profile says.

    Examples
    --------
    >>> paper_sentence(record, preferred)  # a plate, which is thin by both
    ''
    """
    return paper_verdict.paper_sentence(record, profile)


def thinnest(record: PartRecord) -> Message:
    """Where a part is thinnest, over walls at any angle, in a sentence.

    Examples
    --------
    >>> str(thinnest(record))
    'Thinnest wall 8 mm.'
    """
    return thinnest_sentence.thinnest_sentence(record)
