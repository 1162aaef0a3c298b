"""Showing the panel that finds parts. There is one, which FreeCAD keeps where the user has put it."""

import FreeCADGui as Gui

from .qt import QtCore

_docks = []  # the one that was made, or none


def toggle_find_parts():
    """Show the panel, or hide it where it is seen."""
    if _docks and _docks[0].isVisible():
        _docks[0].close()
    else:
        show_find_parts()


def show_find_parts():
    """Bring the panel to the front.

    Returns
    -------
    FindDock
    """
    # Not at the top: it brings numpy and scipy, and FreeCAD should start as fast as without them.
    from .find_dock import FindDock

    main = Gui.getMainWindow()
    if not _docks:
        _docks.append(FindDock(main))
        # FreeCAD keeps the places of its panels by their names, those of an earlier time as well.
        if not main.restoreDockWidget(_docks[0]):
            main.addDockWidget(QtCore.Qt.RightDockWidgetArea, _docks[0])
    dock = _docks[0]
    dock.show()
    dock.raise_()
    return dock


def end_find_parts():
    """Stop what is going on and forget the panel."""
    while _docks:
        dock = _docks.pop()
        dock.close()
        Gui.getMainWindow().removeDockWidget(dock)
        dock.deleteLater()
