# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which part is meant: selected, active, only, or asked for."""

from dataclasses import replace

import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from thickness_window import show_map
from window_actions import V

from thinpart_workbench.api.window.open_parts import parts_selected
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.length_unit import MILLIMETRE
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.document.selection import selected_paths
from thinpart_workbench.gui.record.parts_table import PartsTable, PartsTableRow

RED = (0.84, 0.15, 0.12)


@pytest.fixture
def two(document):
    """A document with a ribbed block and a plate."""
    window.add_ribbed_block(document)
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    return document


@pytest.mark.parametrize("path", ["", "Face2", "Edge1"])
def test_selected_object_face_or_edge(two, path):
    Gui.Selection.addSelection(two.Name, "Plate", path)
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Plate"


def test_source_of_a_cut_means_the_cut(document):
    box = window.add(document, "Stock", Part.makeBox(100, 60, 40))
    hole = window.add(document, "Hole", Part.makeCylinder(5, 40, V(50, 30, 0)))
    cut = document.addObject("Part::Cut", "Drilled")
    cut.Base, cut.Tool = box, hole
    document.recompute()
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    Gui.Selection.addSelection(document.Name, "Hole")
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Drilled"


@pytest.mark.parametrize("container", [None, "App::Part", "PartDesign::Body"])
def test_a_thickness_map_means_its_parts(two, container):
    part = two.getObject("Plate")
    if container == "PartDesign::Body":
        part = two.addObject(container, "Body")
        part.addObject(two.addObject("PartDesign::AdditiveBox", "Block"))
    elif container:
        two.addObject(container, "Assembly").addObject(part)
    two.recompute()
    made = show_map(two, part)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(made)
    meant, = parts_selected(two, selected_paths(two))
    assert meant.label == part.Label
    if container is None:
        window.classify()
        assert window.text("ThinPart_PartLabel") == "Plate" and not window.is_shown("ThinPart_Message")


def test_what_has_no_solid_is_said(two):
    sketch = two.addObject("Sketcher::SketchObject", "Sketch")
    two.recompute()
    Gui.Selection.addSelection(two.Name, sketch.Name)
    window.classify()
    assert window.text("ThinPart_Message").startswith("There is no closed solid in 'Sketch'")


def test_a_document_without_solids_is_said(document):
    window.add(document, "Line", Part.makeLine(V(0, 0, 0), V(1, 0, 0)))
    window.classify()
    assert "no closed solid in the document" in window.text("ThinPart_Message")


def test_the_active_body(two):
    body = two.addObject("PartDesign::Body", "Body")
    box = two.addObject("PartDesign::AdditiveBox", "Block")
    body.addObject(box)
    two.recompute()
    Gui.getDocument(two.Name).ActiveView.setActiveObject("pdbody", body)
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Body"


def test_without_a_selection_all_parts_are_measured_listed_and_coloured(two):
    window.classify()
    assert window.text("ThinPart_PartLabel") == "Ribbed"
    table = window.widget("ThinPart_PartTable")
    cells = [[table.model().index(row, column).data() for column in range(4)] for row in range(2)]
    assert cells == [["Ribbed", "thin features", "6", "1"], ["Plate", "thin", "2", "1"]]
    assert RED in window.rgb(two.getObject("Ribbed"))
    assert set(window.rgb(two.getObject("Plate"))) > {RED}


def test_a_click_in_the_list_shows_another_part(two):
    window.classify()
    table = window.widget("ThinPart_PartTable")
    window.settle(200)
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(1, 0)).center())
    assert window.text("ThinPart_PartLabel") == "Plate"
    assert window.text("ThinPart_Headline") == "Thin part" and window.is_shown("ThinPart_Legend")
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(0, 0)).center())
    assert window.text("ThinPart_PartLabel") == "Ribbed"


def test_the_parts_of_one_compound_keep_their_colours_beside_each_other(document):
    both = window.add(document, "Both", Part.makeCompound(
        [window.ribbed_shape(), Part.makeBox(100, 100, 2, V(0, 0, 200))]))
    window.classify()
    colours = window.rgb(both)
    ribbed = len(window.ribbed_shape().Faces)
    assert RED in colours[:ribbed] and RED in colours[ribbed:]


def test_a_part_that_fails_is_told_when_it_is_chosen(two):
    import Mesh

    flat = two.addObject("Mesh::Feature", "Flat")
    flat.Mesh = Mesh.Mesh([(V(0, 0, 0), V(1, 0, 0), V(0, 1, 0)), (V(0, 0, 0), V(0, 1, 0), V(1, 0, 0))])
    window.classify()
    table = window.widget("ThinPart_PartTable")
    window.settle(200)
    window.mouse_click(table.viewport(), table.visualRect(table.model().index(2, 0)).center())
    assert "encloses no volume" in window.text("ThinPart_Message")
    assert not window.is_shown("ThinPart_Headline")


def test_declining_to_choose_does_nothing(two):
    container = two.addObject("App::Part", "Assembly")
    container.addObjects(two.Objects[:2])
    two.recompute()
    Gui.Selection.addSelection(two.Name, "Assembly")
    window.answer("ThinPart_PartDialog", lambda dialog: dialog.reject())
    window.press("ThinPart_Classify")
    window.settle(100)
    assert not Gui.Control.activeDialog() and window.workers() == []


def test_a_container_of_several_asks_among_them(two):
    container = two.addObject("App::Part", "Assembly")
    container.addObject(two.getObject("Plate"))
    container.addObject(window.add(two, "Cube", Part.makeBox(10, 10, 10)))
    two.recompute()
    Gui.Selection.addSelection(two.Name, "Assembly")
    seen = []

    def choose(dialog):
        entries = dialog.findChild(QtWidgets.QListWidget)
        seen.extend(entries.item(row).text() for row in range(entries.count()))
        entries.itemDoubleClicked.emit(entries.item(0))

    window.answer("ThinPart_PartDialog", choose)
    window.classify()
    assert sorted(seen) == ["Cube", "Plate"]
    assert window.text("ThinPart_PartLabel") == seen[0]


def test_a_link_array_counts_its_copies(document):
    feature = window.add_ribbed_block(document)
    link = document.addObject("App::Link", "Row")
    link.LinkedObject = feature
    link.ElementCount = 3
    feature.ViewObject.Visibility = False
    document.recompute()
    window.classify()
    assert window.text("ThinPart_Headline") == "Part with thin features"


def test_columns_of_the_list_fit_what_becomes_known():
    table = PartsTable()
    table.resize(400, 100)
    table.show()
    waiting = [PartsTableRow("one", "One", 1), PartsTableRow("two", "Two", 1)]
    table.show_parts(waiting, load_profile("paper"), MILLIMETRE)
    failed = replace(waiting[1], failure={"kind": "unsupported", "message": "no solid"})
    table.show_parts([waiting[0], failed], load_profile("paper"), MILLIMETRE)
    assert table.columnWidth(1) >= table.sizeHintForColumn(1)
    table.hide()
    table.deleteLater()
