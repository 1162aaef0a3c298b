# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which facets of a thickness map are too thick for a process, as the check of the part's walls says it."""

import numpy as np

from ..judging.wall_check import check_walls
from ..record.face_names import face_number


def too_thick(part, limits):
    """Which facets are thicker than the greatest wall of a process: ndarray of shape (m,), bool.

    The largest balls inside tell it, as in the check: so rims and edges, along which rays run, are not among them, nor is
    anything where the check passes. Faces with a greatest wall of their own are compared with that. A map of before, which
    has no balls, is told by its rays.

    Parameters
    ----------
    part : MappedPart
        Its record with the ``face_limits`` that are known.
    limits : WallLimits
    """
    shown = part.map
    most, of_faces = check_walls(part.record, limits).thick_from
    allowed = np.full(shown.count, most)
    for name, own in of_faces.items():
        allowed[shown.face == face_number({"face": name})] = own
    with np.errstate(invalid="ignore"):
        return (shown.thickness if shown.balls is None else shown.balls) > allowed
