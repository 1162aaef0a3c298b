# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows the dock that finds parts. FreeCAD restores the position of its single instance."""

import FreeCADGui as Gui

from ..application.qt import QtCore, call_later
from ..widgets.controls import prepare_controls

_WIDTH = 60
"""In characters, so that the names of parts and the figures beside them can be read."""

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
    is_new = not _docks
    if is_new:
        _docks.append(FindDock(main))
        # FreeCAD restores the position of docks by object name, also from earlier sessions.
        if not main.restoreDockWidget(_docks[0]):
            main.addDockWidget(QtCore.Qt.RightDockWidgetArea, _docks[0])
    dock = _docks[0]
    prepare_controls(dock, main)
    dock.show()
    dock.raise_()
    if is_new:
        call_later(dock, lambda: _widen(dock))  # once it has its place
    return dock


def _widen(dock):
    """Give a docked panel room for its table, where FreeCAD has given it less; the user may make it narrower."""
    main, width = Gui.getMainWindow(), _WIDTH * dock.fontMetrics().averageCharWidth()
    if not dock.isFloating() and dock.width() < width:
        main.resizeDocks([dock], [min(width, main.width() // 2)], QtCore.Qt.Horizontal)


def end_find_parts():
    """Stop the work of the dock and delete it."""
    while _docks:
        dock = _docks.pop()
        dock.close()
        Gui.getMainWindow().removeDockWidget(dock)
        dock.deleteLater()
