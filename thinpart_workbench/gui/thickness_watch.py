"""Has the thickness maps of all documents looked at whenever something was changed, and only then."""

import sys

from .qt import QtCore

_MAPS = "thinpart_workbench.freecad_adapter.thickness_object"
_timer = None


def look_soon():
    """Look at the maps once FreeCAD has finished what it is doing; costs nothing where there are none."""
    global _timer
    if _MAPS not in sys.modules:
        return  # FreeCAD imports it with the first map, numpy with it
    if _timer is None:
        _timer = QtCore.QTimer()
        _timer.setSingleShot(True)
        _timer.timeout.connect(_look)
    _timer.start(0)


def forget(document_name):
    """A document is about to be closed."""
    if "thinpart_workbench.gui.thickness_display" in sys.modules:
        from .thickness_display import DISPLAY

        DISPLAY.forget(document_name)
    look_soon()


def _look():
    from .thickness_display import DISPLAY

    DISPLAY.look()
