"""The parts of a document and what is known of each."""

from dataclasses import dataclass
from typing import Optional

from .length_unit import MILLIMETRE
from .qt import Signal, translate
from .row_table import RowColumn, RowTable
from .sentences import translated
from .verdict_text import category_colour, category_word

_LINES = 6


@dataclass(frozen=True)
class PartRow:
    """A part.

    Attributes
    ----------
    name, label : str
    instances : int
    record : dict or None
        None until it is measured.
    failure : str
        Why it could not be.
    """

    name: str
    label: str
    instances: int
    record: Optional[dict] = None
    failure: str = ""


class PartList(RowTable):
    """Label, category, thinnest wall and number of places of every part; hidden where there is only one.

    Signals
    -------
    part_chosen(str)
        Name of the part that was clicked.
    """

    part_chosen = Signal(str)

    def __init__(self, parent=None):
        self._profile, self._unit = None, MILLIMETRE
        super().__init__("ThinPart_PartTable", self._columns(), _LINES, parent)
        self.row_chosen.connect(lambda row: self.part_chosen.emit(row.name))
        self.hide()

    def show_parts(self, rows, profile, unit):
        """Show parts.

        Parameters
        ----------
        rows : list of PartRow
        profile : Profile
            By which they are judged.
        unit : LengthUnit
        """
        self._profile, self._unit = profile, unit
        self.set_columns(self._columns())
        self.update_rows(rows, lambda one, other: one.name == other.name)
        self.setVisible(len(rows) > 1)

    def select_part(self, name):
        """Select a part without a signal; none where the name is None."""
        self.select(None if name is None else lambda row: row.name == name)

    def mousePressEvent(self, event):
        """A click beside the rows chooses none of them, on the chosen one it says so again."""
        before = self.current_row
        super().mousePressEvent(event)
        row = self.current_row
        if row is not None and row is before:
            self.row_chosen.emit(row)

    def _columns(self):
        return [
            RowColumn(translate("ThinPart", "Part"), lambda row: row.label, lambda row: row.label.casefold(),
                      takes_rest=True),
            RowColumn(translate("ThinPart", "Category"), self._category, self._category, swatch=_swatch),
            RowColumn(translate("ThinPart", "Thinnest, {}").format(self._unit.symbol), self._thinnest_text,
                      _thinnest, is_number=True, meaning=translate("ThinPart", "Thinnest wall")),
            RowColumn(translate("ThinPart", "\u00d7"), lambda row: str(row.instances),
                      lambda row: row.instances, is_number=True,
                      meaning=translate("ThinPart", "How often the part stands in the document")),
        ]

    def _category(self, row):
        if row.record is not None:
            return category_word(row.record["category"], self._profile)
        if row.failure:
            return translate("ThinPart", "failed: {}").format(translated(row.failure))
        return "\u2026"

    def _thinnest_text(self, row):
        thinnest = _thinnest(row)
        return "" if thinnest is None else self._unit.number(thinnest)


def part_rows(analysis):
    """The parts of a `DocumentAnalysis` as rows, list of PartRow."""
    rows = []
    for part in analysis.parts:
        failure = analysis.failures.get(part.name)
        rows.append(PartRow(part.name, part.label, part.instances, analysis.records.get(part.name),
                            failure["message"] if failure else ""))
    return rows


def _swatch(row):
    return None if row.record is None else category_colour(row.record["category"])


def _thinnest(row):
    return None if row.record is None else row.record["descriptors"]["thickness_mm"]["min"]

