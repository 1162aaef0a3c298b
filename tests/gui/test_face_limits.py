# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits for single faces in the panel of a thickness map: set by the menu of a face, kept, and respected by the check."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import Part
import pytest
import window_actions as window

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.judging.limit_bands import FAILS
from thinpart_workbench.freecad_adapter.objects.thickness_object import OWN_CHECK, thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.colour_bar.colours import BAND_COLOURS
from thinpart_workbench.storage.info.stored_records import stored_records

REASON = "crush rib, thin on purpose"


@pytest.fixture(autouse=True)
def person():
    set_preference("Person", "Anna")
    yield
    set_preference("Person", None)


@pytest.fixture
def saved(document, tmp_path):
    """The path of a saved document with a block and one rib of 1.5 mm, whose map is shown."""
    rib = Part.makeBox(60, 1.5, 30, App.Vector(0, 10, 10))
    ribbed = window.add(document, "Ribbed", Part.makeBox(60, 29, 10).fuse(rib).removeSplitter())
    path = tmp_path / "ribbed.FCStd"
    ribbed.Document.saveAs(str(path))
    Gui.runCommand("Std_Save")
    window.show_thickness()
    window.wait_until(lambda: window.text("ThinPart_InfoText").startswith("Info file, beside"))
    settled()
    return path


def settled():
    window.wait_until(lambda: not lifelong.requests.is_busy)
    window.settle(100)


def table():
    return window.widget("ThinPart_FaceTable")


def rib_row():
    """The row of a side of the rib."""
    return next(number for number, row in enumerate(table().rows) if row.summary.median == pytest.approx(1.5, rel=0.01))


def choose(name, row, answers=()):
    """Open the menu of a row, take an entry, and answer what it asks."""
    left = list(answers)

    def take():
        menu = QtWidgets.QApplication.activePopupWidget()
        action = next(each for each in menu.actions() if each.objectName() == f"ThinPart_Face_{name}")
        if left:
            QtCore.QTimer.singleShot(200, reply)
        window.mouse_click(menu, menu.actionGeometry(action).center())

    def reply():
        dialog, answer = QtWidgets.QApplication.activeModalWidget(), left.pop(0)
        if isinstance(answer, str):
            dialog.setTextValue(answer)
        else:
            dialog.setDoubleValue(answer)
        if left:
            QtCore.QTimer.singleShot(200, reply)
        dialog.accept()

    QtCore.QTimer.singleShot(100, take)
    table().customContextMenuRequested.emit(table().visualRect(table().model().index(row, 0)).center())
    window.wait_until(lambda: QtWidgets.QApplication.activePopupWidget() is None)
    window.settle(800 if answers else 100)
    settled()


def said():
    """The lines below the table, which may be in a page that is not open."""
    return window.widget("ThinPart_FaceLimits").text()


def check_at(thickness, millimetres):
    thickness.Threshold, thickness.Check = millimetres, OWN_CHECK
    window.settle(300)
    return window.widget("ThinPart_CheckResult").text()


def red_faces(thickness):
    """The names of the faces of the part that are red anywhere."""
    part, = parts_of(thickness)
    colours = thickness.ViewObject.Proxy.colours
    red = (colours.of_corners(0, part.map) == BAND_COLOURS[FAILS]).all(axis=2).any(axis=1)
    return {f"Face{number + 1}" for number in np.unique(part.map.face[red])}


def test_a_face_gets_a_limit_with_a_reason_which_the_check_and_the_colours_respect(saved):
    thickness = thickness_objects(App.ActiveDocument)[0]
    assert "fails" in check_at(thickness, 3.0)
    row = rib_row()
    face = table().rows[row].name
    sides = {each.name for each in table().rows if each.summary.median == pytest.approx(1.5, rel=0.01)}
    assert len(sides) == 2 and sides <= red_faces(thickness)
    choose("least", row, [1.0, REASON])
    kept, = stored_records(str(saved))[0]["face_limits"]
    assert (kept["face"], kept["min_mm"], kept["reason"], kept["person"]) == (face, 1.0, REASON, "Anna")
    assert REASON in said() and face in said()
    result = check_at(thickness, 3.0)
    assert "passes" in result and REASON in result
    assert not sides & red_faces(thickness), "the wall is seen from both sides, and one has the limit"
    choose("remove", rib_row())
    assert sides <= red_faces(thickness)
    assert "face_limits" not in stored_records(str(saved))[0]
    assert said() == "" and "fails" in check_at(thickness, 3.0)
