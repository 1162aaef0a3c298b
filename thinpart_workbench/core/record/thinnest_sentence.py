# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a part is thinnest, in a sentence."""

from ..descriptors.wall_kinds import EDGE, TAPERED
from ..figures import Length
from ..message import message

NOTED_EDGES = 0.01
"""Length of the sharp edges, in diagonals, from which on they are named where they are not the thinnest place."""


def thinnest_sentence(record):
    """The thinnest wall of a part record, whether it is tapered or ends in a sharp edge, and how many there are: Message.

    Parameters
    ----------
    record : PartRecord
    """
    walls, place = record["descriptors"]["thickness_mm"], record.get("thinnest")
    if walls["min"] is None:
        return message("No wall could be measured.")
    thinnest, error = Length(walls["min"]), Length(walls["error_bound"])
    if place is None:
        return message("Thinnest parallel wall {thinnest} \u00b1 {error:.2g}: classify the part again for its tapered "
                       "walls.", thinnest=thinnest, error=error)
    depth, edges = Length(place["depth_mm"]), Length(place["edges_mm"])
    if place["kind"] == EDGE and place["walls_mm"] is None:
        return message("Thinnest {thinnest} \u00b1 {error:.2g}, {depth:.2g} beside a sharp edge; sharp edges are {edges} "
                       "long.", thinnest=thinnest, error=error, depth=depth, edges=edges)
    if place["kind"] == EDGE:
        return message("Thinnest {thinnest} \u00b1 {error:.2g}, {depth:.2g} beside a sharp edge; sharp edges are {edges} "
                       "long. Apart from them, the thinnest wall is {walls}.",
                       thinnest=thinnest, error=error, depth=depth, edges=edges, walls=Length(place["walls_mm"]))
    wall = _wall(place, thinnest, error)
    if place["edges_mm"] > NOTED_EDGES * record["descriptors"]["diagonal_mm"]:
        return message("{wall}; sharp edges are {edges} long.", wall=wall, edges=edges)
    return message("{wall}.", wall=wall)


def thinnest_kind(record):
    """What is added to the thinnest wall in a table: "taper", "edge" or nothing."""
    place = record.get("thinnest")
    return "" if place is None else {TAPERED: "taper", EDGE: "edge"}.get(place["kind"], "")


def _wall(place, thinnest, error):
    below, count = Length(place["below_mm"]), place["places"]
    if place["kind"] == TAPERED and count > 1:
        return message("Thinnest wall {thinnest} \u00b1 {error:.2g}, in a taper; {count} places below {below:.2g}",
                       thinnest=thinnest, error=error, count=count, below=below)
    if place["kind"] == TAPERED:
        return message("Thinnest wall {thinnest} \u00b1 {error:.2g}, in a taper", thinnest=thinnest, error=error)
    if count > 1:
        return message("Thinnest wall {thinnest} \u00b1 {error:.2g}; {count} places below {below:.2g}",
                       thinnest=thinnest, error=error, count=count, below=below)
    return message("Thinnest wall {thinnest} \u00b1 {error:.2g}", thinnest=thinnest, error=error)
