# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings a document to the front of FreeCAD's window."""

import FreeCAD as App
import FreeCADGui as Gui

from .qt import QtWidgets


def bring_to_front(document):
    """Make a document the active one, and show its first 3D view where another document is seen."""
    if App.ActiveDocument == document:
        return
    App.setActiveDocument(document.Name)
    for view in Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[:1]:
        window = view.graphicsView()
        while window is not None and not isinstance(window, QtWidgets.QMdiSubWindow):
            window = window.parentWidget()
        if window is not None:
            window.mdiArea().setActiveSubWindow(window)
