"""The unit in which the window writes and takes lengths: that of FreeCAD's unit system.

Records, info files, tables, and the properties of documents hold millimetres. The window alone converts, where it
shows a length and where it takes one.
"""

import re
from dataclasses import dataclass

import FreeCAD as App

from ..core.number_text import bound_text, number

PREFERENCES = "User parameter:BaseApp/Preferences/Units"

_OF_A_SENTENCE = re.compile(r"(?<![\w.])(\d+(?:\.\d+)?(?:e[+-]?\d+)?)[ \u00a0]mm\b")


@dataclass(frozen=True)
class LengthUnit:
    """A unit of length.

    Attributes
    ----------
    symbol : str
        The same in every language.
    millimetres : float
        What 1 of it is.
    decimals : int
        Of fields for lengths: the last is at most a few micrometres.
    """

    symbol: str
    millimetres: float
    decimals: int

    def value(self, millimetres):
        """A length in this unit: float, None for None."""
        return None if millimetres is None else millimetres / self.millimetres

    def number(self, millimetres):
        """A length in this unit without its symbol, with three significant digits; a dash for None."""
        return number(self.value(millimetres))

    def text(self, millimetres):
        """A length in this unit with its symbol."""
        return self.with_symbol(self.number(millimetres))

    def bound_text(self, millimetres):
        """An error bound with its symbol; see `number_text.bound_text`."""
        return self.with_symbol(bound_text(self.value(millimetres)))

    def with_symbol(self, text):
        """A number, or several, with the symbol."""
        return f"{text}\u00a0{self.symbol}"

    def of_sentence(self, sentence):
        """A sentence of the layers below, its millimetres in this unit."""
        if self == MILLIMETRE:
            return sentence
        return _OF_A_SENTENCE.sub(lambda found: self.text(float(found.group(1))), sentence)


MILLIMETRE = LengthUnit("mm", 1.0, 3)
INCH = LengthUnit("in", 25.4, 4)


def length_unit(document=None):
    """The unit of lengths in the window.

    Parameters
    ----------
    document : FreeCAD.Document, optional
        What the lengths are of; the active document where it is left out.

    Returns
    -------
    LengthUnit
        Inches where FreeCAD writes lengths in inches or feet, fractions included. Otherwise millimetres, also where
        FreeCAD writes small lengths in centimetres or metres: nobody tells the thickness of a wall so.
    """
    _, millimetres, _ = App.Units.schemaTranslate(App.Units.Quantity("10 mm"), _schema(document or App.ActiveDocument))
    inches = millimetres / INCH.millimetres
    return INCH if round(inches) >= 1 and abs(inches - round(inches)) < 1e-6 else MILLIMETRE


def _schema(document):
    """Number of the unit system of a document, or of what FreeCAD itself writes in where documents have none."""
    if "UnitSystem" not in getattr(document, "PropertiesList", ()) or App.ParamGet(PREFERENCES).GetBool(
            "IgnoreProjectSchema", False):
        return App.Units.getSchema()
    return document.getEnumerationsOfProperty("UnitSystem").index(document.UnitSystem)
