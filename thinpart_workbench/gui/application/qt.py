# SPDX-License-Identifier: LGPL-2.1-or-later
"""Qt as FreeCAD ships it: every other module of the GUI imports its Qt names from here."""

import warnings
from contextlib import contextmanager, suppress

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    # FreeCAD 0.20 has the widgets in QtGui.
    QtWidgets = QtGui

Signal = QtCore.Signal


def translate(context, text):
    """The text in the user's language; the context is always ``"ThinPart"``."""
    return QtCore.QCoreApplication.translate(context, text)


def translated_mark(text):
    """Like `translate`, for a text that is marked for translation where it is declared, as in `PREFERENCES`."""
    return QtCore.QCoreApplication.translate("ThinPart", text) if text else ""


def named(widget, name, tool_tip=""):
    """A widget with an object name, by which tests and style sheets find it, and a tool tip."""
    widget.setObjectName(name)
    widget.setToolTip(tool_tip)
    return widget


@contextmanager
def blocked(*objects):
    """Context in which QObjects emit no signals, as while a panel shows what others have changed."""
    before = [each.blockSignals(True) for each in objects]
    try:
        yield
    finally:
        for each, was_blocked in zip(objects, before):
            each.blockSignals(was_blocked)


def grouped(count):
    """A count with the thousands separators of the user's locale, which FreeCAD 1.1 turns off in Qt."""
    locale = QtCore.QLocale()
    locale.setNumberOptions(locale.numberOptions() & ~QtCore.QLocale.OmitGroupSeparator)
    return locale.toString(int(count))


def execute(dialog):
    """Run a dialog modally with ``exec`` or ``exec_``, whichever this Qt has."""
    return (getattr(dialog, "exec", None) or dialog.exec_)()


def colour(rgb):
    """QColor of red, green and blue from 0 to 1."""
    return QtGui.QColor.fromRgbF(*rgb)


def flags_as_int(flags):
    """Qt flags as the integer that FreeCAD expects, in every version of Qt."""
    value = getattr(flags, "value", None)
    return int(flags) if value is None else value


def disconnect(signal, *slots):
    """Disconnect a signal from the given slots, or from all.

    Slots that are already disconnected are ignored; for those, Qt 5 raises and Qt 6 warns.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        with suppress(RuntimeError):
            signal.disconnect(*slots)


def mouse_position(event):
    """QPoint of the mouse in the coordinates of the widget that receives the event."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()


def flipped_vertically(image):
    """A QImage with its rows in reverse order."""
    return image.flipped() if hasattr(image, "flipped") else image.mirrored()


def call_later(owner, callback):
    """Call a function from the event loop, unless its owner is deleted before.

    Notes
    -----
    ``QTimer.singleShot`` has no owner: it would call a method of a widget that Qt has already deleted.
    """
    timer = QtCore.QTimer(owner)
    timer.setSingleShot(True)
    timer.timeout.connect(callback)
    timer.timeout.connect(timer.deleteLater)
    timer.start(0)
