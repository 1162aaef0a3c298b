# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which criteria decided the category of a part, and which category is next, from the evidence in its record."""

from ..categories import NORMAL
from ..message import Message
from .classification import too_fine_reason, unmeasured_reason


def deciding_criteria(record):
    """Evidence rows of a part record whose criteria hold and gave the part its category."""
    return [row for row in record["evidence"] if row["holds"] and row["category"] == record["category"]]


def nearest_other(record):
    """The category that the part would get if the quantity nearest to its threshold crossed it."""
    rows, own = record["evidence"], record["category"]
    deciding = [row["margin"] for row in deciding_criteria(record)]
    before = rows
    if deciding:
        first = next(index for index, row in enumerate(rows) if row["category"] == own)
        before = rows[:first]
    nearly = [row for row in before if row["holds"] is False and row["margin"] is not None]
    nearest = max(nearly, key=lambda row: row["margin"], default=None)
    if nearest is not None and (not deciding or -nearest["margin"] <= max(deciding)):
        return nearest["category"]
    later = rows[len(before):]
    return next((row["category"] for row in later if row["holds"] and row["category"] != own),
                NORMAL)


def reason_of(record):
    """Why a part is ``unknown``, as a `Message`; a reason stored as plain text is rebuilt from the evidence.

    Returns a str: ``reason`` of the record; a Message unless another version wrote it with other words.

    Parameters
    ----------
    record : dict
        Part record, or a verdict without descriptors, whose reason is returned unchanged.
    """
    stored = record["reason"]
    if not stored or isinstance(stored, Message) or "descriptors" not in record:
        return stored
    from ..record.part_record import descriptors_of  # imports numpy, which is needed for stored records only

    category = next((row["category"] for row in record["evidence"] if row["holds"] is None), None)
    undecided = [row for row in record["evidence"] if row["holds"] is None and row["category"] == category]
    quantities = dict.fromkeys(
        condition["quantity"] for row in undecided for condition in row["conditions"] if condition["holds"] is None)
    reasons = (unmeasured_reason(quantities, [row["criterion"] for row in undecided]),
               too_fine_reason(descriptors_of(record).length_error))
    return next((reason for reason in reasons if reason == stored), stored)
