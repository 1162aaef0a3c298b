# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness maps in the window: made, pictured, pointed at."""

import FreeCADGui as Gui
import made_maps
import window_actions as window

from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.view3d.view_provider import ThicknessView


def show_map(document, *sources):
    """A thickness object of all parts of a document as a command would make it, seen from a corner."""
    document.openTransaction("Show thickness")
    thickness = made_maps.add_map(document, *sources)
    ThicknessView(thickness.ViewObject)
    document.commitTransaction()
    look_at(document)
    return thickness


def look_at(document):
    """All of a document, seen from a corner."""
    view = view_of(document)
    view.setAnimationEnabled(False)
    view.viewIsometric()
    view.fitAll()
    window.settle(100)
    return view


def view_of(document):
    """The first 3D view of a document."""
    return Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0]


def widget_of(view):
    """What gets the mouse."""
    return view.graphicsView().viewport()


def picture(view, folder, width=None, height=None, background="Current"):
    """QImage of what a saved picture shows, as large as the window where no size is given."""
    window.settle(60)
    widget = widget_of(view)
    file = str(folder / "picture.png")
    view.saveImage(file, width or widget.width(), height or widget.height(), background)
    return QtGui.QImage(file)


def place_of(view, point):
    """QPoint where a point of the document is seen."""
    x, y = view.getPointOnScreen(point)
    return QtCore.QPoint(x, widget_of(view).height() - 1 - y)


def pixel(image, place):
    """Red, green and blue from 0 to 255."""
    found = image.pixelColor(place)
    return found.red(), found.green(), found.blue()


def bar_rows(image):
    """The colours along the colour bar of a picture, from its top, or [] where there is none.

    It lies at the left edge; a column within it has most of the rows in colours that are not the plate's.
    """
    best = []
    for x in range(10, round(0.14 * image.width())):
        rows, run = [], []
        for y in range(image.height()):
            rgb = pixel(image, QtCore.QPoint(x, y))
            if max(rgb) - min(rgb) > 60:
                run.append(rgb)
            else:
                rows, run = max(rows, run, key=len), []
        rows = max(rows, run, key=len)
        if len(rows) > len(best):
            best = rows
    return best if len(best) > 0.25 * image.height() else []


def mouse(view, kind, place, button=QtCore.Qt.NoButton, held=None):
    """A mouse event as the window system sends them."""
    widget = widget_of(view)
    held = button if held is None else held
    QtWidgets.QApplication.sendEvent(widget, QtGui.QMouseEvent(
        kind, QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), button, held,
        QtCore.Qt.NoModifier))


def move_to(view, place):
    """Move the mouse."""
    mouse(view, QtCore.QEvent.MouseMove, place)


def click_at(view, place, to=None):
    """Press at a place and let go there, or at another one."""
    mouse(view, QtCore.QEvent.MouseMove, place)
    mouse(view, QtCore.QEvent.MouseButtonPress, place, QtCore.Qt.LeftButton)
    if to is not None:
        for share in (0.25, 0.5, 0.75, 1.0):
            step = place + (to - place) * share
            mouse(view, QtCore.QEvent.MouseMove, step, QtCore.Qt.NoButton, QtCore.Qt.LeftButton)
    mouse(view, QtCore.QEvent.MouseButtonRelease, to or place, QtCore.Qt.LeftButton, QtCore.Qt.NoButton)
    window.settle(50)


def wheel(view, place, delta):
    """Turn the wheel at a place."""
    widget = widget_of(view)
    QtWidgets.QApplication.sendEvent(widget, QtGui.QWheelEvent(
        QtCore.QPointF(place), QtCore.QPointF(widget.mapToGlobal(place)), QtCore.QPoint(0, 0), QtCore.QPoint(0, delta),
        QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False))


def bar_of_document(document):
    """Rectangle of the colour bar in a document's view, pixels; empty where there is none."""
    return widget_of(view_of(document)).property("ThinPart_ColourBar") or QtCore.QRect()
