# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of criteria: one group per criterion, one row per condition."""

from ...core.descriptors.descriptor_table import quantity_named
from ..application.numbers import marked, number, percent
from ..application.qt import QtCore, QtGui, QtWidgets, call_later, translate
from ..application.sentences import translated
from ..application.theme import is_theme_change, readable
from .verdict_text import holds_text

_HOLDS_COLOURS = QtGui.QColor(30, 110, 50), QtGui.QColor(115, 215, 135)
_FAILS_COLOURS = QtGui.QColor(110, 110, 110), QtGui.QColor(160, 160, 160)
"""Text colours, on a light and on a dark background."""

QUANTITY, VALUE, THRESHOLD, HOLDS, MARGIN = range(5)


class CriteriaTree(QtWidgets.QTreeWidget):
    """Shows what every criterion compared. As high as its rows, so that only the panel scrolls."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._evidence = []
        self.setObjectName("ThinPart_CriteriaTable")
        self.setColumnCount(5)
        self.setHeaderLabels([
            translate("ThinPart", "Quantity"), translate("ThinPart", "Value"),
            translate("ThinPart", "Threshold"), translate("ThinPart", "Holds"),
            translate("ThinPart", "Margin"),
        ])
        self.setIndentation(6)
        font = self.font()
        font.setPointSizeF(font.pointSizeF() * 0.88)
        self.setFont(font)
        self.header().setFont(font)
        self.setSelectionMode(QtWidgets.QAbstractItemView.NoSelection)
        self.setFocusPolicy(QtCore.Qt.NoFocus)
        self.setVerticalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        self.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAsNeeded)
        self.header().setSectionResizeMode(QtWidgets.QHeaderView.ResizeToContents)
        self.header().setMinimumSectionSize(20)
        self.itemExpanded.connect(self._fit)
        self.itemCollapsed.connect(self._fit)

    def show_evidence(self, evidence):
        """Fill the table with the evidence of a part record."""
        self._evidence = evidence
        self.clear()
        for row in evidence:
            group = _group(row)
            self.addTopLevelItem(group)
            group.setFirstColumnSpanned(True)
            group.addChildren([_condition(condition) for condition in row["conditions"]])
            group.setExpanded(row["holds"] is not False)
        self._colour_rows()
        self._fit()

    def _colour_rows(self):
        holds, fails = QtGui.QBrush(readable(self, *_HOLDS_COLOURS)), QtGui.QBrush(readable(self, *_FAILS_COLOURS))
        for index, row in enumerate(self._evidence):
            group = self.topLevelItem(index)
            if row["holds"]:
                group.setForeground(0, holds)
            for child, condition in enumerate(row["conditions"]):
                if condition["holds"] is False:
                    for column in range(self.columnCount()):
                        group.child(child).setForeground(column, fails)

    def _fit(self, *_):
        rows = sum(
            1 + (self.topLevelItem(index).childCount() if self.topLevelItem(index).isExpanded()
                 else 0)
            for index in range(self.topLevelItemCount())
        )
        row = self.sizeHintForRow(0) if self.topLevelItemCount() else 0
        bar = self.horizontalScrollBar().sizeHint().height()
        height = self.header().sizeHint().height() + rows * row + 2 * self.frameWidth()
        header = self.header()
        width = sum(max(self.sizeHintForColumn(column), header.sectionSizeHint(column)) for column in range(5))
        wide = width > self.viewport().width()
        # The titles of criteria span all columns.
        header.setStretchLastSection(not wide)
        self.setFixedHeight(height + (bar if wide and self.isVisible() else 0) + 2)

    def resizeEvent(self, event):
        """Adapt the height: a narrow panel needs a scroll bar."""
        super().resizeEvent(event)
        call_later(self, self._fit)

    def changeEvent(self, event):
        """Keep the text readable when FreeCAD's theme changes."""
        super().changeEvent(event)
        if is_theme_change(event) and self._evidence:
            call_later(self, self._colour_rows)  # the theme may change while rows are being added


def _group(row):
    symbol, word = holds_text(row["holds"]).split(" ", 1)
    # The paper numbers its criteria; the short names of others are for files and searches.
    numbered = f"{row['criterion']}  " if str(row["criterion"]).isdecimal() else ""
    group = QtWidgets.QTreeWidgetItem([f"{symbol} {numbered}{translated(row['title'])}"])
    group.setData(0, QtCore.Qt.UserRole, row["criterion"])
    group.setToolTip(0, translate(
        "ThinPart", "Criterion {}: {}. All its conditions hold: {}."
    ).format(row["criterion"], translated(row["title"]), word))
    font = group.font(0)
    font.setBold(bool(row["holds"]))
    group.setFont(0, font)
    return group


def _condition(condition):
    quantity = quantity_named(condition["quantity"])
    value = number(condition["value"])
    if condition["value"] is None and quantity.absent_means is not None:
        value = translate("ThinPart", "none")
    item = QtWidgets.QTreeWidgetItem([
        short_symbol(quantity), value,
        f"{condition['comparison']} {number(condition['threshold'])}",
        holds_text(condition["holds"]), percent(condition["margin"]),
    ])
    meaning = translated(quantity.meaning)
    if quantity.bounds:
        meaning += marked(f" (a = {quantity.bounds[0]:g}, b = {quantity.bounds[1]:g})")
    for column in range(5):
        item.setToolTip(column, meaning)
        if column in (VALUE, THRESHOLD, MARGIN):
            item.setTextAlignment(column, QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
    return item


def short_symbol(quantity):
    """A quantity's symbol, or a short text where the symbol is too long for a narrow table."""
    if quantity.is_wall_distance:
        low, high = quantity.bounds
        return marked(translate("ThinPart", "wedge {:g}\u2013{:g}\u00b0").format(low, high))
    return quantity.symbol
