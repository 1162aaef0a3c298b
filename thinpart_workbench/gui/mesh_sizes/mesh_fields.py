# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fields that solid meshes and shells have alike."""

from ..application.qt import QtWidgets, named, translate
from ..widgets.exact_field import ExactField


def order_combo(name, parent):
    """The order of elements, the first at index 0."""
    combo = named(QtWidgets.QComboBox(parent), name)
    combo.addItems([translate("ThinPart", "linear (first order)"), translate("ThinPart", "quadratic (second order)")])
    return combo


def number_field(name, parent, value, least, most):
    """A number, which is told when it is complete."""
    field = ExactField(name, parent)
    field.set_form(least=least, most=most)
    field.show_exact(value)
    field.setKeyboardTracking(False)
    return field
