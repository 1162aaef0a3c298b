# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a part is thinnest, in a sentence."""

from ..descriptors.wall_kinds import EDGE, TAPERED
from ..figures import Length, Share
from ..message import message

NOTED_EDGES = 0.01
"""Length of the sharp edges, in diagonals, from which on they are named where they are not the thinnest place."""


SMALL_ERROR = 0.001
"""Share of a length below which its error is not said: lengths are written with three digits."""

TOLD_FROM = 1e-4
"""Error, mm, from which on one is said."""

SLIVER = 0.02
"""Share of the usual wall below which the thinnest one is often an error of the model: surfaces that nearly touch."""


def thinnest_sentence(record):
    """The thinnest wall of a part record, whether it is tapered or ends in a sharp edge, and how many there are: Message.

    Parameters
    ----------
    record : PartRecord
    """
    walls, place = record["descriptors"]["thickness_mm"], record.get("thinnest")
    if walls["min"] is None:
        return message("No wall could be measured.")
    thinnest = with_error(walls["min"], walls["error_bound"])
    if place is None:
        return message("Thinnest parallel wall {thinnest}: classify the part again for its tapered walls.",
                       thinnest=thinnest)
    said = _said(record, place, thinnest)
    # Beside a sharp edge every wall is as thin as that.
    least = place["walls_mm"] if place["kind"] == EDGE else walls["min"]
    if least is None or not walls["median"] or least >= SLIVER * walls["median"]:
        return said
    return message("{said} So thin a place, {share} of the median of {median}, is often an error of the model: look at it.",
                   said=said, share=Share(least / walls["median"]), median=Length(walls["median"]))


def with_error(length, error):
    """A length, mm, and how far it may be off, where that is seen in three digits: Length or Message."""
    if error is None or error < max(SMALL_ERROR * length, TOLD_FROM):
        return Length(length)
    return message("{length} \u00b1 {error:.2g}", length=Length(length), error=Length(error))


def _said(record, place, thinnest):
    is_edge, wall = place["kind"] == EDGE, _wall(place, thinnest)
    if not is_edge and place["edges_mm"] <= NOTED_EDGES * record["descriptors"]["diagonal_mm"]:
        return message("{wall}.", wall=wall)
    said = message("{wall}; sharp edges are {edges} long.", wall=wall, edges=Length(place["edges_mm"]))
    if not is_edge or place["walls_mm"] is None:
        return said
    return message("{said} The thinnest wall that does not end in one is {walls}.", said=said,
                   walls=Length(place["walls_mm"]))


def thinnest_figure(record, key):
    """A value of where a part record is thinnest, such as ``places``; None where no wall was found, or it is not known.

    Parameters
    ----------
    record : PartRecord
    key : str
        Of its ``thinnest``.
    """
    place = record.get("thinnest")
    return None if place is None else place[key]


def thinnest_kind(record):
    """What is added to the thinnest wall in a table: "taper", "edge" or nothing."""
    place = record.get("thinnest")
    return "" if place is None else {TAPERED: "taper", EDGE: "edge"}.get(place["kind"], "")


def _wall(place, thinnest):
    below, count = Length(place["below_mm"]), place["places"]
    if place["kind"] == EDGE and count > 1:
        return message("Thinnest {thinnest}, {depth:.2g} beside a sharp edge; {count} places below {below:.2g}",
                       thinnest=thinnest, depth=Length(place["depth_mm"]), count=count, below=below)
    if place["kind"] == EDGE:
        return message("Thinnest {thinnest}, {depth:.2g} beside a sharp edge",
                       thinnest=thinnest, depth=Length(place["depth_mm"]))
    if place["kind"] == TAPERED and count > 1:
        return message("Thinnest wall {thinnest}, in a taper; {count} places below {below:.2g}",
                       thinnest=thinnest, count=count, below=below)
    if place["kind"] == TAPERED:
        return message("Thinnest wall {thinnest}, in a taper", thinnest=thinnest)
    if count > 1:
        return message("Thinnest wall {thinnest}; {count} places below {below:.2g}",
                       thinnest=thinnest, count=count, below=below)
    return message("Thinnest wall {thinnest}", thinnest=thinnest)
