# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the dock that finds parts. FreeCAD restores the position of its single instance."""

import FreeCADGui as Gui

from ..application.qt import QtCore
from ..widgets.controls import prepare_controls

_docks = []  # the single instance, if created


def toggle_find_parts():
    """Show the dock, or hide it if it is visible."""
    if _docks and _docks[0].isVisible():
        _docks[0].close()
    else:
        show_find_parts()


def show_find_parts():
    """Bring the dock to the front.

    Returns
    -------
    FindDock
    """
    # Imported late: it imports numpy and scipy, which would slow down the start of FreeCAD.
    from .dock import FindDock

    main = Gui.getMainWindow()
    if not _docks:
        _docks.append(FindDock(main))
        # FreeCAD restores the position of docks by object name, also from earlier sessions.
        if not main.restoreDockWidget(_docks[0]):
            main.addDockWidget(QtCore.Qt.RightDockWidgetArea, _docks[0])
    dock = _docks[0]
    prepare_controls(dock, main)
    dock.show()
    dock.raise_()
    return dock


def end_find_parts():
    """Stop the work of the dock and delete it."""
    while _docks:
        dock = _docks.pop()
        dock.close()
        Gui.getMainWindow().removeDockWidget(dock)
        dock.deleteLater()
