# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verdict in a sentence with figures, as an engineer would say it."""

from ..categories import NORMAL
from ..descriptors.descriptor_table import quantity_named
from ..descriptors.quantity import MiddleShare, RidgeRatio
from ..figures import Length, Share
from ..message import message
from ..record.region_groups import region_groups
from ..record.verdict_chances import named_between
from .verdict_reasons import deciding_criteria
from .wall_words import features_of_a_solid, run_out_of, thin_features, walls_it_is_made_of

LEAST_SHARE = 0.001
"""Share below which less than that is said: rounded, it would be none."""


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
        return _of_ridges(record, rows)
    # The least bound is the one below which walls are shown as thin.
    quantity, condition, row = min(by_walls, key=lambda found: found[0].bounds[1])
    plates = {each["quantity"]: each["value"] for each in row["conditions"]}
    return _of_walls(record, quantity, condition, plates)


def _of_ridges(record, rows):
    """What is said of a part with thin ridges on a solid core: Message; None where no criterion asks for them."""
    width = record["descriptors"]["box_mm"][1]
    limit = next((condition["threshold"] * width for row in rows for condition in row["conditions"]
                  if isinstance(quantity_named(condition["quantity"]), RidgeRatio)), None)
    found = None if limit is None else thin_features(region_groups(record), limit, width, run_out_of(record))
    return None if found is None else _solid_but_for(record, found)


def _of_walls(record, quantity, condition, plates):
    width = record["descriptors"]["box_mm"][1]
    bound, middle = quantity.bounds[1], Length(width)
    share, limit, part = Share(condition["value"]), Length(bound * width), Share(bound)
    if condition["holds"]:
        said = _in_workshop_words(record, share, bound * width, _asks_for_plates(plates))
        if said is not None:
            return said
    if not condition["holds"]:
        return _of_solid(record, condition, quantity)
    if _asks_for_plates(plates):
        return message(
            "{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: consider "
            "shells (Prepare mesh says whether they can be made).",
            share=share, limit=limit, part=part, middle=middle)
    return message(
        "{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}: refine "
        "the mesh there.", share=share, limit=limit, part=part, middle=middle)


def _of_solid(record, condition, quantity):
    """What is said of a part that is not thin by a condition, and where the verdict is unsure, not surely solid: Message."""
    width = record["descriptors"]["box_mm"][1]
    found = features_of_a_solid(region_groups(record), quantity.bounds[1] * width, width, run_out_of(record))
    if found is not None:
        return _solid_but_for(record, found)
    if named_between(record):
        return message("Neither clearly solid nor clearly thin: {walls}.",
                       walls=_walls_near_a_limit(record) or _walls_of_solid(record, condition, quantity))
    return message("Solid: {walls}: mesh it with solids.", walls=_walls_of_solid(record, condition, quantity))


def _walls_near_a_limit(record):
    """The walls that a part has nearly enough of to be thin or thin-featured: Message; None where it has none of them."""
    near = [(abs(condition["margin"]), condition["value"], quantity) for row in record["evidence"]
            for condition in row["conditions"] if condition["holds"] is False
            for quantity in [quantity_named(condition["quantity"])] if isinstance(quantity, MiddleShare)]
    if not near:
        return None
    _, value, quantity = min(near, key=lambda found: found[0])
    if value < LEAST_SHARE:
        return None
    width, thinnest = record["descriptors"]["box_mm"][1], record["descriptors"]["thickness_mm"]["min"]
    bound = quantity.bounds[1]
    share, limit, part, middle = Share(value), Length(bound * width), Share(bound), Length(width)
    if thinnest is not None and thinnest >= bound * width:
        return message("beside edges, {share} of the surface is thinner than {limit}, {part} of the width of {middle}",
                       share=share, limit=limit, part=part, middle=middle)
    return message("{share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}",
                   share=share, limit=limit, part=part, middle=middle)


def _solid_but_for(record, found):
    if named_between(record):
        return message("Neither clearly solid nor clearly thin: {walls}.", walls=found.words)
    if found.are_teeth:
        return message("Solid but for {features}: mesh it with solids, and refine there or suppress that.",
                       features=found.words)
    return message("Solid but for {features}: mesh it with solids, and refine there.", features=found.words)


def _walls_of_solid(record, condition, quantity):
    width, share = record["descriptors"]["box_mm"][1], condition["value"]
    bound, middle = quantity.bounds[1], Length(width)
    limit, part, thinnest = Length(bound * width), Share(bound), record["descriptors"]["thickness_mm"]["min"]
    if "thinnest" in record and thinnest is not None and thinnest >= bound * width:
        return message("no wall is thinner than {thinnest}, {part} of the width of {middle}", thinnest=Length(thinnest),
                       part=Share(thinnest / width), middle=middle)
    if not share and not quantity.slanted:  # there may be tapered ones
        return message("only tapered walls are thinner than {limit}, {part} of the width of {middle}",
                       limit=limit, part=part, middle=middle)
    if not share:
        return message("no wall is thinner than {limit}, {part} of the width of {middle}",
                       limit=limit, part=part, middle=middle)
    if share < LEAST_SHARE:
        return message("less than {share} of the surface lies over walls thinner than {limit}, {part} of the width of "
                       "{middle}", share=Share(LEAST_SHARE), limit=limit, part=part, middle=middle)
    return message("only {share} of the surface lies over walls thinner than {limit}, {part} of the width of {middle}",
                   share=Share(share), limit=limit, part=part, middle=middle)


def _asks_for_plates(conditions):
    return "plate_ratio" in conditions or conditions.get("plate_share") is not None


def _in_workshop_words(record, share, limit, of_plates):
    """The same by the walls of the part, where they are known: Message or None."""
    groups = region_groups(record)
    if of_plates:
        made_of = walls_it_is_made_of(record, groups, limit)
        return None if made_of is None else message(
            "{walls}: consider shells (Prepare mesh says whether they can be made).", walls=made_of)
    found = thin_features(groups, limit, record["descriptors"]["box_mm"][1], run_out_of(record))
    if found is None:
        return None
    if found.has_core and found.are_teeth:
        return message("Solid core, {share} of the surface is thin: {features}. Refine the mesh there, or suppress them.",
                       share=share, features=found.words)
    if found.has_core:
        return message("Solid core, {share} of the surface is thin: {features}. Refine the mesh there.",
                       share=share, features=found.words)
    return message("{share} of the surface is thin: {features}. Refine the mesh there.",
                   share=share, features=found.words)
