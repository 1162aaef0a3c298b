# SPDX-License-Identifier: LGPL-2.1-or-later
"""The filters of the part search, with the number of matching parts for each choice."""

from datetime import datetime, timedelta, timezone

from ...core.categories import NORMAL, UNKNOWN
from ...core.descriptors.descriptor_table import QUANTITIES
from ...core.length_unit import MILLIMETRE
from ...storage.index.part_query import FAILED, RANGED
from ..application.qt import QtCore, QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..record.category_marks import colour_icon, group_title
from ..record.part_columns import RISK, risk_title
from ..record.record_view import show_warning, text_line
from ..record.verdict_text import category_colour, criterion_titles
from ..widgets.flow_layout import add_flow
from ..widgets.narrow_fields import narrow_combo
from ..widgets.range_filter import RangeFilter

_LONGEST_TITLE = 36
"""Characters of a criterion's title beside its box; the whole title is in the tool tip."""

_TYPING_DELAY = 300
"""Milliseconds after the last key press before the filter is applied."""


class FiltersPage(QtWidgets.QWidget):
    """Edits the filters of a query.

    Parameters
    ----------
    profile : Profile
        Provides the titles of categories and criteria.

    Signals
    -------
    changed
        `query` has changed.
    """

    changed = Signal()

    def __init__(self, profile, parent=None):
        super().__init__(parent)
        self._profile = profile
        self._titles = criterion_titles(profile)
        self._categories, self._criteria = {}, {}
        self._typing_timer = QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)
        self._typing_timer.timeout.connect(self.changed)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        self._category_flow = self._flow(column, translate("ThinPart", "Categories (none chosen: any)"))
        self._criterion_flow = self._flow(
            column, translate("ThinPart", "Criteria that hold (none chosen: any)"))
        for name in [category.name for category in profile.categories] + [NORMAL, UNKNOWN, FAILED]:
            self._category_box(name)
        for name in (str(criterion.id) for criterion in profile.criteria):
            self._criterion_box(name)
        self._unit, self._ranges = MILLIMETRE, {}
        self._range_column = QtWidgets.QVBoxLayout()
        column.addLayout(self._range_column)
        self._add_range("thinnest_mm", "Thinnest", translate("ThinPart", "Thinnest wall, {}"))
        self._add_range("d1_mm", "Size", translate("ThinPart", "Longest side, {}"))
        self._add_range("volume_ratio", "Ratio", translate("ThinPart", "V/VBB"))
        column.addWidget(self._new_quantity_combo())
        self._add_conditions(column)
        self._add_flags(column)
        column.addStretch(1)

    def query(self):
        """dict: the ``query`` of a search request, without the words."""
        query = {}
        for key, boxes in (("categories", self._categories), ("criteria", self._criteria)):
            chosen = [name for name, (box, _) in boxes.items() if box.isChecked()]
            if chosen:
                query[key] = chosen
        # Those without bounds too: they show where the parts are.
        query["ranges"] = {name: list(range_filter.bounds) for name, range_filter in self._ranges.items()}
        for name, (box, _) in self._flags.items():
            if box.isChecked():
                query[name] = True
        if self._conditions.text().strip():
            query["conditions"] = self._conditions.text().strip()
        days = self._since.currentData()
        if days:
            # Rounded to the minute, so that an unchanged query compares equal.
            now = datetime.now(timezone.utc).replace(second=0, microsecond=0)
            query["changed_since"] = (now - timedelta(days=days)).isoformat()
        return query

    def clear(self):
        """Reset all filters and emit `changed` once."""
        self.blockSignals(True)
        for boxes in (self._categories, self._criteria, self._flags):
            for box, _ in boxes.values():
                box.setChecked(False)
        for range_filter in self._ranges.values():
            range_filter.clear()
        self._conditions.clear()
        self._typing_timer.stop()
        self._since.setCurrentIndex(0)
        self.blockSignals(False)
        self.show_refusal("")
        self.changed.emit()

    def show_result(self, result):
        """Show the counts of a search result."""
        for name in result["categories"]:
            if name not in self._categories:
                self._category_box(name)
        for name in result["criteria"]:
            if name not in self._criteria:
                self._criterion_box(name)
        for boxes, counts in ((self._categories, result["categories"]), (self._criteria, result["criteria"]),
                              (self._flags, result["flags"])):
            for name, (box, title) in boxes.items():
                _show_count(box, title, counts.get(name, 0))
        for name, scale in result["scales"].items():
            self._ranges[name].show_histogram(scale, result["histograms"][name])
        self.show_refusal(translated(result["refusal"]))

    def show_unit(self, unit):
        """Show and accept lengths in a LengthUnit; the query stays the same."""
        self._unit = unit
        for range_filter in self._ranges.values():
            range_filter.show_unit(unit)

    def show_refusal(self, sentence):
        """Show why the conditions are invalid."""
        show_warning(self._refusal, sentence)

    def _flow(self, column, title):
        label = QtWidgets.QLabel(title, self)
        label.setWordWrap(True)
        column.addWidget(label)
        return add_flow(column, self)

    def _category_box(self, name):
        box = self._box(f"ThinPart_Category_{name}")
        if name != FAILED:
            box.setIcon(colour_icon(category_colour(name)))
        self._category_flow.addWidget(box)
        self._categories[name] = box, group_title(name, self._profile)

    def _criterion_box(self, name):
        box = self._box(f"ThinPart_Criterion_{name}")
        title = self._titles.get(name, name)
        box.setToolTip(title if title == name else translate(
            "ThinPart", "{} (in searches and tables: {})").format(title, name))
        self._criterion_flow.addWidget(box)
        self._criteria[name] = box, title if len(title) <= _LONGEST_TITLE else f"{title[:_LONGEST_TITLE].rstrip()}\u2026"

    def _add_range(self, name, widget_name, title):
        self._ranges[name] = RangeFilter(widget_name, title, self)
        self._ranges[name].show_unit(self._unit)
        self._ranges[name].changed.connect(self.changed)
        self._range_column.addWidget(self._ranges[name])

    def _new_quantity_combo(self):
        """The choice of a further quantity; it then has a range as well."""
        self._quantity = combo = narrow_combo(self, "ThinPart_FindQuantity", 10)
        combo.addItem("+ {}\u2026".format(translate("ThinPart", "Quantity")))
        combo.addItem(risk_title(), RISK)
        for quantity in QUANTITIES:
            if quantity.name in RANGED and quantity.name not in self._ranges:
                combo.addItem(translated(quantity.meaning), quantity.name)
        combo.activated.connect(lambda _: self._add_quantity())
        return combo

    def _add_quantity(self):
        name = self._quantity.currentData()
        if name is not None:
            self._quantity.removeItem(self._quantity.currentIndex())
            self._quantity.setCurrentIndex(0)
            quantity = next((quantity for quantity in QUANTITIES if quantity.name == name), None)
            title = translated(quantity.meaning).replace("{", "{{").replace("}", "}}") if quantity else risk_title()
            self._add_range(name, name, f"{title}, {{}}" if quantity and quantity.unit == "mm" else title)
            self.changed.emit()

    def _add_conditions(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "Condition"), self)
        row.addWidget(label)
        self._conditions = QtWidgets.QLineEdit(self)
        self._conditions.setObjectName("ThinPart_FindConditions")
        self._conditions.setPlaceholderText("D2/D3 > 6 and F[0;0.05] >= 0.5")
        self._conditions.setClearButtonEnabled(True)
        self._conditions.textChanged.connect(lambda _: self._typing_timer.start())
        label.setBuddy(self._conditions)
        row.addWidget(self._conditions, 1)
        column.addLayout(row)
        self._refusal = text_line(self, column, "ThinPart_FindRefusal")
        self.show_refusal("")

    def _add_flags(self, column):
        flow = add_flow(column, self)
        self._flags = {
            "borderline": (self._box("ThinPart_FindBorderline"), translate("ThinPart", "Only unsure")),
            "has_notes": (self._box("ThinPart_FindNotes"), translate("ThinPart", "Only with notes")),
            "labelled": (self._box("ThinPart_FindLabelled"), translate("ThinPart", "Only labelled")),
            "disputed": (self._box("ThinPart_FindDisputed"), translate("ThinPart", "Only labelled otherwise")),
        }
        for box, _ in self._flags.values():
            flow.addWidget(box)
        self._since = QtWidgets.QComboBox(self)
        self._since.setObjectName("ThinPart_FindSince")
        for title, days in ((translate("ThinPart", "Changed at any time"), 0),
                            (translate("ThinPart", "Changed in the last day"), 1),
                            (translate("ThinPart", "Changed in the last week"), 7),
                            (translate("ThinPart", "Changed in the last month"), 30)):
            self._since.addItem(title, days)
        self._since.currentIndexChanged.connect(lambda _: self.changed.emit())
        flow.addWidget(self._since)

    def _box(self, name):
        box = QtWidgets.QCheckBox(self)
        box.setObjectName(name)
        box.toggled.connect(lambda _: self.changed.emit())
        return box


def _show_count(box, title, count):
    text = f"{title} ({grouped(count)})"
    if box.text() != text:
        box.setText(text)
