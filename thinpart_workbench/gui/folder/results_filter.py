# SPDX-License-Identifier: LGPL-2.1-or-later
"""Filters the results by words, categories and failures."""

from collections import Counter

from ...core.categories import NORMAL, UNKNOWN
from ...storage.index.part_query import FAILED
from ..application.qt import QtCore, QtWidgets, translate
from ..record.category_marks import colour_icon, group_title
from ..record.verdict_text import category_colour
from ..widgets.flow_layout import FlowLayout

_TYPING_DELAY = 200
"""Milliseconds after the last key press before the filter is applied."""


class ResultsFilter(QtWidgets.QWidget):
    """A search field and a check box with a count per category.

    Parameters
    ----------
    table : KeptRows
        The filtered model.
    profile : Profile
    """

    def __init__(self, table, profile, parent=None):
        super().__init__(parent)
        self._table = table
        self._typing_timer = QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)
        self._typing_timer.timeout.connect(self.apply)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.field = QtWidgets.QLineEdit(self)
        self.field.setObjectName("ThinPart_FolderFilter")
        self.field.setPlaceholderText(
            translate("ThinPart", "Filter: words of the file or the part"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(lambda _: self._typing_timer.start())
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.field, 1)
        self._only = QtWidgets.QCheckBox(translate("ThinPart", "Only failures"), self)
        self._only.setObjectName("ThinPart_OnlyFailures")
        self._only.toggled.connect(self._show_only_failures)
        row.addWidget(self._only)
        column.addLayout(row)
        self._box_container = QtWidgets.QWidget(self)
        self._flow = FlowLayout(self._box_container)
        column.addWidget(self._box_container)
        self._boxes = {}
        self.begin(profile)

    def begin(self, profile):
        """Create a checked check box for each category of a profile, and count from zero."""
        while self._flow.count():
            self._flow.takeAt(0).widget().deleteLater()
        names = [category.name for category in profile.categories] + [NORMAL, UNKNOWN, FAILED]
        self._boxes = {name: self._box(name, group_title(name, profile)) for name in names}
        before = self._only
        for box, _ in self._boxes.values():
            # Otherwise new widgets come last in the tab order.
            QtWidgets.QWidget.setTabOrder(before, box)
            before = box
        self._only.setChecked(False)
        self.count_again()
        self.apply()

    def count(self, rows):
        """Count more rows."""
        self._counts.update(map(_group, rows))
        for name, (box, title) in self._boxes.items():
            text = f"{title} ({self._counts[name]})"
            if box.text() != text:
                box.setText(text)

    def count_again(self):
        """Count all rows of the table, also hidden ones."""
        self._counts = Counter()
        self.count(self._table.all_rows)

    def apply(self):
        """Apply the filter to the table: rows that contain all words, and whose category is checked."""
        words = self.field.text().casefold().split()
        hidden = {name for name, (box, _) in self._boxes.items() if not box.isChecked()}
        if self._only.isChecked():
            hidden = set(self._boxes) - {FAILED}

        def is_wanted(row):
            text = "\n".join(filter(None, (row.file, row.label, row.part))).casefold() if words else ""
            return all(word in text for word in words) and _group(row) not in hidden

        self._table.select(is_wanted)

    def _box(self, name, title):
        box = QtWidgets.QCheckBox(self._box_container)
        box.setObjectName(f"ThinPart_Show_{name}")
        if name != FAILED:
            box.setIcon(colour_icon(category_colour(name)))
        box.setChecked(True)
        box.toggled.connect(lambda _: self.apply())
        self._flow.addWidget(box)
        return box, title

    def _show_only_failures(self, only):
        for box, _ in self._boxes.values():
            box.setEnabled(not only)
        self.apply()


def _group(row):
    """A row's category, or `FAILED`."""
    return FAILED if row.error_kind else row.category
