# SPDX-License-Identifier: LGPL-2.1-or-later
"""The visible part of a 3D view: in FreeCAD 1.1, docks can overlay the views."""

import FreeCADGui as Gui

from ..application.qt import QtCore, QtWidgets

_LEFT, _RIGHT, _TOP, _BOTTOM = "OverlayLeft", "OverlayRight", "OverlayTop", "OverlayBottom"
"""FreeCAD's object names of the areas for overlaid docks, which exist since 1.1."""

_MIN_SHARE = 0.3
"""If less than this share of a view's width or height is free, the overlays on that axis are ignored."""


def free_area(widget):
    """QRect of a view, or of its viewport, that no overlay covers, in pixels of the widget."""
    rect = widget.rect()
    left, top, right, bottom = 0, 0, rect.width(), rect.height()
    for name, covered in _overlays(widget):
        if name == _LEFT:
            left = max(left, covered.right() + 1)
        elif name == _RIGHT:
            right = min(right, covered.left())
        elif name == _TOP:
            top = max(top, covered.bottom() + 1)
        else:
            bottom = min(bottom, covered.top())
    min_size = _MIN_SHARE * rect.width(), _MIN_SHARE * rect.height()
    if right - left < min_size[0]:
        left, right = 0, rect.width()
    if bottom - top < min_size[1]:
        top, bottom = 0, rect.height()
    return QtCore.QRect(left, top, right - left, bottom - top)


def _overlays(widget):
    """Names of the overlays that cover a part of a widget, and the covered QRect in its coordinates."""
    for name in (_LEFT, _RIGHT, _TOP, _BOTTOM):
        overlay = Gui.getMainWindow().findChild(QtWidgets.QTabWidget, name)
        if overlay is None or not overlay.isVisible() or not overlay.count():
            continue
        overlay_rect = QtCore.QRect(widget.mapFromGlobal(overlay.mapToGlobal(QtCore.QPoint(0, 0))), overlay.size())
        covered = overlay_rect.intersected(widget.rect())
        if not covered.isEmpty():
            yield name, covered
