"""Which faces of a part are shown as thin."""

MOSTLY = 0.5
"""Thin share of a face's area from which the face as a whole is shown as thin."""

LEAST = 0.0001
"""Share of the part's area that a thin place must have to be shown; less is a stray ray."""


def thin_face_colours(record, thin, partly):
    """Colours of the faces of a part that are thin.

    Parameters
    ----------
    record : dict
        Part record.
    thin, partly : tuple of float
        Colours of faces that are thin on at least half their area, and on less.

    Returns
    -------
    dict
        One of the two, by the number of the face, from 0.
    """
    least = LEAST * record["descriptors"]["area_mm2"]
    colours = {}
    for face in record["faces"]:
        if face["thin_share"] * face["area_mm2"] <= least:
            continue
        number = int(face["face"][len("Face"):]) - 1
        colours[number] = thin if face["thin_share"] >= MOSTLY else partly
    return colours
