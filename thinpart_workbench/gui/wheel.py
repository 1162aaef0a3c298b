"""The wheel scrolls the panel: it changes the value of a field only where that was chosen before."""

from .qt import QtCore


class _WheelGuard(QtCore.QObject):
    def eventFilter(self, field, event):
        if event.type() == QtCore.QEvent.Wheel and not field.hasFocus():
            event.ignore()  # what is around the field scrolls
            return True
        return False


def keep_from_wheel(field):
    """Have a field that may lie in something that scrolls take the wheel only while it has the focus.

    Parameters
    ----------
    field : QComboBox or QAbstractSpinBox
    """
    field.setFocusPolicy(QtCore.Qt.StrongFocus)  # else the wheel itself gives it the focus
    field.installEventFilter(_WheelGuard(field))
