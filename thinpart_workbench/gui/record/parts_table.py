# SPDX-License-Identifier: LGPL-2.1-or-later
"""Table of a document's parts with their results."""

from dataclasses import dataclass
from typing import Optional

from ...api.window.verdicts import between, thinnest_kind
from ...storage.part_table import PartRow, TableForm, failed_row, measured_row
from ..application.qt import Signal, translate
from ..application.sentences import translated
from ..tables.column import Column, count, figures, square
from ..tables.small_table import SmallTable
from .verdict_text import category_colour, category_word, marked_thinnest, verdict_words

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
    failure : dict or None
        ``kind`` and ``message``, where the part could not be measured.
    """

    name: str
    label: str
    instances: int
    record: Optional[dict] = None
    failure: Optional[dict] = None


class PartsTable(SmallTable):
    """Label, category, thinnest wall and number of occurrences of every part; hidden where there is only one part.

    Signals
    -------
    part_chosen(str)
        Name of the part that the user has clicked.
    """

    part_chosen = Signal(str)

    def __init__(self, parent=None):
        super().__init__("ThinPart_PartTable", _columns(None), _LINES, parent)
        self.row_chosen.connect(lambda row: self.part_chosen.emit(row.name))
        self.hide()

    def show_parts(self, rows, profile, unit, file=""):
        """Show PartsTableRows in a LengthUnit, judged by a profile; `file` is the path of their document."""
        self.show_rows(rows, _columns(profile), unit, lambda one, other: one.name == other.name)
        self.csv_form, self.csv_file = TableForm(PartRow._fields, lambda row: _cells(file, row)), file
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


def part_rows(analysis):
    """list of PartsTableRow: the parts of a `DocumentAnalysis`."""
    return [PartsTableRow(part.name, part.label, part.instances, analysis.records.get(part.name),
                          analysis.failures.get(part.name)) for part in analysis.parts]


def _columns(profile):
    def category(row):
        if row.record is not None:
            return verdict_words(row.record["category"], between(row.record), profile, category_word)
        if row.failure:
            return translate("ThinPart", "failed: {}").format(translated(row.failure["message"]))
        return "\u2026"

    return [
        Column("label", translate("ThinPart", "Part"), lambda row: row.label, stretches=True,
               is_path=True, least=8),
        Column("category", translate("ThinPart", "Category"), category, picture=_swatch, least=10),
        Column("thinnest_mm", translate("ThinPart", "Thinnest, {}"), _thinnest,
               lambda row, unit: "" if _thinnest(row) is None else marked_thinnest(
                   unit.number(_thinnest(row)), thinnest_kind(row.record), _places(row)), is_number=True,
               has_unit=True, meaning=translate("ThinPart", "Thinnest wall, and how many places are about as thin")),
        figures("instances", translate("ThinPart", "\u00d7"), lambda row: row.instances, count,
                meaning=translate("ThinPart", "How often the part stands in the document")),
    ]


def _swatch(row):
    return None if row.record is None else square(category_colour(row.record["category"]))


def _thinnest(row):
    return None if row.record is None else row.record["descriptors"]["thickness_mm"]["min"]


def _places(row):
    return (row.record.get("thinnest") or {"places": 1})["places"]


def _cells(file, row):
    """The cells of a part in the table of parts."""
    if row.record is not None:
        return measured_row(file, row.record)._replace(instances=row.instances)
    return failed_row(file, row.name, row.label, row.failure or {"kind": None, "message": None})
