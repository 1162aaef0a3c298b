# SPDX-License-Identifier: LGPL-2.1-or-later
"""Using the profile editor as people do, and what it should say."""

import pytest
import window_actions as window

from thinpart_workbench.api.reclassification import reclassify
from thinpart_workbench.freecad_adapter.preferences import set_preference, set_preference_list
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.library.command import end_find_parts
from thinpart_workbench.gui.widgets.single_dialog import end_single_dialog


@pytest.fixture(autouse=True)
def own_files(tmp_path, monkeypatch):
    """Own profiles and limits of the test alone."""
    monkeypatch.setenv("THINPART_PROFILES", str(tmp_path / "profiles"))
    monkeypatch.setenv("THINPART_LIMITS", str(tmp_path / "wall_limits.json"))
    yield tmp_path
    end_single_dialog("ProfileDialog")
    end_find_parts()
    set_preference("Profile", None)
    window.wait_until(lambda: not window.workers("judging_worker"))


def opened(*libraries):
    set_preference_list("Libraries", [str(each) for each in libraries])
    window.press("ThinPart_EditProfile")
    window.wait_until(lambda: window.is_shown("ThinPart_ProfileDialog"))
    dialog = window.widget("ThinPart_ProfileDialog")
    counted(dialog)
    return dialog


def counted(dialog):
    window.settle(20)
    window.wait_until(lambda: not dialog.is_waiting)
    window.settle(20)


def named(parent, name):
    """The widgets of a name below another one, in the order of the page."""
    found = [each for each in parent.findChildren(QtWidgets.QWidget, f"ThinPart_{name}") if each.isVisibleTo(parent)]
    return sorted(found, key=lambda each: each.mapTo(parent, QtCore.QPoint(0, 0)).y())


def thresholds(dialog):
    return named(dialog, "ConditionValue")


def type_into(field, text):
    """Replace what a field says, key by key."""
    field.setFocus()
    field.selectAll()
    for letter in text:
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            QtWidgets.QApplication.sendEvent(field, QtGui.QKeyEvent(
                kind, QtGui.QKeySequence(letter)[0] if letter.isalnum() and not hasattr(QtGui.QKeySequence(letter)[0], "key")
                else 0, QtCore.Qt.NoModifier, letter))
    window.settle(5)


def told(dialog):
    return window.text("ThinPart_ProfileMessage")


def changes():
    table = window.widget("ThinPart_ProfileChangesTable")
    return {tuple(table.item(row, column).text() for column in range(2)): int(table.item(row, 2).text().replace(",", ""))
            for row in range(table.rowCount())}


def expected(folder, profile):
    """How many parts change their category."""
    return sum(part.before["category"] != part.after["category"]
               for file in reclassify([folder], profile) for part in file.parts)


def answer(button, act):
    window.answer("ThinPart_ProfileQuestion", lambda box: box.button(button).click())
    act()
    window.settle(30)
