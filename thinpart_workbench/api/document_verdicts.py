# SPDX-License-Identifier: LGPL-2.1-or-later
"""Summaries of the verdicts on the parts of a document, and the changes between two of them."""

from typing import Any, Optional, TypedDict

from ..core.judging.verdict_reasons import reason_of
from ..core.record.record_types import PartRecord
from ..core.record.verdict_chances import named_between


class PartVerdict(TypedDict):
    """The verdict on a part: ``label``, ``category`` and its ``title``, the same of the two ``between`` which it is where it
    is unsure, ``reason``, ``evidence`` without the conditions, ``thickness`` (of the thinnest wall, mm, or None) and its
    ``error_bound``, mm."""

    label: str
    category: str
    title: str
    between: list[tuple[str, str]]
    reason: str
    evidence: list[dict[str, Any]]
    thickness: Optional[float]
    error_bound: float


def document_verdicts(records: list[PartRecord], profile: dict) -> dict[str, PartVerdict]:
    """Summaries of part records, by name, small enough to be kept and compared for every open document.

    The content of the profile is that by which the parts were judged.

    Examples
    --------
    >>> [verdict["title"] for verdict in document_verdicts([record], profile).values()]
    ['Thin part']
    """
    titles = {category["name"]: category.get("title", category["name"]) for category in profile["categories"]}
    return {record["name"]: _verdict(record, titles) for record in records}


def _verdict(record: PartRecord, titles: dict[str, str]) -> PartVerdict:
    walls = record["descriptors"]["thickness_mm"]
    return {
        "label": record["label"],
        "category": record["category"],
        "title": titles.get(record["category"], record["category"]),
        "between": [(name, titles.get(name, name)) for name in named_between(record)],
        "reason": reason_of(record),
        "evidence": [{key: row[key] for key in ("criterion", "category", "title", "holds")}
                     for row in record["evidence"]],
        "thickness": walls["min"],
        "error_bound": walls["error_bound"],
    }


def category_changes(before, now):
    """Parts whose category has changed.

    Parameters
    ----------
    before : dict of str to PartVerdict, or None
        From `document_verdicts`; None if the document was not classified before.
    now : dict of str to PartVerdict

    Returns
    -------
    list of (PartVerdict, PartVerdict)
        The old and the new verdict on a part.

    Examples
    --------
    >>> verdicts = document_verdicts([record], profile)
    >>> category_changes(verdicts, verdicts)
    []
    """
    verdict_pairs = [((before or {}).get(name), verdict) for name, verdict in now.items()]
    return [(old, new) for old, new in verdict_pairs
            if old is not None and old["category"] != new["category"]]


def walls_newly_under(before, now, limit):
    """Parts whose thinnest wall has fallen below a limit.

    Parameters
    ----------
    before, now
        As for `category_changes`. A new part counts if it is below the limit.
    limit : float, mm

    Returns
    -------
    list of PartVerdict
        The new verdicts on these parts.

    Examples
    --------
    >>> [new["category"] for new in walls_newly_under(None, document_verdicts([record], profile), 10.0)]
    ['thin']
    """
    return [new for name, new in now.items()
            if _is_under(new, limit) and not _is_under((before or {}).get(name), limit)]


def _is_under(verdict, limit):
    # A wall designed with exactly this thickness must not count as below it due to the measuring error.
    return (verdict is not None and verdict["thickness"] is not None
            and verdict["thickness"] + verdict["error_bound"] < limit)
