# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a person does with the window, and parts to do it with."""

import inspect
import os
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import time_limit

from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets, translate

SAMPLES = Path(__file__).resolve().parents[2] / "resources" / "samples"
V = App.Vector


def settle(milliseconds=30):
    """Let the window do what is waiting, and what comes, for some time."""
    clock = QtCore.QTimer(singleShot=True, timerType=QtCore.Qt.PreciseTimer)
    clock.start(milliseconds)
    while True:
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 10)
        QtWidgets.QApplication.sendPostedEvents(None, QtCore.QEvent.DeferredDelete)
        if not clock.isActive():
            return
        # Sleeps until something comes: looking all the time takes the processor from what is waited for.
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.WaitForMoreEvents)


class Turns:
    """Counts in a ``with`` block how often the window has its turn: `benchmarks/window.py` measures how long it has not."""

    def __init__(self):
        self.count = 0
        self._timer = QtCore.QTimer(interval=5)
        self._timer.timeout.connect(self._on_turn)

    def __enter__(self):
        self._timer.start()
        return self

    def __exit__(self, *_):
        self._timer.stop()

    def _on_turn(self):
        self.count += 1


def wait_until(condition, what=None, seconds=60.0):
    """Wait until something is so; fail where it never is, and say what was waited for and what the window shows.

    The time is for a machine that is busy with other things. What takes longer than a test may have is
    waited for no longer than that.

    Parameters
    ----------
    condition : callable
    what : str, optional
        In words; the condition's own source where nothing is given.
    seconds : float
    """
    time_limit.wait_until(condition, what or (lambda: _source_of(condition)), seconds, lambda: settle(40))


def _source_of(condition):
    try:
        return " ".join(inspect.getsource(condition).split())
    except (OSError, TypeError):  # something of Qt's
        return getattr(condition, "__qualname__", repr(condition))


def shown():
    """What the window shows, in lines: dialogs and what ThinPart says."""
    lines = []
    for kind, each in (("modal", QtWidgets.QApplication.activeModalWidget()),
                       ("popup", QtWidgets.QApplication.activePopupWidget())):
        if each is not None:
            lines.append(f"{kind}: {type(each).__name__} {each.objectName()!r} {each.windowTitle()!r}")
    for each in QtWidgets.QApplication.allWidgets():
        if isinstance(each, QtWidgets.QDialog) and each.isVisible():
            lines.append(f"dialog: {type(each).__name__} {each.objectName()!r} {each.windowTitle()!r}")
            lines += [f"    {label.text()!r}" for label in each.findChildren(QtWidgets.QLabel)
                      if label.isVisible() and label.text() and not label.objectName().startswith("ThinPart_")]
        elif isinstance(each, QtWidgets.QLabel) and each.objectName().startswith("ThinPart_") and each.isVisible():
            lines.append(f"{each.objectName()}: {each.text()!r}")
    return "The window shows\n  " + "\n  ".join(lines or ["nothing of ThinPart"])


def dismiss():
    """Close what waits for a person: a menu, a dialog."""
    popup, modal = QtWidgets.QApplication.activePopupWidget(), QtWidgets.QApplication.activeModalWidget()
    if popup is not None:
        popup.close()
    if modal is not None:
        modal.close()


def widget(name, kind=QtWidgets.QWidget):
    """The widget of a name, or None."""
    # Not among allWidgets() or topLevelWidgets(): PySide2 wraps widgets that Qt is about to delete, and crashes.
    app, roots, found = QtWidgets.QApplication, [], []
    for root in (Gui.getMainWindow(), app.activeWindow(), app.activeModalWidget(), app.activePopupWidget()):
        if root is not None and root not in roots:
            roots.append(root)
            of_name = [root] if isinstance(root, kind) and root.objectName() == name else []
            found += [each for each in [*of_name, *root.findChildren(kind, name)] if each not in found]
    shown = [each for each in found if each.isVisible()]
    return (shown or found or [None])[-1]


