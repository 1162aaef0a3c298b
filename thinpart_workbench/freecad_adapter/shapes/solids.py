# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a shape is a solid, and what is not."""

from ...core.message import message

_NO_AREA = 1e-12
"""Area of a face that is no more than a line, as a share of the squared diagonal of its solid."""


def has_surface(solid):
    """Whether a solid is more than a line; OCC makes lines of tori and spheres whose border is the same circle twice."""
    least = _NO_AREA * solid.BoundBox.DiagonalLength ** 2
    return any(face.Area > least for face in solid.Faces)


def lines_warning(shape, whose):
    """A warning about solids of a shape that have no surface; None if there are none.

    Parameters
    ----------
    shape : Part.Shape
    whose : str
        Owner of the shape, as the start of the sentence.
    """
    lines = sum(not has_surface(solid) for solid in shape.Solids)
    if not lines:
        return None
    if lines == 1:
        return message("{whose} holds 1 solid that is only a line, which was left out.", whose=whose)
    return message("{whose} holds {count} solids that are only a line, which were left out.", whose=whose, count=lines)


def without_lines(shape):
    """The faces of a shape that belong to no solid without surface: Part.Compound."""
    import Part

    lines = [face for solid in shape.Solids for face in solid.Faces]
    return Part.Compound([face for face in shape.Faces if not any(face.isSame(line) for line in lines)])


def loose_faces_warning(shape, whose):
    """A warning about faces that belong to no solid of a shape; None if there are none.

    Parameters
    ----------
    shape : Part.Shape
        With solids.
    whose : str
        Owner of the shape, as the start of the sentence.
    """
    import Part

    # Neighbouring solids may share a face, so adding up their numbers of faces would count it twice.
    loose = len(shape.Faces) - len(Part.Compound(shape.Solids).Faces)
    if loose <= 0:
        return None
    if loose == 1:
        return message("{whose} holds 1 face beside its solids, which was left out: close or thicken it if it is a "
                       "part.", whose=whose)
    return message("{whose} holds {faces} faces beside its solids, which were left out: close or thicken them if "
                   "they are a part.", whose=whose, faces=loose)
