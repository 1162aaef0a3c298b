# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies and several documents: what the list and the view show, and what happens to what is running."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from thickness_window import look_at, view_of

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.front_document import bring_to_front
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.document.active_task import open_session
from thinpart_workbench.gui.view3d import facet_nodes, view_provider
from thinpart_workbench.gui.view3d.facet_nodes import FacetNodes


@pytest.fixture
def assembly(document):
    """As FreeCAD imports a STEP file in which products have names and solids have none."""
    container = document.addObject("App::Part", "Frame")
    for number, name in enumerate(("Bracket", "Cover")):
        product = document.addObject("App::Part", name)
        solid = window.add(document, f"Solid{number}", Part.makeBox(40, 30, 2 + number, window.V(60 * number, 0, 0)))
        solid.Label = f"NONE00{number + 1}"
        product.addObject(solid)
        container.addObject(product)
    document.recompute()
    return document


def test_the_list_has_the_names_of_the_tree_and_shows_where_a_part_is(assembly):
    window.classify()
    window.wait_until(lambda: not window.is_shown("ThinPart_Progress"))
    table = window.widget("ThinPart_PartTable")
    assert [row.label for row in table.rows] == ["Bracket", "Cover"]
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(1, 0)).center())
    selected, = Gui.Selection.getSelectionEx(assembly.Name, 0)
    assert (selected.ObjectName, selected.SubElementNames) == ("Frame", ("Cover.Solid1.",))


def test_colours_are_not_below_a_map(document):
    feature = window.add_ribbed_block(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    assert thickness.ViewObject.Visibility
    before = set(window.rgb(feature))
    window.classify()
    assert set(window.rgb(feature)) != before and not thickness.ViewObject.Visibility
    message = Gui.getMainWindow().statusBar().currentMessage()
    assert "thickness map is hidden" in message
    window.wait_until(lambda: feature.ViewObject.SwitchNode.whichChild.getValue() != -1)


def test_the_part_is_drawn_until_its_map_is_complete(document, monkeypatch):
    feature = window.add_ribbed_block(document)
    for number in range(5):
        window.add(document, f"Plate{number}", Part.makeBox(40, 30, 2 + number, window.V(0, 100 + 50 * number, 0)))
    monkeypatch.setattr(facet_nodes, "_AT_ONCE", 1)
    monkeypatch.setattr(view_provider, "_BATCH_INTERVAL", 150)
    seen, show_more = [], FacetNodes.show_more

    def is_drawn():
        """Itself, or the first colours in its place."""
        first = lifelong.map_events.first_colours.get(document.Name)
        return feature.ViewObject.SwitchNode.whichChild.getValue() != -1 or (
            first is not None and first.is_shown and feature.Name in first.covered)

    def watch(nodes):
        seen.append((nodes.withheld > 0, is_drawn()))
        return show_more(nodes)

    monkeypatch.setattr(FacetNodes, "show_more", watch)
    window.show_thickness()
    window.settle(1500)
    assert len(seen) > 3 and all(drawn for is_withheld, drawn in seen if is_withheld)
    window.wait_until(lambda: feature.ViewObject.SwitchNode.whichChild.getValue() == -1
                      and document.Name not in lifelong.map_events.first_colours)


def test_the_panel_follows_to_the_map_of_the_document_in_front_and_flies_there(document):
    maps = {}
    for name, thickness in (("Plate", 4), ("Lid", 9)):
        each = document if name == "Plate" else App.newDocument("Other")
        window.add(each, name, Part.makeBox(40, 30, thickness))
        window.show_thickness()
        maps[each], = thickness_objects(each)
    other = App.getDocument("Other")
    for each in (document, other, document):
        bring_to_front(each)
        window.wait_until(lambda shown=maps[each]: open_session() and open_session().shown == shown)
        window.wait_until(lambda: window.is_shown("ThinPart_FlyButton"))
        camera = look_at(each).getCamera()
        window.click("ThinPart_FlyButton")
        view = view_of(each)
        window.wait_until(lambda view=view, before=camera: view.getCamera() != before)
    App.setActiveDocument(other.Name)  # before the panel has followed
    window.click("ThinPart_FlyButton")
    assert App.ActiveDocument == document


def test_a_panel_says_which_other_document_it_is_about(document):
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.is_shown("ThinPart_Message"))
    other = App.newDocument("Other")
    window.wait_until(lambda: "'Test'" in window.text("ThinPart_Elsewhere"))
    assert not window.is_shown("ThinPart_Message") and not window.is_shown("ThinPart_Panel")
    window.click("ThinPart_GoThere")
    window.wait_until(lambda: window.is_shown("ThinPart_Message"))
    assert App.ActiveDocument == document and not window.is_shown("ThinPart_Elsewhere")
    shown = Gui.getMainWindow().findChild(QtWidgets.QMdiArea).activeSubWindow()
    assert shown.windowTitle().startswith("Test")
    bring_to_front(other)
    window.wait_until(lambda: window.is_shown("ThinPart_Elsewhere"))
    App.closeDocument(other.Name)
    window.wait_until(lambda: window.is_shown("ThinPart_Message"))


@pytest.mark.parametrize("answer", ["Stay", "Stop"])
def test_a_running_measurement_is_asked_about(document, answer):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.is_shown("ThinPart_Progress"))
    other = App.newDocument("Other")
    window.add(other, "Plate", Part.makeBox(100, 100, 2))
    asked = []

    def act(box):
        asked.append(box.text())
        window.click(f"ThinPart_Running{answer}")

    window.answer("ThinPart_RunningQuestion", act)
    window.press("ThinPart_Classify")
    assert asked == ["'Test' is still being measured."]
    assert open_session().document_name == ("Test" if answer == "Stay" else "Other")
    assert open_session().is_running or answer == "Stop"
