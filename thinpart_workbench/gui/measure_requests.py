"""Who is asked when a thickness map is to be measured again."""

from .qt import QtCore

_calls = []


def on_measure_request(call):
    """Have a function called with the document's and the object's name of maps to be measured again."""
    _calls.append(call)


def ask_for_measuring(thickness):
    """Ask for a map to be measured again, once FreeCAD has finished what it is doing."""
    document, name = thickness.Document.Name, thickness.Name
    # The object may be gone by then: whoever is called gets names.
    QtCore.QTimer.singleShot(0, lambda: [call(document, name) for call in _calls])
