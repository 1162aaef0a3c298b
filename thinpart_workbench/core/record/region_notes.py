# SPDX-License-Identifier: LGPL-2.1-or-later
"""What people say of wall regions, found again after the part was measured anew."""

import math

SHARED_FACES = 0.5
"""Share of the faces of a note and of a region together that both need to have."""

NEARBY = 0.5
"""Share of the length of a region within which its place may move between measurements; at least its thickness."""


def notes_of_regions(regions, notes):
    """Find the note of each region: list of dict or None.

    For each region. Each note belongs to one region at most: to the nearest of those with about the same faces.

    Parameters
    ----------
    regions : list of dict
        As ``listed`` in a part record.
    notes : list of dict
        As ``region_notes`` of a part record.
    """
    pairs = sorted((math.dist(region["place"], note["place"]), at, number)
                   for at, region in enumerate(regions) for number, note in enumerate(notes) if _fits(region, note))
    found, taken = [None] * len(regions), set()
    for _, at, number in pairs:
        if found[at] is None and number not in taken:
            found[at] = notes[number]
            taken.add(number)
    return found


def _fits(region, note):
    own, noted = set(region["faces"]), set(note["faces"])
    if len(own & noted) < SHARED_FACES * len(own | noted):
        return False
    reach = max(NEARBY * region["length_mm"], region["median"])
    return math.dist(region["place"], note["place"]) <= reach
