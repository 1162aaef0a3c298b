# SPDX-License-Identifier: LGPL-2.1-or-later
"""The CSV table of the faces of parts: a row per B-Rep face."""

from ..core.record.face_names import face_number
from .part_table import SUBJECT, TableForm

FACE_COLUMNS = (
    *SUBJECT, "face", "made_by", "area_mm2", "thinnest_mm", "median_mm", "thickest_mm",
    "thin_share", "unmeasured_share", "wall_mm", "x1", "y1", "z1", "x2", "y2", "z2", "opposite_face")
"""The columns from ``wall_mm`` on describe the thinnest wall under the face: its thickness, both of its end points
in mm, and the face on which the second one lies."""


def face_rows(file, record, features):
    """Rows of the faces of a part, list of tuple.

    Parameters
    ----------
    file : str
        Name of the file in the table.
    record : PartRecord
    features : list of str
        The feature that made each face, by face number; may be empty.
    """
    rows = []
    for face in record["faces"]:
        number = face_number(face)
        made_by = features[number] if number < len(features) else ""
        wall = face["witness"]
        ends = [None] * 8 if wall is None else [
            wall["distance"], *wall["points"][0], *wall["points"][1], wall["opposite_face"]]
        rows.append((
            file, record["name"], record["label"], face["face"], made_by, face["area_mm2"], face["min"],
            face["median"], face["max"], face["thin_share"], face["unmeasured_share"], *ends))
    return rows


FACES = TableForm(FACE_COLUMNS, tuple)
"""The table of `face_rows`."""

