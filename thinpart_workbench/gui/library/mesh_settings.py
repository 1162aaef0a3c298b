# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mesh settings that are kept with a part, as fields: a row per setting, or the file that has them."""

import json
from contextlib import suppress

from ..application.length_unit import length_unit
from ..application.numbers import decimal_mark
from ..application.qt import QtCore, QtWidgets, Signal, translate

NAME, VALUE = range(2)

_SIZE = "size"
"""The setting that is a length, in mm."""

_ROWS = 6
"""Visible at first, without scrolling."""


class MeshSettings(QtWidgets.QTableWidget):
    """A row for each setting that meshes usually have, one for each other that is kept, and an empty one for more.

    Signals
    -------
    edited
        A setting was changed.

    Notes
    -----
    What is not changed is kept as it is, including what a row cannot show, such as lists within lists.
    """

    edited = Signal()

    def __init__(self, parent=None):
        super().__init__(0, 2, parent)
        self.setObjectName("ThinPart_MeshSettings")
        self._stored, self._is_filling, self._unit = {}, False, length_unit()
        self.setHorizontalHeaderLabels([translate("ThinPart", "Setting"), translate("ThinPart", "Value")])
        self.verticalHeader().hide()
        self.horizontalHeader().setStretchLastSection(True)
        self.setTabKeyNavigation(False)  # Tab goes on to the next control
        self.setSelectionMode(QtWidgets.QAbstractItemView.SingleSelection)
        row = self.fontMetrics().height() + 10
        self.verticalHeader().setDefaultSectionSize(row)
        self.setMinimumHeight(4 * row)
        self._row_height = row
        self.itemChanged.connect(self._on_changed)
        self.show_settings({})

    def sizeHint(self):
        """As high as its first rows."""
        return QtCore.QSize(super().sizeHint().width(), (_ROWS + 1) * self._row_height + 8)

    def settings(self):
        """dict: the settings by name; those without a value are left out."""
        found = {}
        for row in range(self.rowCount()):
            name, value = self.item(row, NAME), self.item(row, VALUE)
            key, shown = name.data(QtCore.Qt.UserRole) or name.text().strip(), value.text().strip()
            if not key or not shown:
                continue
            stored = value.data(QtCore.Qt.UserRole)
            found[key] = self._stored[stored] if stored is not None and shown == self._shown(stored) else (
                self._read(key, shown))
        # In the order in which they are kept, so that nothing seems changed that is not.
        return {key: found[key] for key in [*(key for key in self._stored if key in found),
                                            *(key for key in found if key not in self._stored)]}

    def show_settings(self, settings):
        """Show the settings that are kept.

        Parameters
        ----------
        settings : dict
            JSON values by name.
        """
        self._stored = dict(settings)
        self._is_filling = True
        usual = self._titles()
        self.setRowCount(0)
        for key in [*usual, *(key for key in settings if key not in usual)]:
            self._add_row(usual.get(key, key), key, key if key in settings else None)
        self._add_row("", None, None)
        self.resizeColumnToContents(NAME)
        self._is_filling = False

    def show_unit(self):
        """Show lengths in the current unit; what was not saved yet stays."""
        settings, stored = self.settings(), self._stored
        self._unit = length_unit()
        self.show_settings(settings)
        self._stored = {**stored, **settings}

    def _titles(self):
        return {
            _SIZE: translate("ThinPart", "Largest size, {}").format(self._unit.symbol),
            "error": translate("ThinPart", "Error aimed at"),
            "layers": translate("ThinPart", "Layers in thin walls"),
            "order": translate("ThinPart", "Order of the elements"),
            "growth": translate("ThinPart", "Growth"),
            "budget": translate("ThinPart", "Most elements"),
        }

    def _add_row(self, title, key, stored):
        row = self.rowCount()
        self.insertRow(row)
        name = QtWidgets.QTableWidgetItem(title)
        if key is not None:
            name.setData(QtCore.Qt.UserRole, key)
            name.setFlags(name.flags() & ~QtCore.Qt.ItemIsEditable)
            name.setToolTip(key)
        value = QtWidgets.QTableWidgetItem("" if stored is None else self._shown(stored))
        if stored is not None:
            value.setData(QtCore.Qt.UserRole, stored)
            if isinstance(self._stored[stored], (dict, list)):
                value.setFlags(value.flags() & ~QtCore.Qt.ItemIsEditable)
        self.setItem(row, NAME, name)
        self.setItem(row, VALUE, value)

    def _shown(self, key):
        value = self._stored[key]
        if isinstance(value, (dict, list)):
            return translate("ThinPart", "{} entries").format(len(value))
        if isinstance(value, bool):
            return translate("ThinPart", "yes") if value else translate("ThinPart", "no")
        if value is None or isinstance(value, str):
            return value or "\u2013"
        number = value / self._unit.millimetres if key == _SIZE else value
        return f"{number:.6g}".replace(".", decimal_mark())

    def _read(self, key, shown):
        """The JSON value that a text stands for."""
        truth = {translate("ThinPart", "yes"): True, translate("ThinPart", "no"): False}
        if shown in truth:
            return truth[shown]
        text = shown.replace(decimal_mark(), ".")
        for kind in (int, float):
            with suppress(ValueError):
                number = kind(text)
                if abs(number) < 1e15:  # neither infinite nor not a number
                    return number * self._unit.millimetres if key == _SIZE and self._unit.millimetres != 1.0 else number
        return shown

    def _on_changed(self, item):
        if self._is_filling:
            return
        last = self.rowCount() - 1
        if item.row() == last and item.text().strip():
            self._is_filling = True
            self._add_row("", None, None)
            self._is_filling = False
        self.edited.emit()


def settings_text(settings):
    """What the process that saves annotations takes: str, empty without settings."""
    return json.dumps(settings, ensure_ascii=False) if settings else ""
