# SPDX-License-Identifier: LGPL-2.1-or-later
"""The distinct parts of a shape that is not in a document."""

from ...core.message import message
from ..occurrence import Occurrence
from ..shapes.equal_solids import equal_part
from ..shapes.part import SolidPart
from ..shapes.solids import solids_of


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
