"""Table of a document's parts with their results."""

from dataclasses import dataclass
from typing import Optional

from ...core.length_unit import MILLIMETRE
from ..application.qt import Signal, translate
from ..application.sentences import translated
from ..widgets.record_table_view import RecordColumn, RecordTableView
from .verdict_text import category_colour, category_word

_LINES = 6


@dataclass(frozen=True)
class PartsTableRow:
    """A part and its result.

    Attributes
    ----------
    name, label : str
    instances : int
    record : dict or None
        None until the part is measured.
    failure : str
        Why the part could not be measured; empty where that did not fail.
    """

    name: str
    label: str
    instances: int
    record: Optional[dict] = None
    failure: str = ""


class PartsTable(RecordTableView):
    """Label, category, thinnest wall and number of occurrences of every part; hidden where there is only one part.

    Signals
    -------
    part_chosen(str)
        Name of the part that the user has clicked.
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
        rows : list of PartsTableRow
        profile : Profile
            Used for their classification.
        unit : LengthUnit
        """
        self._profile, self._unit = profile, unit
        self.set_columns(self._columns())
        self.update_rows(rows, lambda one, other: one.name == other.name)
        self.setVisible(len(rows) > 1)

    def select_part(self, name):
        """Select a part without emitting a signal; clear the selection for None."""
        self.select(None if name is None else lambda row: row.name == name)

    def mousePressEvent(self, event):
        """Emit `row_chosen` also for a click on the row that is selected already."""
        before = self.current_row
        super().mousePressEvent(event)
        row = self.current_row
        if row is not None and row is before:
            self.row_chosen.emit(row)

    def _columns(self):
        return [
            RecordColumn(translate("ThinPart", "Part"), lambda row: row.label, lambda row: row.label.casefold(),
                      stretches=True),
            RecordColumn(translate("ThinPart", "Category"), self._category, self._category, swatch=_swatch),
            RecordColumn(translate("ThinPart", "Thinnest, {}").format(self._unit.symbol), self._thinnest_text,
                      _thinnest, is_number=True, meaning=translate("ThinPart", "Thinnest wall")),
            RecordColumn(translate("ThinPart", "\u00d7"), lambda row: str(row.instances),
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
    """list of PartsTableRow: the parts of a `DocumentAnalysis`."""
    rows = []
    for part in analysis.parts:
        failure = analysis.failures.get(part.name)
        rows.append(PartsTableRow(part.name, part.label, part.instances, analysis.records.get(part.name),
                            failure["message"] if failure else ""))
    return rows


def _swatch(row):
    return None if row.record is None else category_colour(row.record["category"])


def _thinnest(row):
    return None if row.record is None else row.record["descriptors"]["thickness_mm"]["min"]

