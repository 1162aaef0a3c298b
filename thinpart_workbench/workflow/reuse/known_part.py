# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether libraries already have a part that has just been measured."""

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

from .duplicates import of_outlines
from .evidence import OUTLINES, evidence, judged
from .formed_parts import formed_parts
from .like_parts import LikeParts


@dataclass(frozen=True)
class KnownPart:
    """The part of a library that is closest to another one.

    Attributes
    ----------
    stored : StoredPart
    kind : str
        One of `likeness.KINDS`.
    evidence : dict
        See docs/reuse.md.
    """

    stored: Any
    kind: str
    evidence: dict


def known_part(indexes, record, excluding=None):
    """The part of refreshed LibraryIndexes that is closest to a part record, by what records keep: KnownPart or None.

    Raises ThinPartError where the outline of the record is damaged.

    Parameters
    ----------
    indexes : list of LibraryIndex
    record : PartRecord
    excluding : str, optional
        Path of the info file of its own document.
    """
    if record.get("form") is None:
        return None
    parts = formed_parts(indexes, excluding).with_record(record)
    number = len(parts) - 1
    likeness = LikeParts(parts).of_part(number) if number else None
    if likeness is None:
        return None
    stored = parts.stored([likeness.reference]).get(likeness.reference)
    if stored is None:
        return None
    measured = record["descriptors"]
    d1, d2, d3 = measured["box_mm"]
    own = SimpleNamespace(d1_mm=d1, d2_mm=d2, d3_mm=d3, volume_mm3=measured["volume_mm3"], area_mm2=measured["area_mm2"],
                          faces=record["faces"], topology=record["form"]["topology"])
    answer = of_outlines(likeness.laid, parts.form(number), parts.form(likeness.reference))
    kind = judged(likeness, answer, OUTLINES, own, stored)
    return None if kind is None else KnownPart(stored, kind, evidence(kind, likeness, answer, OUTLINES, own, stored))
