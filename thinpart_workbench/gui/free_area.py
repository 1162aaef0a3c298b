"""The part of a 3D view that can be seen: FreeCAD 1.1 lays docks over its views."""

import FreeCADGui as Gui

from .qt import QtCore, QtWidgets

_LEFT, _RIGHT, _TOP, _BOTTOM = "OverlayLeft", "OverlayRight", "OverlayTop", "OverlayBottom"
"""What FreeCAD calls the places for docks over its views; before 1.1 there are none."""

_LEAST = 0.3
"""Share of a view's width and height that counts as free, whatever lies over it."""


def free_area(widget):
    """Where nothing lies over a view.

    Parameters
    ----------
    widget : QWidget
        The view, or what it draws on.

    Returns
    -------
    QRect
        In pixels of the widget.
    """
    whole = widget.rect()
    left, top, right, bottom = 0, 0, whole.width(), whole.height()
    for name, covered in _overlays(widget):
        if name == _LEFT:
            left = max(left, covered.right() + 1)
        elif name == _RIGHT:
            right = min(right, covered.left())
        elif name == _TOP:
            top = max(top, covered.bottom() + 1)
        else:
            bottom = min(bottom, covered.top())
    least = _LEAST * whole.width(), _LEAST * whole.height()
    if right - left < least[0]:
        left, right = 0, whole.width()
    if bottom - top < least[1]:
        top, bottom = 0, whole.height()
    return QtCore.QRect(left, top, right - left, bottom - top)


def _overlays(widget):
    """Names and places, in the widget, of the overlays that lie over it."""
    for name in (_LEFT, _RIGHT, _TOP, _BOTTOM):
        overlay = Gui.getMainWindow().findChild(QtWidgets.QTabWidget, name)
        if overlay is None or not overlay.isVisible() or not overlay.count():
            continue
        place = QtCore.QRect(widget.mapFromGlobal(overlay.mapToGlobal(QtCore.QPoint(0, 0))), overlay.size())
        covered = place.intersected(widget.rect())
        if not covered.isEmpty():
            yield name, covered
