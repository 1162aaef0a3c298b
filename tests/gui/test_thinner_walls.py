# SPDX-License-Identifier: LGPL-2.1-or-later
"""What became thinner after a part was edited: the map of before beside that of now, and the walls that changed."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.api.document_maps import parts_before
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.qt import QtWidgets


def add_pocketed_body(document):
    """A PartDesign body: a pad of 80 x 50 x 12 with a pocket of 8 mm, so that 4 mm are left under it."""
    body = document.addObject("PartDesign::Body", "Body")

    def sketch(name, x, y, wide, high, z):
        made = body.newObject("Sketcher::SketchObject", name)
        corners = [(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)]
        for one, other in zip(corners, corners[1:] + corners[:1]):
            made.addGeometry(Part.LineSegment(App.Vector(*one, 0), App.Vector(*other, 0)), False)
        made.Placement.Base.z = z
        return made

    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile = sketch("Outline", 0, 0, 80, 50, 0)
    pad.Length = 12
    document.recompute()
    pocket = body.newObject("PartDesign::Pocket", "Pocket")
    pocket.Profile = sketch("Hole", 20, 15, 40, 20, 12)
    pocket.Length = 8
    document.recompute()
    assert body.Shape.isValid() and abs(body.Shape.Volume - (80 * 50 * 12 - 40 * 20 * 8)) < 1e-3
    return pad, pocket


def measure_again(thickness):
    window.wait_until(lambda: thickness.Stale and window.is_shown("ThinPart_Stale"))
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: not thickness.Stale and window.is_thickness_told())
    window.settle(200)


def rows():
    model = window.widget("ThinPart_ThinnerTable").model()
    return [(round(row.wall.before, 1), round(row.wall.now, 1)) for row in model.rows]


@pytest.mark.timeout(150)  # it measures three times
def test_a_deeper_pocket_and_a_shorter_pad_are_told_with_both_maps(document, tmp_path):
    pad, pocket = add_pocketed_body(document)
    window.show_thickness()
    window.settle(200)
    thickness, = thickness_objects(document)
    button = window.widget("ThinPart_ThinnerButton")
    assert button.isVisible() and not button.isEnabled() and parts_before(thickness) == []
    pocket.Length = 10
    document.recompute()
    measure_again(thickness)
    window.click("ThinPart_ThinnerButton")
    window.wait_until(lambda: window.is_shown("ThinPart_ThinnerWalls"))
    assert (4.0, 2.0) in rows()
    before, now = (window.widget(f"ThinPart_Thinner{name}").pixmap().toImage() for name in ("Before", "Now"))
    assert before.size() == now.size() and before != now
    view = Gui.getDocument(document.Name).activeView()
    stood = view.getCameraNode().position.getValue().getValue()
    table = window.widget("ThinPart_ThinnerTable")
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(0, 0)).center())
    window.wait_until(lambda: view.getCameraNode().position.getValue().getValue() != stood, "the camera flies to the wall")
    window.widget("ThinPart_ThinnerView").setCurrentIndex(6)
    assert window.widget("ThinPart_ThinnerNow").pixmap().toImage() != now
    window.widget("ThinPart_ThinnerWalls").close()
    window.settle(100)
    # What was saved with the document is there again; a later change is compared with what was before it.
    document.saveAs(str(tmp_path / "body.FCStd"))
    pad.Length = 11
    document.recompute()
    measure_again(thickness)
    window.click("ThinPart_ThinnerButton")
    window.wait_until(lambda: window.is_shown("ThinPart_ThinnerWalls"))
    assert all(was > 2.0 for was, _ in rows() if was < 5.0) and (12.0, 11.0) in rows()
    document.save()
    dialog = window.widget("ThinPart_ThinnerWalls", QtWidgets.QDialog)
    name = document.Name
    App.closeDocument(name)
    window.settle(100)
    assert not window.is_shown("ThinPart_ThinnerWalls") or not dialog.isVisible()
    again = App.openDocument(str(tmp_path / "body.FCStd"))
    thickness, = thickness_objects(again)
    assert len(parts_before(thickness)) == 1
