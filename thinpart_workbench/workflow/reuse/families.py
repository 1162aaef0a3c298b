# SPDX-License-Identifier: LGPL-2.1-or-later
"""Families: parts whose faces are of the same kinds and lie beside each other in the same way, and what varies in them."""

from dataclasses import dataclass

import numpy as np

from ...core.errors import ThinPartError
from ...storage.index.stored_part import SELECT, stored_part
from ...storage.info.stored_records import stored_records

SAME_VALUE = 1e-4
"""Share by which a dimension differs at most that two parts have in common."""

MOST_COLUMNS = 12
"""Dimensions in the table of a family: those that vary most."""

LEAST_FACES = 4
"""Faces of the parts of a family: balls and cylinders of any size are none."""

_DIMENSIONS = ("d1_mm", "d2_mm", "d3_mm", "thinnest_mm")


@dataclass(frozen=True)
class Family:
    """Parts that differ in some dimensions.

    Attributes
    ----------
    parts : list of StoredPart
        The smallest first.
    varies : dict of list of float
        By dimension: its values, in the order of the parts.
    """

    parts: list
    varies: dict


def find_families(indexes):
    """The families among the parts of refreshed LibraryIndexes, the largest first: list of Family.

    A family depends on its own parts only: others that are added to a library leave it as it is.
    """
    found: dict = {}
    for index in indexes:
        for row in index.query(f"{SELECT} WHERE topology IS NOT NULL ORDER BY files.path, parts.id"):
            part = stored_part(index.root, row)
            found.setdefault(part.topology, {})[part.info_file, part.name] = part
    several = [sorted(parts.values(), key=lambda part: part.diagonal_mm) for parts in found.values() if len(parts) > 1]
    families = [family for family in map(_family, several) if family is not None]
    return sorted(families, key=lambda family: -len(family.parts))


def _family(parts):
    rows = [(part, radii) for part in parts for radii in [_radii(part)] if radii is not None]
    if len({len(radii) for _, radii in rows}) != 1:
        return None
    values = {name: [getattr(part, name) for part, _ in rows] for name in _DIMENSIONS}
    of_radii = zip(*(radii for _, radii in rows))
    values.update((f"radius_{number}_mm", list(column)) for number, column in enumerate(of_radii, 1))
    varies: dict = {}
    seen = set()
    for name, column in values.items():
        key = tuple(None if value is None else round(value, 6) for value in column)
        if None not in key and key not in seen and np.ptp(column) > SAME_VALUE * max(column):
            seen.add(key)
            varies[name] = column
    if len(rows) < 2 or not varies:  # one part, several times
        return None
    widest = sorted(varies, key=lambda name: -np.ptp(varies[name]) / max(varies[name]))[:MOST_COLUMNS]
    return Family([part for part, _ in rows], {name: column for name, column in varies.items() if name in widest})


def _radii(part):
    """The radii of the round faces of a part, mm, ascending; None where its record cannot be read, or it has few faces."""
    try:
        record = next((each for each in stored_records(part.info_file) if each["name"] == part.name), None)
    except ThinPartError:
        return None
    if record is None or len(record["faces"]) < LEAST_FACES:
        return None
    return sorted(face["radius_mm"] for face in record["faces"] if face.get("radius_mm") is not None)
