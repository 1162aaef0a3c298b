"""FreeCAD's own measure tool while a panel of ThinPart is open: it says why it does not open."""

import FreeCAD as App
import FreeCADGui as Gui

from ..freecad_adapter.edge import guarded_methods
from .qt import QtCore, QtWidgets, soon

_COMMAND = "Std_Measure"
_TAKING_KEYS = (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter, QtCore.Qt.Key_Space)


@guarded_methods(eventFilter=False)
class MeasureTool(QtCore.QObject):
    """Keeps what a person does to open the tool from FreeCAD as long as it could not be opened.

    Parameters
    ----------
    in_the_way : callable
        Whether a panel is open, and say so; called when the tool is asked for.

    Notes
    -----
    FreeCAD 1.0 and 1.1 make the tool before they find that another task is open. It is never seen then, nor does it ever
    end: it goes on measuring what is selected, takes back selections that it cannot measure, and closes the task that is
    open when Esc is pressed; FreeCAD 1.1.3 crashed of one. So FreeCAD must not come to make it. The command has no signal
    that comes first, so its buttons and menus are watched. A key that the user has given the command cannot be: FreeCAD
    takes it before anybody else, and all that is left is to say what is in the way.
    """

    def __init__(self, in_the_way):
        super().__init__()
        self._in_the_way = in_the_way
        self._actions, self._menus, self._hears = [], [], False
        if hasattr(App, "MeasureManager"):
            QtCore.QObject.connect(
                Gui.getMainWindow(), QtCore.SIGNAL("workbenchActivated(QString)"), lambda *_: self.watch())

    def watch(self):
        """Watch the buttons and menus that there are now; those of another workbench are others."""
        if not hasattr(App, "MeasureManager"):
            return  # an older FreeCAD, without the tool
        command, window = Gui.Command.get(_COMMAND), Gui.getMainWindow()
        self._actions = command.getAction() if command is not None else []
        self._menus = [each for each in window.findChildren(QtWidgets.QMenu) if self._is_in(each)]
        buttons = [each for each in window.findChildren(QtWidgets.QToolButton) if each.defaultAction() in self._actions]
        for each in (*self._menus, *buttons):
            each.removeEventFilter(self)
            each.installEventFilter(self)
        if self._actions and not self._hears:
            self._hears = True
            for each in self._actions:
                each.triggered.connect(lambda *_: self._in_the_way())

    def eventFilter(self, watched, event):
        """Take the event away where it would open the tool and cannot."""
        return self._asks(watched, event) and self._in_the_way()

    def _asks(self, watched, event):
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return isinstance(watched, QtWidgets.QToolButton) and event.button() == QtCore.Qt.LeftButton
        pressed = kind == QtCore.QEvent.KeyPress and event.key() in _TAKING_KEYS
        if isinstance(watched, QtWidgets.QToolButton):
            return pressed
        if isinstance(watched, QtWidgets.QMenu) and (pressed or kind == QtCore.QEvent.MouseButtonRelease):
            if watched.activeAction() in self._actions:
                soon(watched, watched.close)
                return True
        return False

    def _is_in(self, menu):
        return any(each in self._actions for each in menu.actions())
