# SPDX-License-Identifier: LGPL-2.1-or-later
"""Forms and fields for FreeCAD's task view, which is narrow."""

from ..application.qt import QtCore, QtWidgets, named
from .exact_field import ExactField


class LengthField(ExactField):
    """A field for a length or a share, only wide enough for a few digits; it tells of a typed number once that is done."""

    def __init__(self, name, parent):
        super().__init__(name, parent)
        self.setKeyboardTracking(False)

    def show_length(self, value, unit, decimals, suffix=""):
        """Show a value; `unit` is what 1 in the field stands for."""
        self.set_form(1.0 / unit, suffix, decimals, 0.0, 1e6 * unit, 10.0 ** -decimals)
        self.show_exact(value)

    def minimumSizeHint(self):
        """Width for a few digits instead of the maximum with all decimals."""
        hint = super().minimumSizeHint()
        return QtCore.QSize(min(hint.width(), 11 * self.fontMetrics().averageCharWidth() + 20), hint.height())

    def sizeHint(self):
        """See `minimumSizeHint`."""
        return self.minimumSizeHint()


def new_form(parent):
    """A form that wraps fields below their titles if it is narrow."""
    form = QtWidgets.QFormLayout(parent)
    form.setContentsMargins(6, 6, 6, 6)
    form.setRowWrapPolicy(QtWidgets.QFormLayout.WrapLongRows)
    form.setFieldGrowthPolicy(QtWidgets.QFormLayout.AllNonFixedFieldsGrow)
    return form


def narrow_combo(parent, name, letters=6):
    """A combo box that may be narrower than its longest text: it has room for some letters."""
    combo = named(QtWidgets.QComboBox(parent), name)
    combo.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
    combo.setMinimumContentsLength(letters)
    return combo