def is_shown(name):
    """Whether a widget is there to be seen."""
    found = widget(name)
    return found is not None and found.isVisible()


def text(name):
    """What a label says; empty where it is not shown."""
    return widget(name).text() if is_shown(name) else ""


def notices():
    """list of str: the warnings that were not dismissed yet, in FreeCAD's notification area or on our button."""
    found = _notified()
    if found is None:
        return widget("ThinPart_Notice").toolTip().splitlines()[:-1] if is_shown("ThinPart_Notice") else []
    return found[:len(found) - _dismissed[0]]


def dismiss_notices():
    """Take the warnings away, as a person does who has read them."""
    found = _notified()
    if found is not None:
        _dismissed[0] = len(found)
    elif is_shown("ThinPart_Notice"):
        click("ThinPart_Notice")
    assert not is_shown("ThinPart_Notice")


_dismissed = [0]


def notification_area():
    """Whom it is about and the message of all in FreeCAD's notification area, newest first; None where it has none."""
    button = Gui.getMainWindow().statusBar().findChild(QtWidgets.QPushButton, "notificationArea")
    if button is None:
        return None
    button.menu().aboutToShow.emit()
    settle(20)
    tree = button.menu().findChild(QtWidgets.QTreeWidget)
    items = [tree.topLevelItem(number) for number in range(tree.topLevelItemCount())]
    return [(each.text(1), each.text(2)) for each in items]


def _notified():
    """What ThinPart has said in the area."""
    area = notification_area()
    return None if area is None else [text.removeprefix("ThinPart: ") for about, text in area
                     if about == "ThinPart" or text.startswith("ThinPart: ")]


def click(name):
    """Press a button of the panel or of a dialog."""
    button = widget(name)
    assert button is not None and button.isVisible() and button.isEnabled(), name
    mouse_click(button)


def mouse_click(target, place=None):
    """Press and release the left mouse button in the middle of a widget, or at another place of it."""
    place = target.rect().center() if place is None else place
    mouse_drag(target, [place])


def mouse_drag(target, places, button=QtCore.Qt.LeftButton, is_released=True):
    """Press a mouse button at the first of some places, move over the others and, where that is wanted, let go."""
    # QTest would do the same, but Debian keeps it in a package that nothing else needs.
    nothing = QtCore.Qt.NoButton
    _mouse(target, QtCore.QEvent.MouseButtonPress, places[0], button, button)
    for place in places[1:]:
        _mouse(target, QtCore.QEvent.MouseMove, place, nothing, button)
        settle(40)
    if is_released:
        mouse_release(target, places[-1], button)


def mouse_release(target, place, button):
    """Let go of a mouse button."""
    _mouse(target, QtCore.QEvent.MouseButtonRelease, place, button, QtCore.Qt.NoButton)


def _mouse(target, kind, place, button, pressed):
    QtWidgets.QApplication.sendEvent(target, QtGui.QMouseEvent(
        kind, QtCore.QPointF(place), QtCore.QPointF(target.mapToGlobal(place)), button, pressed,
        QtCore.Qt.NoModifier))


def key(target, code, modifiers=QtCore.Qt.NoModifier):
    """Press and release a key."""
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, code, modifiers))


def edit_cell(table, row, column, text):
    """Write a text into a cell of a table, given by its name."""
    model = widget(table).model()
    model.setData(model.index(row, column), text)


def check_cell(table, row, is_on):
    """Set or remove the check mark of a row."""
    model = widget(table).model()
    model.setData(model.index(row, 0), QtCore.Qt.Checked if is_on else QtCore.Qt.Unchecked, QtCore.Qt.CheckStateRole)


def tool_button(command):
    """The tool bar's button of a command."""
    settle(5)
    Gui.isCommandActive(command)
    for button in Gui.getMainWindow().findChildren(QtWidgets.QToolButton):
        action = button.defaultAction()
        if action is not None and action.objectName() == command and button.isVisible():
            return button
    raise AssertionError(f"there is no button {command}")


