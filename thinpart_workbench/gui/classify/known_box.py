# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that say what libraries have of a part already, and lead to it."""

import os

from ..application.qt import QtCore, QtWidgets, Signal, translate
from ..record.record_view import paint_swatch, show_text, swatch, text_line
from ..view3d.difference_nodes import OTHERS, OWN
from ..widgets.buttons import add_button
from ..widgets.flow_layout import add_flow

_IDENTICAL = "identical"


class KnownBox(QtWidgets.QWidget):
    """A sentence, buttons that show the difference and open the other part, and the legend of the difference.

    Signals
    -------
    difference_toggled(bool)
        Whether the user wants to see the difference.
    open_requested
        The user wants to see the other part.
    """

    difference_toggled = Signal(bool)
    open_requested = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._text = text_line(self, column, "ThinPart_KnownText")
        row = add_flow(column, self)
        self._show = add_button(row, self, "ThinPart_ShowDifference", translate("ThinPart", "Show the difference"),
                                lambda: self.difference_toggled.emit(self._show.isChecked()))
        self._show.setCheckable(True)
        self._show.setToolTip(translate(
            "ThinPart", "Colour in the view what only one of the two parts has; the document stays as it is"))
        self._open = add_button(row, self, "ThinPart_OpenKnown", translate("ThinPart", "Open it"), self.open_requested.emit)
        self._legend = QtWidgets.QWidget(self)
        self._legend.setObjectName("ThinPart_DifferenceLegend")
        rows = QtWidgets.QVBoxLayout(self._legend)
        rows.setContentsMargins(0, 0, 0, 0)
        rows.setSpacing(2)
        self._meanings = [self._legend_row(rows, number, rgb) for number, rgb in enumerate((OWN, OTHERS))]
        column.addWidget(self._legend)
        self._state = text_line(self, column, "ThinPart_DifferenceText")
        self.show_known(None, "")

    def show_known(self, known, sentence):
        """Show what `part_in_libraries` has found, or nothing."""
        show_text(self._text, sentence)
        self._text.setToolTip(known["file"] if known else "")
        self._open.setToolTip(known["file"] if known else "")
        self._open.setVisible(known is not None)
        self._show.setVisible(known is not None and known["kind"] != _IDENTICAL)
        file = os.path.basename(known["file"]) if known else ""
        for label, text in zip(self._meanings, (translate("ThinPart", "not in {}"), translate("ThinPart", "only in {}"))):
            label.setText(text.format(file))
        self.show_difference(False, None, "")
        self.setVisible(bool(sentence))

    def show_difference(self, is_running, found, sentence, unit=None):
        """Show whether the difference is looked for, or is in the view, or why it is not.

        Parameters
        ----------
        is_running : bool
        found : dict or None
            What `write_difference` says of the one that is shown.
        sentence : str
        unit : LengthUnit, optional
        """
        self._show.setChecked(is_running or found is not None)
        self._legend.setVisible(found is not None)
        if is_running:
            sentence = translate("ThinPart", "Comparing the two\u2026")
        elif found is not None and not found["share"] and not found["reference_share"]:
            sentence = translate("ThinPart", "No place is more than {} apart.").format(unit.text(found["tolerance_mm"], 2))
        elif found is not None:
            sentence = translate("ThinPart", "Coloured where the two are more than {} apart; at most it is {}.").format(
                unit.text(found["tolerance_mm"], 2), unit.text(found["greatest_mm"]))
        show_text(self._state, sentence)

    def show_problem(self, sentence):
        """Show why the other part cannot be opened, if it cannot."""
        if sentence:
            show_text(self._state, sentence)

    def _legend_row(self, rows, number, rgb):
        row = QtWidgets.QHBoxLayout()
        square = swatch(self._legend, f"ThinPart_DifferenceSwatch{number}", 12)
        paint_swatch(square, rgb)
        row.addWidget(square, 0, QtCore.Qt.AlignVCenter)
        label = text_line(self._legend, row, f"ThinPart_DifferenceMeaning{number}")
        row.setStretchFactor(label, 1)
        rows.addLayout(row)
        return label
