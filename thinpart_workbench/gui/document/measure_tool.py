# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks FreeCAD's own measure tool while a panel of ThinPart is open, and shows the reason."""

import FreeCAD as App
import FreeCADGui as Gui

from ...freecad_adapter.guard import guarded_methods
from ..application.qt import QtCore, QtWidgets, call_later

_COMMAND = "Std_Measure"
_TRIGGER_KEYS = (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter, QtCore.Qt.Key_Space)


@guarded_methods(eventFilter=False)
class MeasureTool(QtCore.QObject):
    """Event filter that discards attempts to open the tool as long as another task is open.

    Parameters
    ----------
    check_blocked : callable
        Returns whether a panel is open, and shows a message if so; called when the user asks for the tool.

    Notes
    -----
    FreeCAD 1.0 and 1.1 create the tool before they find that another task is open. The tool is then invisible and never
    ends: it goes on measuring the selection, removes selections that it cannot measure, and closes the open task when Esc
    is pressed; FreeCAD 1.1.3 has crashed because of one. So FreeCAD must be kept from creating it. The command emits no
    signal beforehand, so its buttons and menus are filtered. A keyboard shortcut that the user has given the command
    cannot be filtered: FreeCAD handles it first, and all that can be done is to show what blocks the tool.
    """

    def __init__(self, check_blocked):
        super().__init__()
        self._check_blocked = check_blocked
        self._actions, self._menus, self._is_connected = [], [], False
        if hasattr(App, "MeasureManager"):
            QtCore.QObject.connect(
                Gui.getMainWindow(), QtCore.SIGNAL("workbenchActivated(QString)"), lambda *_: self.watch())

    def watch(self):
        """Filter the events of the current buttons and menus, which differ between workbenches."""
        if not hasattr(App, "MeasureManager"):
            return  # an older FreeCAD, without the tool
        command, window = Gui.Command.get(_COMMAND), Gui.getMainWindow()
        self._actions = command.getAction() if command is not None else []
        self._menus = [menu for menu in window.findChildren(QtWidgets.QMenu) if self._has_command(menu)]
        buttons = [button for button in window.findChildren(QtWidgets.QToolButton)
                   if button.defaultAction() in self._actions]
        for widget in (*self._menus, *buttons):
            widget.removeEventFilter(self)
            widget.installEventFilter(self)
        if self._actions and not self._is_connected:
            self._is_connected = True
            for action in self._actions:
                action.triggered.connect(lambda *_: self._check_blocked())

    def eventFilter(self, watched, event):
        """Discard an event that would open the tool while it is blocked."""
        return self._opens_tool(watched, event) and self._check_blocked()

    def _opens_tool(self, watched, event):
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return isinstance(watched, QtWidgets.QToolButton) and event.button() == QtCore.Qt.LeftButton
        pressed = kind == QtCore.QEvent.KeyPress and event.key() in _TRIGGER_KEYS
        if isinstance(watched, QtWidgets.QToolButton):
            return pressed
        if isinstance(watched, QtWidgets.QMenu) and (pressed or kind == QtCore.QEvent.MouseButtonRelease):
            if watched.activeAction() in self._actions:
                call_later(watched, watched.close)
                return True
        return False

    def _has_command(self, menu):
        return any(action in self._actions for action in menu.actions())
