# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict in a sentence with figures, as an engineer would say it."""

from ..categories import NORMAL
from ..descriptors.descriptor_table import quantity_named
from ..descriptors.quantity import MiddleShare
from ..figures import Length, Share
from ..message import message
from .verdict_reasons import deciding_criteria


def verdict_sentence(record):
    """What decided, in figures: Message or None.

    None where the profile asks for something that has no such sentence: who shows it has the titles of the criteria.

    Parameters
    ----------
    record : dict
        Part record, or a verdict without descriptors, which has no figures.
    """
    if "descriptors" not in record:
        return None
    rows = deciding_criteria(record)
    if not rows and record["category"] == NORMAL:
        rows = [row for row in record["evidence"] if row["holds"] is False]
    by_walls = [(quantity, condition, row) for row in rows for condition in row["conditions"]
                for quantity in [quantity_named(condition["quantity"])] if isinstance(quantity, MiddleShare)]
    if not by_walls:
        return None
    # The least bound is the one below which walls are shown as thin.
    quantity, condition, row = min(by_walls, key=lambda found: found[0].bounds[1])
    plates = {each["quantity"]: each["value"] for each in row["conditions"]}
    return _of_walls(record, quantity, condition, plates)


def _of_walls(record, quantity, condition, plates):
    width = record["descriptors"]["box_mm"][1]
    bound, middle = quantity.bounds[1], Length(width)
    share, limit, part = Share(condition["value"]), Length(bound * width), Share(bound)
    if not condition["value"] and not quantity.slanted:  # there may be tapered ones
        return message(
            "No parallel walls are thinner than {limit}, {part} of the middle side of {middle}: mesh it with solids.",
            limit=limit, part=part, middle=middle)
    if not condition["value"]:
        return message(
            "No walls are thinner than {limit}, {part} of the middle side of {middle}: mesh it with solids.",
            limit=limit, part=part, middle=middle)
    if not condition["holds"] and not quantity.slanted:
        return message(
            "Only {share} of the surface lies over parallel walls thinner than {limit}, {part} of the middle side of "
            "{middle}: mesh it with solids.", share=share, limit=limit, part=part, middle=middle)
    if not condition["holds"]:
        return message(
            "Only {share} of the surface lies over walls thinner than {limit}, {part} of the middle side of {middle}: "
            "mesh it with solids.", share=share, limit=limit, part=part, middle=middle)
    if "plate_ratio" in plates:
        return message(
            "{share} of the surface lies over walls thinner than {limit}, {part} of the middle side of {middle}: consider "
            "shells (Prepare mesh says whether they can be made).",
            share=share, limit=limit, part=part, middle=middle)
    if plates.get("plate_share") is not None:
        return message(
            "{share} of the surface lies over walls thinner than {limit}, {part} of the middle side of {middle}, and "
            "{plates} over walls that are plates: consider shells (Prepare mesh says whether they can be made).",
            share=share, limit=limit, part=part, middle=middle, plates=Share(plates["plate_share"]))
    return message(
        "{share} of the surface lies over walls thinner than {limit}, {part} of the middle side of {middle}: refine "
        "the mesh there.", share=share, limit=limit, part=part, middle=middle)
