# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which faces of a part are shown as thin."""

from ..number_text import rounded_up
from .face_names import face_number

MOSTLY_THIN_SHARE = 0.5
"""Thin share of a face's area from which on the face is shown as thin, not as thin in part."""

FAR_THINNER, OVER_MOST = 3.0, 1.25
"""How many times as thick as the median wall the limit of a verdict is from which on it says nothing of the walls; and what
is shown instead, in median walls."""

LEAST_AREA_SHARE, LEAST_FACE_SHARE = 0.0001, 0.02
"""Shares of the part's area and of the face's own that thin area on a face must exceed to be shown; less is a stray ray, or
the end of a wire that is ground flat."""


def limit_in_millimetres(limit, diagonal):
    """Convert a limit that a user gave to mm, for a part with a given diagonal: float.

    At most the diagonal: no wall is thicker.

    Parameters
    ----------
    limit : dict
        ``millimetres``, or ``share`` of the diagonal.
    diagonal : float, mm
    """
    return min(limit.get("millimetres", limit.get("share", 0.0) * diagonal), diagonal)


def shown_limit_mm(record):
    """The thickness, mm, under which walls of a part are shown as thin at first: float or None.

    That of the verdict; where nearly all walls are far thinner, as those of a sheet of 2 mm which is 200 mm wide, a round
    length over most of them.

    Parameters
    ----------
    record : PartRecord
    """
    limit, median = record.get("thin_limit_mm"), record["descriptors"].get("thickness_mm", {}).get("median")
    if not limit or not median or median * FAR_THINNER > limit:
        return limit
    return rounded_up(OVER_MOST * median)


def with_limit(record, limit, thin_shares):
    """Make a part record for display, with another thin limit than that of the verdict.

    Parameters
    ----------
    record : PartRecord
        Not modified; the verdict stays the same, too.
    limit : float, mm
    thin_shares : list of float
        Thin share of each face, in the order of the record.
    """
    faces = [{**face, "thin_share": share} for face, share in zip(record["faces"], thin_shares)]
    return {**record, "thin_limit_mm": limit, "faces": faces}


def thin_face_colours(record, thin, partly):
    """Choose the colours of the thin faces of a part: dict, one of the two colours by face number, from 0.

    Equal faces have one colour, by the area of all of them: of equal holes, some look at an edge.

    Parameters
    ----------
    record : PartRecord
    thin, partly : tuple of float
        Colours of faces that are thin on at least half of their area, and on less than half.
    """
    least = LEAST_AREA_SHARE * record["descriptors"]["area_mm2"]
    colours = {}
    for equal in _equal_faces(record):
        area = sum(face["area_mm2"] for face in equal)
        thin_area = sum(face["thin_share"] * face["area_mm2"] for face in equal)
        if thin_area <= max(least, LEAST_FACE_SHARE * area):
            continue
        for face in equal:
            colours[face_number(face)] = thin if thin_area >= MOSTLY_THIN_SHARE * area else partly
    return colours


def _equal_faces(record):
    """The faces of a record, equal ones together: list of list. In records of earlier versions each is alone."""
    groups: dict = {}
    for face in record["faces"]:
        groups.setdefault(face.get("equal_to") or face["face"], []).append(face)
    return list(groups.values())


def thin_body_colours(record, thin, partly):
    """Like `thin_face_colours`, for a body that can have one colour only, such as a mesh: as its area is on the whole."""
    colours = thin_face_colours(record, thin, partly)
    if not colours:
        return {}
    area = sum(face["area_mm2"] for face in record["faces"])
    share = sum(face["thin_share"] * face["area_mm2"] for face in record["faces"]) / area
    return {0: thin if share >= MOSTLY_THIN_SHARE else partly}
