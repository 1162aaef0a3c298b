"""Thickness of a whole assembly, and how the window and a person wait for it."""

import time

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


def test_the_window_never_waits_and_the_map_comes_soon(document):
    """A solid of 100,000 triangles. The figures are printed; what is asserted bears a busy machine."""
    window.add(document, "Warm", Part.makeBox(40, 30, 2))
    window.show_thickness()  # what is loaded at the first time is not what is measured here
    window.mouse_click(window.close_button())
    window.settle(50)
    for each in list(document.Objects):
        document.removeObject(each.Name)
    ball = Part.makeSphere(50).cut(Part.makeSphere(46)).cut(Part.makeBox(100, 100, 100))
    window.add(document, "Shell", ball)
    gaps, last, own = [], [time.monotonic()], [time.thread_time()]

    def tick():
        now, cpu = time.monotonic(), time.thread_time()
        gaps.append((now - last[0], cpu - own[0]))
        last[0], own[0] = now, cpu

    timer = QtCore.QTimer()
    timer.timeout.connect(tick)
    timer.start(5)
    begun = time.monotonic()
    window.show_thickness()
    taken = time.monotonic() - begun
    window.settle(300)
    timer.stop()
    thickness, = thickness_objects(document)
    part, = parts_of(thickness)
    seconds = part.record["seconds"]
    core = seconds["tessellate"] + seconds["measure"]
    print(f"{part.record['triangles']} triangles, {part.map.count} facets: {taken:.2f} s from the click, "
          f"{core:.2f} s tessellation and core, {taken / core:.2f} times; longest gap {max(gaps)[0]:.3f} s, "
          f"of which {max(cpu for _, cpu in gaps):.3f} s at most are the window's own work")
    assert max(cpu for _, cpu in gaps) < 0.4
    assert taken < 3.0 * core + 5.0
