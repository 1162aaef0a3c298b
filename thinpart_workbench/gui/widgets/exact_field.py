# SPDX-License-Identifier: LGPL-2.1-or-later
"""A spin box that gives a value back exactly as it was shown, unless the user has changed it.

Notes
-----
FreeCAD's ``Gui::QuantitySpinBox`` is no alternative, in 0.20 and 1.1 alike: its ``rawValue`` becomes what is shown
with the decimals of FreeCAD's preferences (2 mm in inches: 0.08 in, read back as 2.032 mm; 1/3 mm: 0.33), also by
gaining and losing the focus. Decimals and unit cannot be chosen for one field, what is shown stays in the old unit
when the unit changes, and "0,5" is read as 5. It has no text for a special value, and shows centimetres, or fractions
of inches, where `length_unit` does not.
"""

import math

from ..application.qt import QtCore, QtGui, QtWidgets, Signal, blocked

_MOST = 1e12


class ExactField(QtWidgets.QDoubleSpinBox):
    """Shows a value times a factor, with a unit. Point and comma are both the decimal point, whatever the language.

    Signals
    -------
    changed
        The value has changed.
    """

    changed = Signal()

    def __init__(self, name, parent):
        super().__init__(parent)
        self._factor, self._first_step, self._shown = 1.0, 1.0, None
        self.setObjectName(name)
        locale = QtCore.QLocale(self.locale())
        # Otherwise Germans who paste 0.7 would get 7.
        locale.setNumberOptions(QtCore.QLocale.OmitGroupSeparator | QtCore.QLocale.RejectGroupSeparator)
        self.setLocale(locale)
        self.valueChanged.connect(lambda *_: self.changed.emit())

    def set_form(self, factor=1.0, suffix="", decimals=4, least=-_MOST, most=_MOST, first_step=1.0):
        """Choose how a value is shown.

        Parameters
        ----------
        factor : float
            What the value is multiplied by: 100 for percent.
        suffix : str
        decimals : int
            Most decimals; zeros at the end are left out.
        least, most : float
            Of the value itself.
        first_step : float
            The change by an arrow, as shown, where the value is 0; elsewhere it is the second digit.
        """
        value = None if self._shown is None else self.exact()
        self._factor, self._first_step = factor, first_step
        with blocked(self):
            self.setDecimals(decimals)
            self.setSuffix(suffix)
            self.setRange(max(least * factor, -_MOST), min(most * factor, _MOST))
        if value is not None:
            self.show_exact(value)

    def exact(self):
        """float: the value that was shown, or the one that the user has entered since."""
        value = self.value()
        return self._shown[0] if self._shown is not None and value == self._shown[1] else self._rounded(value)

    def show_exact(self, value):
        """Show a value."""
        with blocked(self):
            self.setValue(value * self._factor)
        self._shown = value, self.value()

    def stepBy(self, steps):
        """Change the value by its second digit."""
        size = abs(self.value())
        step = 10.0 ** (math.floor(math.log10(size) + 1e-9) - 1) if size else self._first_step
        self.setValue(self.value() + steps * max(step, 10.0 ** -self.decimals()))

    def textFromValue(self, value):
        """Format a value without trailing zeros."""
        text = super().textFromValue(value)
        point = str(self.locale().decimalPoint())
        return text.rstrip("0").rstrip(point) if point in text else text

    def keyPressEvent(self, event):
        """Take a point or comma for the decimal point."""
        if event.text() in (".", ","):
            event = QtGui.QKeyEvent(event.type(), event.key(), event.modifiers(), str(self.locale().decimalPoint()))
        super().keyPressEvent(event)

    def _rounded(self, shown):
        """The value of what is shown, without the digits that dividing adds."""
        return float(f"{shown / self._factor:.12g}")
