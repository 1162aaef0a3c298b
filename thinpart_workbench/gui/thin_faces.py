"""What the colours of thin faces mean."""

from ..freecad_adapter.settings import preference
from .qt import translate


def legend():
    """list of (colour, meaning), in the order of importance."""
    return [
        (preference("ThinColour"), translate("ThinPart", "thin on half of the face or more")),
        (preference("PartlyThinColour"), translate("ThinPart", "thin in places")),
    ]
