# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form for the limits of one process or material."""

from ..application.length_unit import length_unit
from ..application.qt import QtWidgets, Signal, translate
from ..widgets.exact_field import ExactField
from .kept_text import KeptText

_SOURCE = "author", "title", "year", "url"


class LimitsForm(QtWidgets.QWidget):
    """Edits one row of a table of limits.

    Signals
    -------
    changed
        The user has changed something.
    """

    changed = Signal()

    def __init__(self, parent):
        super().__init__(parent)
        self._written, self._is_showing = {}, False
        grid = QtWidgets.QFormLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        self._title = KeptText("ThinPart_LimitsTitle", "", self)
        self._id = QtWidgets.QLineEdit(self)
        self._id.setObjectName("ThinPart_LimitsId")
        self._id.setToolTip(translate("ThinPart", "By which the process is chosen, as in --check"))
        self._note = KeptText("ThinPart_LimitsNote", "", self)
        grid.addRow(translate("ThinPart", "Title"), self._title)
        grid.addRow(translate("ThinPart", "Short name"), self._id)
        self._limits = {key: self._add_limit(grid, key, text) for key, text in (
            ("min_mm", translate("ThinPart", "At least")), ("max_mm", translate("ThinPart", "At most")))}
        grid.addRow(translate("ThinPart", "Note"), self._note)
        self._source = {}
        for key, text in zip(_SOURCE, (translate("ThinPart", "Source: author"), translate("ThinPart", "Source: title"),
                                       translate("ThinPart", "Source: year"), translate("ThinPart", "Source: address"))):
            self._source[key] = QtWidgets.QLineEdit(self)
            self._source[key].setObjectName(f"ThinPart_LimitsSource{key.title()}")
            grid.addRow(text, self._source[key])
        for field in (self._title, self._note):
            field.changed.connect(self._on_changed)
        for field in (self._id, *self._source.values()):
            field.textEdited.connect(lambda _: self._on_changed())

    def show_row(self, row):
        """Show a row: dict, as in the file."""
        self._written, self._is_showing, unit = row, True, length_unit()
        self._title.show_written(row["title"])
        self._note.show_written(row.get("note", ""))
        self._id.setText(row["id"])
        for key, (box, field) in self._limits.items():
            field.set_form(1.0 / unit.millimetres, f"\u00a0{unit.symbol}", unit.decimals, 0.001, 1e6, 0.1)
            field.show_exact(1.0 if row[key] is None else row[key])
            box.setChecked(row[key] is not None)
            field.setEnabled(row[key] is not None)
        for key, field in self._source.items():
            field.setText(str(row.get("source", {}).get(key, "")))
            field.setCursorPosition(0)
        self._is_showing = False

    def row(self):
        """dict: the row as it is now, with what the user has not changed as it was written."""
        row = {**self._written, "id": self._id.text().strip(), "title": self._title.written(),
               **{key: field.exact() if box.isChecked() else None for key, (box, field) in self._limits.items()}}
        note, source = self._note.written(), self._shown_source()
        for key, value in (("note", note), ("source", source)):
            if value:
                row[key] = value
            else:
                row.pop(key, None)
        return row

    def focus_title(self):
        """Let the user type a title."""
        self._title.setFocus()
        self._title.selectAll()

    def _shown_source(self):
        source = dict(self._written.get("source", {}))
        for key, field in self._source.items():
            text = field.text().strip()
            if text == str(source.get(key, "")):
                continue
            if not text:
                source.pop(key, None)
            elif key != "year":
                source[key] = text
            elif text.isdecimal() and len(text) < 5:
                source[key] = int(text)
        return source

    def _add_limit(self, grid, key, text):
        box = QtWidgets.QCheckBox(text, self)
        box.setObjectName(f"ThinPart_LimitsHas{key.partition('_')[0].title()}")
        field = ExactField(f"ThinPart_Limits{key.partition('_')[0].title()}", self)
        box.toggled.connect(field.setEnabled)
        box.toggled.connect(lambda _: self._on_changed())
        field.changed.connect(self._on_changed)
        grid.addRow(box, field)
        return box, field

    def _on_changed(self):
        if not self._is_showing:
            self.changed.emit()
