# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of thin faces from the user's preferences."""

from ..core.record.thin_faces import thin_body_colours, thin_face_colours
from .preferences import preference


def preferred_colours(record, has_faces=True):
    """Colours of the thin faces of a part: dict, from the index of a face to red, green and blue from 0 to 1.

    Parameters
    ----------
    record : dict
        Part record.
    has_faces : bool, optional
        False for a mesh, which has one colour.
    """
    colours = thin_face_colours if has_faces else thin_body_colours
    return colours(record, preference("ThinColour"), preference("PartlyThinColour"))
