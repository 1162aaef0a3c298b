# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall that people set for single faces, found again after the part was measured anew."""

SAME_AREA = 0.01
"""Share by which the area of a face may differ between measurements."""


_MEASURED = ("face", "area_mm2", "surface", "min", "ball_mm")
_LIMIT = ("face", "area_mm2", "surface", "min_mm", "max_mm", "reason")


def limited_part(record):
    """What a check needs of a part record whose faces have limits of their own: dict of plain values, None for any other.

    It has ``faces`` and ``face_limits``, as the record, with fewer keys.
    """
    if not record.get("face_limits"):
        return None
    faces = [{**_only(_MEASURED, face), "witness": face["witness"] and _only(("opposite_face",), face["witness"])}
             for face in record.get("faces", ())]
    return {"face_limits": [_only(_LIMIT, limit) for limit in record["face_limits"]], "faces": faces}


def _only(keys, content):
    return {key: content[key] for key in keys if key in content}


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
