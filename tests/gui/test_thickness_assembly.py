# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thickness of a whole assembly, and how the window and a person wait for it."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application.qt import QtCore


def _assembly(document):
    """100 solids: links to ten boxes, each with a wall of its own, in a container."""
    container = document.addObject("App::Part", "Assembly")
    for number in range(10):
        feature = document.addObject("Part::Feature", f"Plate{number}")
        feature.Shape = Part.makeBox(40, 30, 2 + number)
        for copy in range(10):
            link = document.addObject("App::Link", f"Link{number}_{copy}")
            link.LinkedObject = feature
            link.Placement = App.Placement(V(50 * number, 40 * copy, 0), App.Rotation(V(0, 0, 1), 9 * copy))
            container.addObject(link)
        feature.ViewObject.Visibility = False
    document.recompute()


def test_an_assembly_of_100_solids(document):
    _assembly(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    parts = parts_of(thickness)
    assert [len(part.matrices) for part in parts] == [10] * 10
    bounds = document.getObject("Link3_7").getSubObject("", retType=0).BoundBox
    part = next(part for part in parts
                if part.record["descriptors"]["thickness_mm"]["min"] == pytest.approx(5.0))
    corners = part.map.points + part.map.origin
    placed = [(corners @ matrix[:3, :3].T + matrix[:3, 3]) for matrix in part.matrices]
    assert any(abs(each[:, 0].min() - bounds.XMin) < 1e-3 and abs(each[:, 1].max() - bounds.YMax) < 1e-3
               for each in placed)
    table = window.widget("ThinPart_PartTable")
    assert len(table.rows) == 10 and "100 instances" in window.text("ThinPart_PartLabel")
    table.sortByColumn(2, QtCore.Qt.AscendingOrder)
    window.settle(200)
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(1, 0)).center())
    window.settle(50)
    assert "Thinnest wall 3" in window.text("ThinPart_Walls")
    assert len(window.widget("ThinPart_FaceTable").rows) == 6
    assert Gui.Selection.getSelectionEx("", 0)[0].ObjectName == "Assembly"
    assert list(thickness.ViewObject.Proxy.colours.faces) == [1]
    window.click("ThinPart_AllParts")
    assert "100 instances" in window.text("ThinPart_PartLabel")
    assert thickness.ViewObject.Proxy.colours.faces is None


def test_the_window_has_its_turn_while_a_map_is_made(document):
    """Of a solid of 100,000 triangles."""
    window.add(document, "Shell", Part.makeSphere(50).cut(Part.makeSphere(46)).cut(Part.makeBox(100, 100, 100)))
    with window.Turns() as turns:
        window.show_thickness()
    assert turns.count > 20
    thickness, = thickness_objects(document)
    assert len(parts_of(thickness)) == 1
