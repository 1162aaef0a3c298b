# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keeps the mouse wheel for scrolling: it changes the value of a field only while the user has given that the focus."""

from ..application.qt import QtCore


class _WheelGuard(QtCore.QObject):
    def __init__(self, field):
        super().__init__(field)
        self._is_chosen = True

    def eventFilter(self, field, event):
        if event.type() == QtCore.QEvent.FocusIn:
            # A panel that opens gives its first field the focus, which the user has not asked for.
            self._is_chosen = event.reason() != QtCore.Qt.OtherFocusReason
        elif event.type() in (QtCore.QEvent.KeyPress, QtCore.QEvent.MouseButtonPress):
            self._is_chosen = True
        elif event.type() == QtCore.QEvent.Wheel and not (field.hasFocus() and self._is_chosen):
            event.ignore()  # so that the enclosing scroll area handles it
            return True
        return False


def ignore_wheel_unless_focused(field):
    """Make a QComboBox or QAbstractSpinBox within a scroll area handle wheel events only while it has the focus."""
    field.setFocusPolicy(QtCore.Qt.StrongFocus)  # not WheelFocus, with which the wheel itself would focus the field
    field.installEventFilter(_WheelGuard(field))
