"""Qt as FreeCAD brings it: every other module of the window takes its Qt names from here."""

import warnings
from contextlib import suppress

from PySide import QtCore, QtGui

try:
    from PySide import QtWidgets
except ImportError:
    # FreeCAD 0.20 has the widgets in its QtGui.
    QtWidgets = QtGui

Signal = QtCore.Signal


def translate(context, text):
    """The text in the user's language.

    Parameters
    ----------
    context : str
        Always ``"ThinPart"``.
    text : str
    """
    return QtCore.QCoreApplication.translate(context, text)


def translated_mark(text):
    """As `translate`, of a text that is marked for translation where it is declared.

    Parameters
    ----------
    text : str
        From `PREFERENCES`.
    """
    return QtCore.QCoreApplication.translate("ThinPart", text) if text else ""


def grouped(count):
    """A count with its thousands apart, as the user's country writes it; FreeCAD 1.1 tells Qt not to."""
    locale = QtCore.QLocale()
    locale.setNumberOptions(locale.numberOptions() & ~QtCore.QLocale.OmitGroupSeparator)
    return locale.toString(int(count))


def execute(dialog):
    """Show a dialog until the user answers it, under the name that this Qt has for that."""
    return (getattr(dialog, "exec", None) or dialog.exec_)()


def colour(rgb):
    """QColor of red, green and blue from 0 to 1."""
    return QtGui.QColor.fromRgbF(*rgb)


def number_of(flags):
    """Flags as the number that FreeCAD wants, whichever way this Qt keeps them."""
    value = getattr(flags, "value", None)
    return int(flags) if value is None else value


def disconnect(signal, *slots):
    """Disconnect a signal from some slots, or from all, that may be gone already: there Qt 5 raises and Qt 6 warns."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)
        with suppress(RuntimeError):
            signal.disconnect(*slots)


def mouse_place(event):
    """QPoint where the mouse is within the widget that has the event."""
    return event.position().toPoint() if hasattr(event, "position") else event.pos()


def upside_down(image):
    """A QImage with its first line last."""
    return image.flipped() if hasattr(image, "flipped") else image.mirrored()


def soon(owner, call):
    """Call something when the window has its turn next, unless its owner has gone by then.

    Parameters
    ----------
    owner : QObject
    call : callable

    Notes
    -----
    ``QTimer.singleShot`` has no owner: it would call a method of a widget that Qt has deleted.
    """
    timer = QtCore.QTimer(owner)
    timer.setSingleShot(True)
    timer.timeout.connect(call)
    timer.timeout.connect(timer.deleteLater)
    timer.start(0)
