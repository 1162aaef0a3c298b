# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distinct parts of a shape that is not in a document."""

from ...core.message import message
from ..occurrence import Occurrence
from ..shapes.equal_solids import equal_part
from ..shapes.part import SolidPart
from ..shapes.solids import has_surface, lines_warning, loose_faces_warning, without_lines
from .sewn_solids import sewn_solids


def shape_parts(shape, label, whose=message("The file")):
    """Distinct solids of a shape: list of SolidPart, empty if its surfaces do not close.

    Parameters
    ----------
    shape : Part.Shape
    label : str
        Label of the part; several parts are numbered.
    whose : str, optional
        Owner of the shape, as the start of a sentence.
    """
    solids, warnings = solids_of(shape, whose)
    parts = []
    for index, solid in enumerate(solids):
        known = equal_part(parts, solid)
        if known is None:
            number = len(parts) + 1
            own = label if len(solids) == 1 else f"{label} ({number})"
            known = SolidPart(f"Solid{number}", own, warnings=warnings, shape=solid)
            parts.append(known)
        known.occurrences.append(Occurrence("", "", index))
    return parts


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
    import Part

    solids = [solid for solid in shape.Solids if has_surface(solid)]
    warnings = tuple(filter(None, (lines_warning(shape, whose), solids and loose_faces_warning(shape, whose))))
    if solids:
        return solids, warnings
    if shape.Solids:
        shape = without_lines(shape)
    if not shape.Faces:
        return [], ()
    solids, left = sewn_solids(shape)
    if not solids:
        return [], ()
    return solids, tuple(filter(None, (
        *warnings, message("It came as {faces} loose faces, which were sewn together.", faces=len(shape.Faces)),
        left and loose_faces_warning(Part.Compound([*solids, *left]), whose))))
