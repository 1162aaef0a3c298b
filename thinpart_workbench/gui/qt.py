"""Qt as FreeCAD brings it: every other module of the window takes its Qt names from here."""

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


def execute(dialog):
    """Show a dialog until the user answers it, under the name that this Qt has for that."""
    return (getattr(dialog, "exec", None) or dialog.exec_)()


def colour(rgb):
    """QColor of red, green and blue from 0 to 1."""
    return QtGui.QColor.fromRgbF(*rgb)


def number_of(flags):
    """Flags as the number that FreeCAD wants, whichever way this Qt keeps them."""
    return getattr(flags, "value", None) or int(flags)
