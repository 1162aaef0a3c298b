"""Which faces of a part are coloured, and how."""

from ..freecad_adapter.settings import preference
from .qt import translate

MOSTLY = 0.5
"""Thin share of a face's area from which the face as a whole is shown as thin."""

LEAST = 0.0001
"""Share of the part's area that a thin place must have to be shown; less is a stray ray."""


def thin_face_colours(record):
    """Colours of the faces of a part that are thin.

    Parameters
    ----------
    record : dict
        Part record.

    Returns
    -------
    dict
        Red, green and blue from 0 to 1, by the number of the face, from 0.
    """
    thin, partly = preference("ThinColour"), preference("PartlyThinColour")
    least = LEAST * record["descriptors"]["area_mm2"]
    colours = {}
    for face in record["faces"]:
        if face["thin_share"] * face["area_mm2"] <= least:
            continue
        number = int(face["face"][len("Face"):]) - 1
        colours[number] = thin if face["thin_share"] >= MOSTLY else partly
    return colours


def legend():
    """list of (colour, meaning), in the order of importance."""
    return [
        (preference("ThinColour"), translate("ThinPart", "thin on half of the face or more")),
        (preference("PartlyThinColour"), translate("ThinPart", "thin in places")),
    ]
