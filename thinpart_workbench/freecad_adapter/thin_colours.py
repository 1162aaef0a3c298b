"""The colours of thin faces, as the user of this FreeCAD prefers them."""

from ..core.thin_faces import thin_face_colours
from .settings import preference


def preferred_colours(record):
    """Colours of the faces of a part that are thin.

    Parameters
    ----------
    record : dict
        Part record.

    Returns
    -------
    dict
        Red, green and blue from 0 to 1, by the number of the face, from 0.
    """
    return thin_face_colours(record, preference("ThinColour"), preference("PartlyThinColour"))
