# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of what libraries have more than once, and of families."""

from ...storage.part_table import SUBJECT, TableForm
from ..application.numbers import number, percent
from ..application.qt import QtWidgets, Signal, translate
from ..application.sentences import translated
from ..record.thumbnails import RowPictures, show_pictures
from ..tables.column import Column
from ..tables.kept_rows import KeptRows
from .found_rows import part_name
from .part_files_view import PartFilesView

_REFERENCE = "reference"

_LEAST_SAID = 1e-4
"""Distance, mm, that is said where it is less, as in the sentences."""


class DuplicateRows(KeptRows):
    """Model of rows of `duplicate_rows`, or of `family_rows`.

    Parameters
    ----------
    pictures : Thumbnails

    Attributes
    ----------
    pictures : RowPictures
    """

    def __init__(self, pictures, parent=None):
        self.pictures = RowPictures(pictures)
        super().__init__(self._columns(False), parent)
        pictures.loaded.connect(lambda: show_pictures(self))

    def show_kind(self, is_families):
        """Be a table of families, or of duplicates; it is empty then."""
        self.set_rows([])
        self.show_columns(self._columns(is_families))

    def tip(self, row, column):
        """The file of a part."""
        return row.file

    def _columns(self, is_families):
        group = Column("group", translate("ThinPart", "No."), lambda row: row.group, lambda row, unit: number(row.group),
                       is_number=True, most=6, meaning=translate("ThinPart", "Number of the group"))
        part = Column("label", translate("ThinPart", "Part"), part_name, picture=self.pictures.of, most=30, least=20)
        file = Column("file", translate("ThinPart", "File"), lambda row: row.place, is_path=True, most=34, least=10)
        if is_families:
            return [group, part, file, Column(
                "dimensions", translate("ThinPart", "Dimensions that vary"), lambda row: "", dimensions_text, most=60,
                least=16, stretches=True)]
        return [
            group, Column("kind", translate("ThinPart", "Kind"), kind_text, most=24, least=14), part, file,
            Column("greatest_mm", translate("ThinPart", "Apart, {}"), lambda row: row.greatest_mm, _length_or_none,
                   is_number=True, has_unit=True, most=13, least=13,
                   meaning=translate("ThinPart", "How far a place of one of the two surfaces is from the other at most")),
            Column("same_share", translate("ThinPart", "Same"), lambda row: row.same_share,
                   lambda row, unit: "" if row.same_share is None else percent(row.same_share), is_number=True, most=9,
                   least=9, meaning=translate("ThinPart", "Share of the surface that is the same: the less of both")),
            Column("says", translate("ThinPart", "Evidence"), lambda row: row.says,
                   lambda row, unit: evidence_text(row, unit), tip=evidence_text, most=60, least=16, stretches=True),
        ]


class DuplicatesView(PartFilesView):
    """Shows `DuplicateRows`.

    Signals
    -------
    current_changed(object)
        The selected part, or None.
    """

    current_changed = Signal(object)

    def __init__(self, table, parent=None):
        super().__init__("ThinPart_DuplicatesTable", table, parent)
        self.csv_form, self.csv_file, self.row_menu = _duplicates_form(), "duplicates", self._part_menu
        self.selectionModel().currentRowChanged.connect(lambda *_: self.current_changed.emit(self.current_part))

    def show_kind(self, is_families):
        """Show no rows, of families or of duplicates."""
        self.csv_form, self.csv_file = (
            (_families_form(), "families") if is_families else (_duplicates_form(), "duplicates"))
        self._table.show_kind(is_families)

    def show_rows(self, rows, unit):
        """Show the rows that were found, with lengths in a LengthUnit."""
        self._table.show_unit(unit)
        self._table.set_rows(rows)
        self.fit_columns()

    def _part_menu(self, part):
        menu = QtWidgets.QMenu(self)
        menu.setObjectName("ThinPart_DuplicatesMenu")
        for name, text, callback in self.file_actions():
            action = menu.addAction(text)
            action.setObjectName(f"ThinPart_Duplicate{name}")
            action.setEnabled(part is not None)
            action.triggered.connect(lambda *_, callback=callback: callback())
        return menu


def kind_text(row):
    """What a part of a group is to the one that is to be kept."""
    if row.is_kept:
        return translate("ThinPart", "to keep")
    if row.kind == "scaled":
        text = translate("ThinPart", "{} times as large").format(number(row.scale))
        return translate("ThinPart", "{}, mirrored").format(text) if row.mirrored else text
    return {"identical": translate("ThinPart", "identical"), "mirrored": translate("ThinPart", "mirror image"),
            "alike": translate("ThinPart", "alike")}[row.kind]


def evidence_text(row, unit):
    """Why a part is the one to keep, or what shows that the other is the same."""
    said = translated(row.says, unit)
    return translate("ThinPart", "Kept because: {}").format(said) if row.is_kept else said


def dimensions_text(row, unit):
    """The dimensions of a part of a family in which it differs from the others."""
    words = {"d1_mm": translate("ThinPart", "length {}"), "d2_mm": translate("ThinPart", "width {}"),
             "d3_mm": translate("ThinPart", "height {}"), "thinnest_mm": translate("ThinPart", "wall {}")}
    return ", ".join(words.get(name, translate("ThinPart", "radius {}")).format(unit.text(value))
                     for name, value in row.dimensions.items())


def _duplicates_form():
    """A file of groups, as the command line writes it."""
    return TableForm(
        (*SUBJECT, "group", "kind", "greatest_mm", "same_share", "scale", "says"),
        lambda row: (row.file, row.name, row.label, row.group, _REFERENCE if row.is_kept else row.kind, row.greatest_mm,
                     row.same_share, row.scale, row.says))


def _families_form():
    return TableForm(
        (*SUBJECT, "group", "dimensions"),
        lambda row: (row.file, row.name, row.label, row.group,
                     ", ".join(f"{name}={value:.6g}" for name, value in row.dimensions.items())))


def _length_or_none(row, unit):
    return "" if row.greatest_mm is None else unit.number(max(row.greatest_mm, _LEAST_SAID), 2)
