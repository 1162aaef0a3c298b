# SPDX-License-Identifier: LGPL-2.1-or-later
"""Everything that can be read in a window."""

from thinpart_workbench.gui.application.qt import QtCore, QtWidgets

_HORIZONTAL = QtCore.Qt.Horizontal


def seen(root):
    """All texts of a window and of what lies in it, tool tips included."""
    for each in [root, *root.findChildren(QtWidgets.QWidget)]:
        for name in ("text", "toolTip", "placeholderText", "windowTitle", "title", "specialValueText", "suffix"):
            value = getattr(each, name, lambda: "")
            yield value() if callable(value) else ""
        if isinstance(each, QtWidgets.QTabWidget):
            yield from (each.tabText(index) for index in range(each.count()))
        if isinstance(each, QtWidgets.QComboBox):
            yield from (each.itemText(index) for index in range(each.count()))
        if isinstance(each, QtWidgets.QListWidget):
            yield from (each.item(row).text() for row in range(each.count()))
        if isinstance(each, (QtWidgets.QTableView, QtWidgets.QTreeView)):
            yield from _cells(each.model())


def _cells(model, parent=None):
    parent = parent or QtCore.QModelIndex()
    for column in range(model.columnCount(parent)):
        yield str(model.headerData(column, _HORIZONTAL) or "")
        yield str(model.headerData(column, _HORIZONTAL, QtCore.Qt.ToolTipRole) or "")
        for row in range(model.rowCount(parent)):
            index = model.index(row, column, parent)
            for role in (QtCore.Qt.DisplayRole, QtCore.Qt.ToolTipRole):
                yield str(model.data(index, role) or "")
            if column == 0 and model.rowCount(index):
                yield from _cells(model, index)
