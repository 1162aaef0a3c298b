"""Legend of the colours of thin faces."""

from ...freecad_adapter.preferences import preference
from ..application.qt import translate


def legend():
    """list of ``(colour, meaning)``, the most important first."""
    return [
        (preference("ThinColour"), translate("ThinPart", "thin on half of the face or more")),
        (preference("PartlyThinColour"), translate("ThinPart", "thin in places")),
    ]
