# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall that people set for single faces, found again after the part was measured anew."""

SAME_AREA = 0.01
"""Share by which the area of a face may differ between measurements."""


def limited_faces(record):
    """The limits for single faces of a part record, each with the face that it is for: list of (dict, FaceRecord or None).

    A limit belongs to the face of its name, if that has the area that it had and lies on the same kind of surface; else, as
    after a change of the model that numbers faces anew, to the only face of which the same holds. None where there is no
    such face, or more than one.

    Parameters
    ----------
    record : PartRecord
        With ``face_limits``; may lack its faces.
    """
    faces = record.get("faces", ())
    found = []
    for limit in record.get("face_limits", ()):
        fitting = [face for face in faces if _fits(limit, face)]
        named = [face for face in fitting if face["face"] == limit["face"]]
        face = named[0] if named else fitting[0] if len(fitting) == 1 else None
        found.append((limit, face))
    return found


def _fits(limit, face):
    return (abs(limit["area_mm2"] - face["area_mm2"]) <= SAME_AREA * limit["area_mm2"]
            and limit.get("surface") == face.get("surface"))
