# SPDX-License-Identifier: LGPL-2.1-or-later
"""Why one of several parts that are the same is the one to keep."""

from ...core.message import message
from .formed_parts import standing


def why_kept(parts):
    """What the first of some StoredParts has more of than the others, by what `FormedParts` put it first: Message."""
    standings = [_standing(part) for part in parts]
    for number, own in enumerate(standings[0]):
        others = max(each[number] for each in standings[1:])
        if own > others:
            return _REASONS[number](parts[0])
    return message("the first of equals")


_REASONS = (
    lambda part: message("geometry, not triangles"),
    lambda part: message("used {count} times", count=part.instances or 1),
    lambda part: message("has notes"),
    lambda part: message("can be edited in FreeCAD"),
    lambda part: message("has a name of its own"),
    lambda part: message("the latest"),
)


def _standing(part):
    return standing(part.file, part.instances, part.notes or part.mesh or part.link, part.label or part.name, part.modified)
