"""Keeps the mouse wheel for scrolling: it changes the value of a field only while the field has the focus."""

from ..application.qt import QtCore


class _WheelGuard(QtCore.QObject):
    def eventFilter(self, field, event):
        if event.type() == QtCore.QEvent.Wheel and not field.hasFocus():
            event.ignore()  # so that the enclosing scroll area handles it
            return True
        return False


def ignore_wheel_unless_focused(field):
    """Make a field within a scroll area handle wheel events only while it has the focus.

    Parameters
    ----------
    field : QComboBox or QAbstractSpinBox
    """
    field.setFocusPolicy(QtCore.Qt.StrongFocus)  # not WheelFocus, with which the wheel itself would focus the field
    field.installEventFilter(_WheelGuard(field))
