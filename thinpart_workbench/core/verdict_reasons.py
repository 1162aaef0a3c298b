"""What decided on the category of a part, and which other one is near, by the evidence in its record."""

from .categories import NORMAL


def deciding_criteria(record):
    """Rows of the evidence of a part record whose criteria hold and gave it its category."""
    return [row for row in record["evidence"] if row["holds"] and row["category"] == record["category"]]


def nearest_other(record):
    """The category that the part would get if the quantity nearest its threshold passed it."""
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
