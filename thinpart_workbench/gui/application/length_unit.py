# SPDX-License-Identifier: LGPL-2.1-or-later
"""The unit in which the GUI shows and reads lengths: that of FreeCAD's unit system.

Records, info files, tables, and the properties of documents hold millimetres. Only the GUI converts, where it
shows a length and where it reads one.
"""

from dataclasses import replace

import FreeCAD as App

from ...core.length_unit import INCH, MILLIMETRE, LengthUnit
from .numbers import decimal_mark

__all__ = ["INCH", "MILLIMETRE", "PREFERENCES", "LengthUnit", "length_unit"]

PREFERENCES = "User parameter:BaseApp/Preferences/Units"


def length_unit(document=None):
    """The LengthUnit of the GUI for a document, by default the active one.

    Inches where FreeCAD writes lengths in inches or feet, fractions included. Otherwise millimetres, even where FreeCAD
    writes small lengths in centimetres or metres: nobody gives a wall thickness in those.
    """
    _, millimetres, _ = App.Units.schemaTranslate(App.Units.Quantity("10 mm"), _schema(document or App.ActiveDocument))
    inches = millimetres / INCH.millimetres
    unit = INCH if round(inches) >= 1 and abs(inches - round(inches)) < 1e-6 else MILLIMETRE
    return replace(unit, decimal_mark=decimal_mark())


def _schema(document):
    """Index of a document's unit system, or of FreeCAD's own where documents have none."""
    if "UnitSystem" not in getattr(document, "PropertiesList", ()) or App.ParamGet(PREFERENCES).GetBool(
            "IgnoreProjectSchema", False):
        return App.Units.getSchema()
    return document.getEnumerationsOfProperty("UnitSystem").index(document.UnitSystem)
