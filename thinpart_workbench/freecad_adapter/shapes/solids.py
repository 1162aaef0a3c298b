# SPDX-License-Identifier: LGPL-2.1-or-later
"""Get closed solids from the shape of an exchange file."""

from ...core.message import message

SEWING_TOLERANCES = (1e-6, 1e-5, 1e-4)
"""Gaps between loose faces that sewing closes, as shares of the diagonal; tried from tight to loose."""

_NO_AREA = 1e-12
"""Area of a face that is no more than a line, as a share of the squared diagonal of its solid."""


def solids_of(shape, whose=message("The file")):
    """Solids of a shape; loose faces are sewn together.

    Returns `solids` (list of Part.Shape; empty if the surfaces do not close) and `warnings` (tuple of str).

    IGES files hold faces without solids, which have to be sewn first, and so have those of STEP files of which OCC 7.9 takes
    one face for a solid and leaves the others as an open shell.

    Parameters
    ----------
    shape : Part.Shape
    whose : str, optional
        Owner of the shape, as the start of a sentence.
    """
    solids = [solid for solid in shape.Solids if has_surface(solid)]
    warnings = tuple(filter(None, (lines_warning(shape, whose), solids and loose_faces_warning(shape, whose))))
    if solids:
        return solids, warnings
    if shape.Solids:
        shape = _without_lines(shape)
    if not shape.Faces:
        return [], ()
    diagonal = shape.BoundBox.DiagonalLength
    for tolerance in SEWING_TOLERANCES:
        sewn = shape.copy()
        sewn.sewShape(tolerance * diagonal)
        solids = _closed_solids(sewn)
        if solids:
            return solids, (
                *warnings, message("It came as {faces} loose faces, which were sewn together.", faces=len(shape.Faces)),
            )
    return [], ()


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
    return message("{whose} holds {count} solids that are only a line, which were left out.", whose=whose, count=lines)


def _without_lines(shape):
    import Part

    lines = [face for solid in shape.Solids for face in solid.Faces]
    return Part.Compound([face for face in shape.Faces if not any(face.isSame(line) for line in lines)])


def _closed_solids(shape):
    import Part

    return [Part.Solid(shell) for shell in shape.Shells if shell.isClosed()]


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
