"""The choices that parts are filtered by, each with how many parts it would leave."""

from datetime import datetime, timedelta, timezone

from ..core.categories import NORMAL, UNKNOWN
from ..storage.part_query import FAILED
from .flow_layout import FlowLayout
from .qt import QtCore, QtWidgets, Signal, grouped, translate
from .range_filter import RangeFilter
from .result_filter import colour_icon
from .result_table import group_title
from .result_view import show_text, text_line
from .sentences import translated
from .verdict_text import category_colour
from .wheel import keep_from_wheel

_TYPING = 300
"""Milliseconds after the last key until what was typed is looked for."""

_BOUNDS = {"thinnest_mm": ("least_thickness", "most_thickness"), "d1_mm": ("least_size", "most_size"),
           "volume_ratio": ("least_ratio", "most_ratio")}


class PartFilters(QtWidgets.QWidget):
    """Shows and tells a query.

    Parameters
    ----------
    profile : Profile
        Has the words for categories and criteria.

    Signals
    -------
    changed
        `query` is another one now.
    """

    changed = Signal()

    def __init__(self, profile, parent=None):
        super().__init__(parent)
        self._profile = profile
        self._titles = {str(each.id): translated(each.title) for each in profile.criteria}
        self._categories, self._criteria = {}, {}
        self._typed = QtCore.QTimer(self, singleShot=True, interval=_TYPING)
        self._typed.timeout.connect(self.changed)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        self._category_flow = self._flow(column, translate("ThinPart", "Categories (none chosen: any)"))
        self._criterion_flow = self._flow(
            column, translate("ThinPart", "Criteria that hold (none chosen: any)"))
        for name in [each.name for each in profile.categories] + [NORMAL, UNKNOWN, FAILED]:
            self._category_box(name)
        for name in self._titles:
            self._criterion_box(name)
        self._ranges = {
            "thinnest_mm": RangeFilter("Thinnest", translate("ThinPart", "Thinnest wall, {}"), self),
            "d1_mm": RangeFilter("Size", translate("ThinPart", "Longest side, {}"), self),
            "volume_ratio": RangeFilter("Ratio", translate("ThinPart", "V/VBB"), self),
        }
        for each in self._ranges.values():
            each.changed.connect(self.changed)
            column.addWidget(each)
        self._add_conditions(column)
        self._add_flags(column)
        column.addStretch(1)

    def query(self):
        """dict: what the search takes as ``query``, without the words."""
        query = {}
        for key, boxes in (("categories", self._categories), ("criteria", self._criteria)):
            chosen = [name for name, (box, _) in boxes.items() if box.isChecked()]
            if chosen:
                query[key] = chosen
        for name, fields in _BOUNDS.items():
            query.update({field: value for field, value in zip(fields, self._ranges[name].bounds)
                          if value is not None})
        for name, (box, _) in self._flags.items():
            if box.isChecked():
                query[name] = True
        if self._conditions.text().strip():
            query["conditions"] = self._conditions.text().strip()
        days = self._since.currentData()
        if days:
            # To the minute: the same question stays the same.
            now = datetime.now(timezone.utc).replace(second=0, microsecond=0)
            query["changed_since"] = (now - timedelta(days=days)).isoformat()
        return query

    def clear(self):
        """Choose everything, and tell it once."""
        self.blockSignals(True)
        for boxes in (self._categories, self._criteria, self._flags):
            for box, _ in boxes.values():
                box.setChecked(False)
        for each in self._ranges.values():
            each.clear()
        self._conditions.clear()
        self._typed.stop()
        self._since.setCurrentIndex(0)
        self.blockSignals(False)
        self.show_refusal("")
        self.changed.emit()

    def show_found(self, found):
        """Show the counts of what was found."""
        for name in found["categories"]:
            if name not in self._categories:
                self._category_box(name)
        for name in found["criteria"]:
            if name not in self._criteria:
                self._criterion_box(name)
        for boxes, counts in ((self._categories, found["categories"]), (self._criteria, found["criteria"]),
                              (self._flags, found["flags"])):
            for name, (box, title) in boxes.items():
                _show_count(box, title, counts.get(name, 0))
        for name, each in self._ranges.items():
            each.show_histogram(found["scales"][name], found["histograms"][name])
        self.show_refusal(translated(found["refusal"]))

    def show_unit(self, unit):
        """Write and take lengths in a LengthUnit from now on; the query stays."""
        for name in ("thinnest_mm", "d1_mm"):
            self._ranges[name].show_unit(unit)

    def show_refusal(self, sentence):
        """Say why the conditions are not understood."""
        show_text(self._refusal, "\u26a0 " + sentence if sentence else "")

    def _flow(self, column, title):
        label = QtWidgets.QLabel(title, self)
        label.setWordWrap(True)
        column.addWidget(label)
        place = QtWidgets.QWidget(self)
        column.addWidget(place)
        return FlowLayout(place)

    def _category_box(self, name):
        box = self._box(f"ThinPart_Category_{name}")
        if name != FAILED:
            box.setIcon(colour_icon(category_colour(name)))
        self._category_flow.addWidget(box)
        self._categories[name] = box, group_title(name, self._profile)

    def _criterion_box(self, name):
        box = self._box(f"ThinPart_Criterion_{name}")
        box.setToolTip(self._titles.get(name, ""))
        self._criterion_flow.addWidget(box)
        self._criteria[name] = box, name

    def _add_conditions(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "Condition"), self)
        row.addWidget(label)
        self._conditions = QtWidgets.QLineEdit(self)
        self._conditions.setObjectName("ThinPart_FindConditions")
        self._conditions.setPlaceholderText("D2/D3 > 6 and F[0;0.05] >= 0.5")
        self._conditions.setClearButtonEnabled(True)
        self._conditions.textChanged.connect(lambda _: self._typed.start())
        label.setBuddy(self._conditions)
        row.addWidget(self._conditions, 1)
        column.addLayout(row)
        self._refusal = text_line(self, column, "ThinPart_FindRefusal")
        show_text(self._refusal, "")

    def _add_flags(self, column):
        place = QtWidgets.QWidget(self)
        flow = FlowLayout(place)
        self._flags = {
            "borderline": (self._box("ThinPart_FindBorderline"), translate("ThinPart", "Only borderline")),
            "has_notes": (self._box("ThinPart_FindNotes"), translate("ThinPart", "Only with notes")),
        }
        for box, _ in self._flags.values():
            flow.addWidget(box)
        self._since = QtWidgets.QComboBox(self)
        self._since.setObjectName("ThinPart_FindSince")
        keep_from_wheel(self._since)
        for title, days in ((translate("ThinPart", "Changed at any time"), 0),
                            (translate("ThinPart", "Changed in the last day"), 1),
                            (translate("ThinPart", "Changed in the last week"), 7),
                            (translate("ThinPart", "Changed in the last month"), 30)):
            self._since.addItem(title, days)
        self._since.currentIndexChanged.connect(lambda _: self.changed.emit())
        flow.addWidget(self._since)
        column.addWidget(place)

    def _box(self, name):
        box = QtWidgets.QCheckBox(self)
        box.setObjectName(name)
        box.toggled.connect(lambda _: self.changed.emit())
        return box


def _show_count(box, title, count):
    text = f"{title} ({grouped(count)})"
    if box.text() != text:
        box.setText(text)
