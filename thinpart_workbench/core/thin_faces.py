"""Which faces of a part are shown as thin."""

from .part_record import face_number

MOSTLY = 0.5
"""Thin share of a face's area from which the face as a whole is shown as thin."""

LEAST = 0.0001
"""Share of the part's area that a thin place must have to be shown; less is a stray ray."""


def limit_in_millimetres(limit, diagonal):
    """A limit that a user gave, for a part with this diagonal.

    Parameters
    ----------
    limit : dict
        ``millimetres``, or ``share`` of the diagonal.
    diagonal : float, mm

    Returns
    -------
    float
        At most the diagonal: no wall is thicker.
    """
    return min(limit.get("millimetres", limit.get("share", 0.0) * diagonal), diagonal)


def with_limit(record, limit, thin_shares):
    """A part record for showing, with another limit for what is thin than the verdict's.

    Parameters
    ----------
    record : dict
        Part record; stays as it is, and so does the verdict.
    limit : float, mm
    thin_shares : list of float
        Of its faces, in their order.
    """
    faces = [{**face, "thin_share": share} for face, share in zip(record["faces"], thin_shares)]
    return {**record, "thin_limit_mm": limit, "faces": faces}


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
        number = face_number(face)
        colours[number] = thin if face["thin_share"] >= MOSTLY else partly
    return colours
