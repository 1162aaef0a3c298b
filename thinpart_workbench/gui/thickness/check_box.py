# SPDX-License-Identifier: LGPL-2.1-or-later
"""The choice of a process whose limits a thickness map is checked against, and the result."""

from ...freecad_adapter.objects.thickness_object import OWN_CHECK
from ..application.qt import QtCore, QtWidgets, Signal, blocked, translate
from ..application.sentences import translated
from ..record.record_view import show_text, text_line
from ..widgets.narrow_fields import LengthField, narrow_combo
from ..widgets.process_field import offered_limits


class CheckBox(QtWidgets.QWidget):
    """A list of processes, and the result for the shown parts.

    Signals
    -------
    chosen(str)
        Name of a process, `OWN_CHECK` for the threshold, or an empty text for none.
    limit_typed(float)
        The user wants to check an own limit, mm.
    """

    chosen = Signal(str)
    limit_typed = Signal(float)

    def __init__(self, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "Chec&k"), self)
        row.addWidget(label)
        self._combo = narrow_combo(self, "ThinPart_Check")
        self._combo.setToolTip(translate(
            "ThinPart", "Three colours: red is thinner than the limit, yellow up to a tenth above it, blue passes. Violet "
            "is thicker than the process allows, by the largest ball inside, as in the check"))
        label.setBuddy(self._combo)
        self._combo.addItem(translate("ThinPart", "none"), "")
        self._combo.addItem(translate("ThinPart", "own limit"), OWN_CHECK)
        for name, limits in offered_limits().items():
            self._combo.addItem(translated(limits.full_title), name)
        self._combo.currentIndexChanged.connect(lambda _: self.chosen.emit(self._combo.currentData()))
        row.addWidget(self._combo, 1)
        self._limit = LengthField("ThinPart_CheckLimit", self)
        self._limit.setToolTip(translate("ThinPart", "The least wall; another one is a limit of your own"))
        self._limit.changed.connect(lambda: self.limit_typed.emit(self._limit.exact()))
        row.addWidget(self._limit)
        column.addLayout(row)
        self._shares = text_line(self, column, "ThinPart_CheckShares")
        self._shares.setTextFormat(QtCore.Qt.RichText)
        self._result = text_line(self, column, "ThinPart_CheckResult")

    def show_check(self, name, least, unit, shares, text):
        """Show a choice and its result.

        Parameters
        ----------
        name : str
            As `chosen`.
        least : float, mm
            The least wall, 0 for none.
        unit : LengthUnit
        shares : list of (tuple, str)
            Colours, red, green and blue from 0 to 255, and what each says.
        text : str
        """
        with blocked(self):
            if self._combo.findData(name) < 0:
                self._combo.addItem(name, name)  # a process that was known when the map was saved
            self._combo.setCurrentIndex(self._combo.findData(name))
        self._limit.setVisible(bool(name))
        self._limit.show_length(least, unit.millimetres, unit.decimals, f"\u00a0{unit.symbol}")
        show_text(self._shares, " &nbsp;".join(
            '<span style="color: #{:02x}{:02x}{:02x}">\u25a0</span>&nbsp;{}'.format(*rgb, words.replace(" ", "&nbsp;"))
            for rgb, words in shares))
        show_text(self._result, text)
