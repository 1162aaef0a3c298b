# SPDX-License-Identifier: LGPL-2.1-or-later
"""What Qt, FreeCAD and Python complain of while a test runs, which a user would see in the Report view."""

import traceback

from thinpart_workbench.freecad_adapter.guard import FAULTS
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets

# Of the screen without a desktop, or of FreeCAD's own window.
_OTHERS = ("propagateSizeHints", "XDG_RUNTIME_DIR", "QStandardPaths", "Could not find any platform plugin",
           "libpng", "QFont", "qt.qpa", "QXcb", "QSocketNotifier: Can only be used", "iCCP")

_SIGNS = "Traceback", "Error:", "The thickness map "
"""Of what went wrong in the Report view."""

_messages = []


def listen():
    """Keep what Qt says from now on, and what ends at an edge, which the Report view has without its traceback."""
    QtCore.qInstallMessageHandler(_keep)
    FAULTS.add(lambda error: _messages.append("".join(traceback.format_exception(type(error), error,
                                                                               error.__traceback__))))


def _keep(kind, _context, text):
    if kind in (QtCore.QtMsgType.QtWarningMsg, QtCore.QtMsgType.QtCriticalMsg) and not any(
            each in text for each in _OTHERS):
        _messages.append(text)


def take():
    """list of str: what was complained of since the last call."""
    view = _report_view()
    found, _messages[:] = list(_messages), []
    if view is not None:
        found += [line for line in view.toPlainText().splitlines() if any(sign in line for sign in _SIGNS)]
        view.clear()
    return found


def _report_view():
    from FreeCADGui import getMainWindow

    return getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