def press(command):
    """Press a command's button in the tool bar."""
    button = tool_button(command)
    wait_until(button.isEnabled)  # FreeCAD looks every 300 ms which commands are active
    mouse_click(button)


def classify():
    """Press the button and wait for the result and the info file."""
    press("ThinPart_Classify")
    wait_until_measured()


def wait_until_measured():
    """Wait until nothing is being measured and the panel says what came out."""
    wait_until(lambda: not is_shown("ThinPart_Progress")
               and (is_shown("ThinPart_Headline") or is_shown("ThinPart_Message"))
               and text("ThinPart_InfoText") != translate("ThinPart", "Writing the info file\u2026"))


def show_thickness():
    """Press the button and wait for the map, or for a sentence why there is none."""
    press("ThinPart_ShowThickness")
    settle(50)  # FreeCAD shows the new panel in its own time
    wait_until(is_thickness_told)


def is_thickness_told():
    """Whether nothing is being measured and the panel shows a map or a sentence."""
    if is_shown("ThinPart_Progress"):
        return False
    if is_shown("ThinPart_ThicknessVerdict"):
        return is_shown("ThinPart_DistributionBox")  # the boxes come one turn of the window later
    return is_shown("ThinPart_Message")


def close_button():
    """The task view's own Close button."""
    found = []

    def look():
        found[:] = [each for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox)
                    for each in box.buttons()
                    if each.isVisible() and box.standardButton(each) == QtWidgets.QDialogButtonBox.Close]
        return found

    wait_until(look)
    return found[0]


def answer(dialog_name, act, seconds=60.0):
    """Have a modal dialog answered once it is there."""
    end = time.monotonic() + seconds

    def look():
        dialog = QtWidgets.QApplication.activeModalWidget()
        if dialog is not None and (not dialog_name or dialog.objectName() == dialog_name):
            act(dialog)
        elif time.monotonic() < end:
            QtCore.QTimer.singleShot(20, look)

    QtCore.QTimer.singleShot(20, look)


WORKERS = ("thinpart_workbench.window_processes.snapshot_worker", "thinpart_workbench\0classify",
           "thinpart_workbench\0report", "thinpart_workbench.window_processes.request_worker\0on-save")


def workers(*names):
    """Process ids of processes that this FreeCAD started and that still run.

    Those of which the command line holds one of the names; `WORKERS`, which measure, where none is given.
    The one that waits for something to measure is none of them.
    """
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text(errors="replace").rpartition(")")[2].split()
            command = (stat.parent / "cmdline").read_text(errors="replace")
        except OSError:
            continue  # it ended while being looked at
        number = int(stat.parent.name)
        if int(fields[1]) == os.getpid() and fields[0] != "Z" and number != lifelong.standby_worker.process_id and any(
                each in command for each in names or WORKERS):
            found.append(number)
    return found


def ribbed_shape():
    """A block with a rib 6 mm thick."""
    block = Part.makeBox(100, 60, 40)
    return block.fuse(Part.makeBox(100, 6, 20, V(0, 27, 40))).removeSplitter()


def add(document, name, shape, placement=None):
    """A Part::Feature of a shape."""
    feature = document.addObject("Part::Feature", name)
    feature.Shape = shape
    if placement is not None:
        feature.Placement = placement
    document.recompute()
    return feature


def add_ribbed_block(document, name="Ribbed"):
    """The block with the rib."""
    return add(document, name, ribbed_shape())


def slow_shape(holes=14):
    """A perforated plate that takes about three seconds to measure, with so many holes each way."""
    cut = [Part.makeCylinder(3, 10, V(10 * i, 10 * j, 0)) for i in range(1, holes + 1) for j in range(1, holes + 1)]
    return Part.makeBox(10 * holes + 10, 10 * holes + 10, 10).cut(Part.makeCompound(cut))


def rgb(feature):
    """Red, green and blue of every face."""
    return [tuple(round(part, 2) for part in each[:3]) for each in feature.ViewObject.DiffuseColor]
