# SPDX-License-Identifier: LGPL-2.1-or-later
"""A picture of a 3D view with the colour bar beside what is seen, never on it."""

from contextlib import contextmanager
from pathlib import Path

import FreeCADGui as Gui

from ...storage.temporary_folder import temporary_folder
from ..application import lifelong
from ..application.qt import QtCore, QtGui, translate

_WIDEST = 0.4
"""Greatest share of a picture's width that the bar takes."""

_MARGIN = 0.012
"""Share of a picture's height around the bar."""


def view_picture(document, width, height):
    """What the view of a document shows, as a QImage: the part whole as in the window, on white beside it the colour bar.

    Parameters
    ----------
    document : FreeCAD.Document
    width, height : int
        Pixels.

    Raises
    ------
    OSError
        Where the view cannot be drawn at this size.
    """
    view = Gui.getDocument(document.Name).activeView()
    bar = lifelong.scene_sync.bar_in(view)
    if bar is None:
        return _drawn(view, width, height)
    margin = max(4, round(_MARGIN * height))
    legend = bar.picture(QtCore.QSize(round(_WIDEST * width) - 2 * margin, height - 2 * margin))
    strip = legend.width() + 2 * margin
    with bar.left_out(), _as_wide_as_in_window(view, (width - strip) / height):
        seen = _drawn(view, width - strip, height)
    whole = QtGui.QImage(width, height, QtGui.QImage.Format_RGB32)
    whole.fill(QtCore.Qt.white)
    is_left = bar.place.across < 0.5
    painter = QtGui.QPainter(whole)
    painter.drawImage(strip if is_left else 0, 0, seen)
    painter.drawImage((0 if is_left else width - strip) + margin,
                      margin + round(bar.place.down * (height - 2 * margin - legend.height())), legend)
    painter.end()
    return whole


def _drawn(view, width, height):
    """QImage of a view as FreeCAD saves it."""
    with temporary_folder() as folder:
        file = Path(folder) / "view.png"
        view.saveImage(str(file), width, height, "Current")
        image = QtGui.QImage(str(file))
    if image.isNull():
        raise OSError(translate("ThinPart", "the view cannot be drawn at this size"))
    return image


@contextmanager
def _as_wide_as_in_window(view, ratio):
    """Have a picture of a ratio of width to height show all that the window shows from left to right."""
    widget, camera = view.graphicsView().viewport(), view.getCameraNode()
    seen = widget.width() / max(1, widget.height())
    opening = camera.height if hasattr(camera, "height") else camera.heightAngle
    before = opening.getValue()
    camera.enableNotify(False)  # the view in the window stays
    try:
        if ratio < seen:
            camera.scaleHeight(seen / ratio)
        yield
    finally:
        opening.setValue(before)
        camera.enableNotify(True)
