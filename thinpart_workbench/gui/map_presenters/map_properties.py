# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a map that its panel shows, in groups, and how the user changes them."""

from ..application.qt import translate
from ..document.transaction import transaction

SCALE = ("AutomaticRange", "Low", "High", "RangeUnit", "ColourMap", "Reversed", "Bands", "UnmeasuredColour", "Logarithmic",
         "Shaded")
THIN = ("Threshold", "ThinOnly", "Check", "CheckMost")
PROBES = ("ProbePoints", "ProbeOpposites", "ProbeValues")


def change(thickness, values):
    """Set properties of a map in one step of undo: dict of values by name."""
    with transaction(thickness.Document, translate("ThinPart", "Thickness colours")):
        for name, value in values.items():
            setattr(thickness, name, value)
