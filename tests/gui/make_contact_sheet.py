# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's start-up script for one picture of every panel, dialog and page; see run_in_freecad.py."""

import json
import os
import sys
import traceback
from pathlib import Path

HOME = Path(os.environ["HOME"])
GAP, TITLE = 16, 22
"""Pixels between the pictures, and above each for its name."""

COLUMNS = 4
INCHES = 3
"""FreeCAD's unit system "Imperial decimal"."""


def _pictures(document):
    """(name, QImage) of every window, one after the other."""
    import window_actions as window
    from every_window import WINDOWS

    for name, shown in WINDOWS.items():
        with shown(document) as widgets:
            window.settle(400)
            for number, widget in enumerate(each for each in widgets if each.isVisible()):
                yield (name if number == 0 else ""), _picture(widget)


def _picture(widget):
    """A widget on the background of windows: panels have none of their own, it is that of what they are put into."""
    from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets

    if isinstance(widget, (QtWidgets.QDialog, QtWidgets.QDockWidget)):
        return widget.grab().toImage()
    empty = QtWidgets.QDialog(widget.window())
    empty.resize(20, 20)
    ratio = widget.devicePixelRatioF()
    image = QtGui.QImage(widget.size() * ratio, QtGui.QImage.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(empty.grab().toImage().pixelColor(10, 10))
    empty.deleteLater()
    painter = QtGui.QPainter(image)
    widget.render(painter, QtCore.QPoint(), QtGui.QRegion(), QtWidgets.QWidget.DrawChildren)
    painter.end()
    return image


def _sheet(pictures):
    """All pictures in columns of about the same height: QImage."""
    from thinpart_workbench.gui.application.qt import QtCore, QtGui

    for _, image in pictures:
        image.setDevicePixelRatio(1.0)
    heights, widths, places = [GAP] * COLUMNS, [0] * COLUMNS, []
    for name, image in pictures:
        # What belongs to the panel before stays below it.
        column = heights.index(min(heights)) if name or not places else places[-1][0]
        places.append((column, heights[column] + TITLE))
        heights[column] += TITLE + image.height() + GAP
        widths[column] = max(widths[column], image.width())
    lefts = [GAP + sum(widths[:column]) + GAP * column for column in range(COLUMNS)]
    sheet = QtGui.QImage(GAP + sum(widths) + GAP * COLUMNS, max(heights), QtGui.QImage.Format_RGB32)
    sheet.fill(QtCore.Qt.gray)
    painter = QtGui.QPainter(sheet)
    for (column, top), (name, image) in zip(places, pictures):
        painter.drawText(lefts[column], top - 6, name)
        painter.drawImage(lefts[column], top, image)
    painter.end()
    return sheet


def _go():
    status = 1
    output = open(HOME / "output.txt", "w", encoding="utf-8")
    try:
        folder, file, unit = json.loads(os.environ["THINPART_GUI_ARGUMENTS"])
        sys.path[:0] = [folder, os.path.dirname(folder)]
        import FreeCAD as App
        import FreeCADGui as Gui
        from every_window import document_to_show

        Gui.activateWorkbench("ThinPartWorkbench")
        if unit == "inches":
            App.Units.setSchema(INCHES)
            App.ParamGet("User parameter:BaseApp/Preferences/Units").SetInt("UserSchema", INCHES)
        document = App.newDocument("Test")
        if unit == "inches" and "UnitSystem" in document.PropertiesList:
            document.UnitSystem = INCHES
        document_to_show(document)
        if not _sheet(list(_pictures(document))).save(file):
            raise OSError(f"{file} cannot be written")
        status = 0
    except BaseException:  # whatever it was: FreeCAD must end, and tell
        traceback.print_exc(file=output)
    finally:
        output.flush()
        os._exit(status)


from PySide import QtCore  # noqa: E402

QtCore.QTimer.singleShot(500, _go)
