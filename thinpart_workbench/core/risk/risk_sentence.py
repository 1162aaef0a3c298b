# SPDX-License-Identifier: LGPL-2.1-or-later
"""The risk of the automatic mesh in words, with the figures that raise it."""

from ..descriptors.automatic_mesh import AUTOMATIC_SHARE, FLATTENED, SHORT
from ..descriptors.descriptor_table import quantity_named
from ..figures import Length, Share
from ..message import message

MOST_REASONS = 3
"""Reasons that a sentence has."""


def risk_sentence(record):
    """The risk, and what raises it, or why it is unknown: Message.

    Parameters
    ----------
    record : PartRecord
    """
    found, hazards = record.get("mesh_risk"), record["descriptors"].get("hazards")
    if found is None or found["risk"] is None:
        if hazards is None:
            return message("Risk of the automatic mesh: unknown, an earlier version measured the part. "
                           "Measure it again (classify --force).")
        if hazards["faces"] is None:
            return message("Risk of the automatic mesh: unknown, triangles have no edges and faces.")
        return message("Risk of the automatic mesh: unknown, not all that it depends on could be measured.")
    reasons = [reason_text(reason, record["descriptors"]) for reason in found["reasons"][:MOST_REASONS]]
    if not reasons:
        return message("Risk of the automatic mesh: {risk}.", risk=Share(found["risk"]))
    text = reasons[0]
    for reason in reasons[1:]:
        text = message("{first}; {next}", first=text, next=reason)
    return message("Risk of the automatic mesh: {risk}: {reasons}.", risk=Share(found["risk"]), reasons=text)


def reason_text(reason, measured):
    """A reason, with its figures: Message.

    Parameters
    ----------
    reason : RiskReason
    measured : DescriptorsRecord
    """
    quantity = quantity_named(reason["quantity"])
    words = _WORDS.get(quantity.name)
    if words is None:
        return message("{quantity} = {value:.3g}", quantity=quantity.symbol, value=reason["value"])
    return words(quantity, reason["value"], measured, AUTOMATIC_SHARE * measured["diagonal_mm"])


def _thin_walls(quantity, value, measured, element):
    return message("walls thinner than {limit} over {share} of the surface",
                   limit=Length(quantity.bounds[1] * measured["diagonal_mm"]), share=Share(value))


def _thin(quantity, value, measured, element):
    limit = value * measured["diagonal_mm"]
    return message("a twentieth of the surface is thinner than {limit}, 1/{part:.1f} of an element", limit=Length(limit),
                   part=element / limit)


def _short_edges(quantity, value, measured, element):
    shortest = measured["hazards"]["shortest_edge_mm"]
    part = element / shortest
    if value == 1:
        return message("an edge of {shortest}, 1/{part:.0f} of an element", shortest=Length(shortest), part=part)
    return message("{count:.0f} edges shorter than {limit}, the shortest {shortest}, 1/{part:.0f} of an element",
                   count=value, limit=Length(SHORT * element), shortest=Length(shortest), part=part)


def _flattened(quantity, value, measured, element):
    return message("curved walls that elements change by over {part} of their thickness on {share} of the surface",
                   part=Share(FLATTENED), share=Share(value))


_WORDS = {"F": _thin_walls, "thin_x": _thin, "short_edges": _short_edges, "flattened_share": _flattened}
"""By name of a quantity: functions of it, its value, ``descriptors`` of the part, and the size of an element, mm."""
