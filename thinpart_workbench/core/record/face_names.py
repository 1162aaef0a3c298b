# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of faces, without numpy: FreeCAD starts with what says a verdict in words."""


def face_name(number):
    """FreeCAD's name of a face with a number counted from 0."""
    return f"Face{number + 1}"


def face_number(entry):
    """Number, from 0, of the face of an entry of a record's ``faces``. Faces without triangles have no entry."""
    return int(entry["face"][len("Face"):]) - 1
