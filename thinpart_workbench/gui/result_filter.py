"""Choosing which results are shown: words, categories with their counts, failures only."""

from ..core.categories import NORMAL, UNKNOWN
from .flow_layout import FlowLayout
from .qt import QtCore, QtGui, QtWidgets, colour, translate
from .result_order import FAILED
from .result_table import group_title
from .verdict_text import category_colour

_TYPING = 200
"""Milliseconds after the last key until what was typed is looked for."""


class ResultFilter(QtWidgets.QWidget):
    """A field for words and a check box per category.

    Parameters
    ----------
    table : ResultTable
        Shows what is chosen here.
    profile : Profile
    """

    def __init__(self, table, profile, parent=None):
        super().__init__(parent)
        self._table = table
        self._typed = QtCore.QTimer(self, singleShot=True, interval=_TYPING)
        self._typed.timeout.connect(self.apply)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.field = QtWidgets.QLineEdit(self)
        self.field.setObjectName("ThinPart_FolderFilter")
        self.field.setPlaceholderText(
            translate("ThinPart", "Filter: words of the file or the part"))
        self.field.setClearButtonEnabled(True)
        self.field.textChanged.connect(lambda _: self._typed.start())
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self.field, 1)
        self._only = QtWidgets.QCheckBox(translate("ThinPart", "Only failures"), self)
        self._only.setObjectName("ThinPart_OnlyFailures")
        self._only.toggled.connect(self._show_only_failures)
        row.addWidget(self._only)
        column.addLayout(row)
        self._boxes_place = QtWidgets.QWidget(self)
        self._flow = FlowLayout(self._boxes_place)
        column.addWidget(self._boxes_place)
        self._boxes = {}
        self.show_categories(profile)
        table.counts_changed.connect(self._show_counts)

    def show_categories(self, profile):
        """Have a check box for each category of a profile, all of them checked."""
        while self._flow.count():
            self._flow.takeAt(0).widget().deleteLater()
        names = [each.name for each in profile.categories] + [NORMAL, UNKNOWN, FAILED]
        self._boxes = {name: self._box(name, group_title(name, profile)) for name in names}
        before = self._only
        for box, _ in self._boxes.values():
            # New ones would be the last that Tab comes to.
            QtWidgets.QWidget.setTabOrder(before, box)
            before = box
        self._only.setChecked(False)
        self._show_counts()
        self.apply()

    def apply(self):
        """Show what is chosen."""
        hidden = {name for name, (box, _) in self._boxes.items() if not box.isChecked()}
        if self._only.isChecked():
            hidden = set(self._boxes) - {FAILED}
        self._table.select(self.field.text().split(), hidden)

    def _box(self, name, title):
        box = QtWidgets.QCheckBox(self._boxes_place)
        box.setObjectName(f"ThinPart_Show_{name}")
        if name != FAILED:
            box.setIcon(colour_icon(category_colour(name)))
        box.setChecked(True)
        box.toggled.connect(lambda _: self.apply())
        self._flow.addWidget(box)
        return box, title

    def _show_counts(self):
        for name, (box, title) in self._boxes.items():
            text = f"{title} ({self._table.counts[name]})"
            if box.text() != text:
                box.setText(text)

    def _show_only_failures(self, only):
        for box, _ in self._boxes.values():
            box.setEnabled(not only)
        self.apply()


def colour_icon(rgb):
    """A small square of a colour, as an icon."""
    return QtGui.QIcon(colour_square(rgb))


def colour_square(rgb):
    """A small square of a colour."""
    picture = QtGui.QPixmap(12, 12)
    picture.fill(colour(rgb))
    return picture
