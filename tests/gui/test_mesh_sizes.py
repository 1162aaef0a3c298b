# SPDX-License-Identifier: LGPL-2.1-or-later
"""'Prepare mesh' in the window: walls with sizes, the estimate, Gmsh's mesh, and FEM's mesh object."""

import os
import shutil
from itertools import combinations

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from pivy import coin
from thickness_window import bar_of_document, look_at, picture, pixel, place_of
from window_actions import V

from thinpart_workbench.api.annotations import keep_mesh_settings, note_regions
from thinpart_workbench.core.rendering.colour_scale import ColourScale
from thinpart_workbench.freecad_adapter.preferences import set_preference_list
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.document.active_task import MESH_SIZES, end_session, open_session
from thinpart_workbench.storage.info.info_file import read_info

pytestmark = pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed")


def part(document):
    """A block with a thin fin, apart from the origin."""
    shape = Part.makeBox(50, 30, 15).fuse(Part.makeBox(50, 2, 12, V(0, 14, 15))).removeSplitter()
    feature = window.add(document, "Fin", shape)
    feature.Placement.Base = V(100, 0, 0)
    document.recompute()
    return feature


def open_panel():
    window.press("ThinPart_MeshSizes")
    window.wait_until(lambda: window.is_shown("ThinPart_MeshEstimate") or window.text("ThinPart_Message"))


def ask_for_layers():
    """Two layers of linear elements in thin walls, in place of an error that is aimed at."""
    estimate = window.text("ThinPart_MeshEstimate")
    window.widget("ThinPart_MeshOrder").setCurrentIndex(0)
    window.wait_until(lambda: window.text("ThinPart_MeshEstimate") != estimate)


def meshes(document):
    return [each for each in document.Objects if each.isDerivedFrom("Fem::FemMeshObject")]


def regions(document):
    return [each for each in document.Objects if hasattr(each, "ThinPartSizes") and hasattr(each, "References")]


def press_ok():
    session = open_session(MESH_SIZES)
    boxes = [each for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox) for each in box.buttons()
             if each.isVisible() and box.standardButton(each) == QtWidgets.QDialogButtonBox.Ok]
    assert session is not None and len(boxes) == 1
    boxes[0].click()


def test_ok_makes_the_fem_mesh_in_one_step_of_undo_and_again_updates_it(document):
    document.UndoMode = 1
    feature = part(document)
    open_panel()
    ask_for_layers()
    table = window.widget("ThinPart_WallSizes")
    assert [row["thickness"] for row in table.rows] == [pytest.approx(2.0, rel=0.02)]
    steps = document.UndoCount
    press_ok()
    window.wait_until(lambda: open_session() is None)
    assert document.UndoCount == steps + 1
    mesh, = meshes(document)
    assert mesh.FemMesh.VolumeCount > 1000
    region, = regions(document)
    assert region.CharacteristicLength.Value == pytest.approx(2.0 / 2.3, rel=0.02)
    (owner, names), = region.References
    fin = [owner.Shape.getElement(name).BoundBox for name in names]
    assert owner == feature and {round(box.YMin, 3) for box in fin} == {14.0, 16.0}
    xs = [point.x for point in mesh.FemMesh.Nodes.values()]
    assert (min(xs), max(xs)) == (pytest.approx(100.0), pytest.approx(150.0))  # where the part stands
    count = mesh.FemMesh.VolumeCount
    assert mesh.Visibility and not feature.Visibility  # both would flicker
    document.undo()
    assert meshes(document) == [] and regions(document) == [] and feature.Visibility
    document.redo()
    open_panel()
    ask_for_layers()
    window.edit_cell("ThinPart_WallSizes", 0, 1, "2.5")
    press_ok()
    window.wait_until(lambda: open_session() is None)
    mesh, = meshes(document)
    assert mesh.FemMesh.VolumeCount < 0.5 * count and len(regions(document)) == 1


def test_the_panel_always_says_what_it_is_doing(document):
    part(document)
    window.press("ThinPart_MeshSizes")
    seen = set()

    def is_proposed():
        shown = [name for name in ("ThinPart_Progress", "ThinPart_MeshEstimate") if window.is_shown(name)]
        assert open_session() is None or shown
        seen.update(window.text("ThinPart_Stage") if name == "ThinPart_Progress" else name for name in shown)
        return "ThinPart_MeshEstimate" in shown and "ThinPart_Progress" not in shown

    window.wait_until(lambda: window.is_shown("ThinPart_Progress"))
    window.wait_until(is_proposed)
    assert "Finding element sizes for Fin" in seen


def has_bar(document):
    """Whether the colour bar of a thickness map is in the view."""
    return not bar_of_document(document).isEmpty()


def test_colours_of_sizes_are_not_read_by_the_colour_bar_of_a_thickness_map(document):
    part(document)
    Gui.runCommand("Std_ViewFitAll")  # Coin leaves out a scene that is out of sight, and the bar with it
    window.show_thickness()
    window.wait_until(lambda: has_bar(document))
    Gui.Control.closeDialog()
    open_panel()
    window.wait_until(lambda: not has_bar(document))
    window.widget("ThinPart_SizePreview").setChecked(False)
    window.wait_until(lambda: has_bar(document))
    window.widget("ThinPart_SizePreview").setChecked(True)
    window.wait_until(lambda: not has_bar(document))
    end_session()
    window.wait_until(lambda: has_bar(document))


def aim():
    """The error that is aimed at; None where layers are chosen."""
    return window.widget("ThinPart_MeshAim").currentData()


def set_aim(text):
    """Choose a row of the errors by its text; whether there is one."""
    combo = window.widget("ThinPart_MeshAim")
    combo.setCurrentIndex(combo.findText(text))
    return combo.currentText() == text


def elements():
    """The sum of the walls' elements, as estimated."""
    return sum(row["elements"] or 0 for row in window.widget("ThinPart_WallSizes").rows)


def test_the_error_aimed_at_decides_the_sizes_and_a_smaller_one_takes_more_elements(document):
    part(document)
    open_panel()
    combo = window.widget("ThinPart_MeshAim")
    assert [combo.itemText(row) for row in range(combo.count())] == [
        "1\u00a0%", "2\u00a0%", "5\u00a0%", "10\u00a0%", "layers instead"]
    assert aim() == 0.02 and window.widget("ThinPart_MeshOrder").currentIndex() == 1
    assert "for an error of 2\u00a0% in deflections and frequencies" in window.text("ThinPart_MeshEstimate")
    found = {}
    for percent in (10, 5, 1):
        assert set_aim(f"{percent}\u00a0%")
        said = f"for an error of {percent}\u00a0% in"
        window.wait_until(lambda said=said: said in window.text("ThinPart_MeshEstimate"))
        found[percent] = elements()
    assert found[10] < found[5] < found[1]


def test_layers_the_order_and_the_error_go_together(document):
    part(document)
    open_panel()
    layers, order = window.widget("ThinPart_MeshLayers"), window.widget("ThinPart_MeshOrder")
    assert not layers.isEnabled()
    # Linear elements have no error that could be aimed at.
    ask_for_layers()
    assert aim() is None and layers.isEnabled() and layers.value() == 2.0
    table = window.widget("ThinPart_WallSizes")
    assert table.rows[0]["size"] == pytest.approx(2.0 / 2.3, rel=0.02)
    # An error is one of quadratic elements.
    assert set_aim("5\u00a0%")
    assert order.currentIndex() == 1 and aim() == 0.05 and not layers.isEnabled()
    window.wait_until(lambda: "for an error of 5\u00a0% in" in window.text("ThinPart_MeshEstimate"))
    # Quadratic elements may be asked for by layers too: one bends by itself.
    assert set_aim("layers instead")
    assert order.currentIndex() == 1 and layers.isEnabled() and layers.value() == 1.0
    window.wait_until(lambda: table.rows[0]["size"] == pytest.approx(2.0, rel=0.02))
    assert "error" not in window.text("ThinPart_MeshEstimate")
    order.setCurrentIndex(0)
    order.setCurrentIndex(1)
    assert aim() == 0.02 and not layers.isEnabled()


def test_a_mesh_that_few_computers_solve_is_said_first(document):
    window.add(document, "Sheet", Part.makeBox(300, 200, 2))
    open_panel()
    assert "more than most analyses need" not in window.text("ThinPart_MeshEstimate")
    assert set_aim("layers instead")
    window.widget("ThinPart_MeshLayers").setValue(3.0)
    window.wait_until(lambda: "more than most analyses need" in window.text("ThinPart_MeshEstimate"))
    estimate = window.text("ThinPart_MeshEstimate")
    assert estimate.startswith("About ") and estimate.index("nodes: more than most analyses need.") < 20
    assert "Set \"Most elements\", or fewer layers. A shell would take about" in estimate


def test_sizes_are_edited_and_the_estimate_follows(document):
    part(document)
    open_panel()
    ask_for_layers()
    table, before = window.widget("ThinPart_WallSizes"), window.text("ThinPart_MeshEstimate")
    window.edit_cell("ThinPart_WallSizes", 0, 2, "4")
    window.wait_until(lambda: window.text("ThinPart_MeshEstimate") != before)
    assert table.rows[0]["size"] == pytest.approx(2.0 / (1.15 * 4), rel=0.02)
    assert table.rows[0]["layers"] == pytest.approx(4.0)
    window.check_cell("ThinPart_WallSizes", 0, False)
    window.wait_until(lambda: table.rows[0]["size"] is None)
    assert table.rows[0]["elements"] is None


def combed(document):
    """A block with six equal fins."""
    shape = Part.makeBox(50, 62, 15)
    for number in range(6):
        shape = shape.fuse(Part.makeBox(50, 2, 12, V(0, 12 * number, 15)))
    return window.add(document, "Comb", shape.removeSplitter())


def test_equal_walls_are_one_row_with_one_switch_one_size_and_one_fem_region(document):
    feature = combed(document)
    open_panel()
    ask_for_layers()
    table = window.widget("ThinPart_WallSizes")
    rows = {row["kind"]: number for number, row in enumerate(table.rows)}
    at = rows["plate"]
    assert len(table.rows) == len(rows) and len(table.rows[at]["regions"]) == 6
    assert table.model().index(at, 0).data().startswith("6 \u00d7 plate")
    window.check_cell("ThinPart_WallSizes", at, False)
    window.wait_until(lambda: table.rows[at]["size"] is None)
    assert len(table.rows[at]["regions"]) == 6
    window.check_cell("ThinPart_WallSizes", at, True)
    window.wait_until(lambda: table.rows[at]["size"] is not None)
    window.edit_cell("ThinPart_WallSizes", at, 1, "2.5")
    window.wait_until(lambda: table.rows[at]["size"] == pytest.approx(2.5))
    assert len(table.rows[at]["regions"]) == 6
    press_ok()
    window.wait_until(lambda: open_session() is None)
    region, = (each for each in regions(document) if each.CharacteristicLength.Value == pytest.approx(2.5))
    (owner, names), = region.References
    sides = {round(owner.Shape.getElement(name).BoundBox.YMin) for name in names
             if owner.Shape.getElement(name).BoundBox.YLength < 1e-6}
    assert owner == feature and {12 * number + side for number in range(6) for side in (0, 2)} <= sides
    assert "6 \u00d7 plate" in region.Label


def test_what_a_limit_of_the_elements_costs_is_said(document):
    """A plate with a knife's edge, which takes most of the elements and gives way first."""
    outline = [V(0, 0, 0), V(2, 0, 0), V(2, 50, 0), V(0.05, 52, 0), V(0, 52, 0), V(0, 0, 0)]
    window.add(document, "Blade", Part.Face(Part.makePolygon(outline)).extrude(V(0, 0, 40)))
    open_panel()
    assert "limit" not in window.text("ThinPart_MeshEstimate")
    window.widget("ThinPart_MeshBudget").setValue(500)
    window.wait_until(lambda: "The limit costs accuracy: 2\u00a0% would take about" in window.text("ThinPart_MeshEstimate"))
    window.widget("ThinPart_MeshBudget").setValue(0)
    window.wait_until(lambda: "limit" not in window.text("ThinPart_MeshEstimate"))
    ask_for_layers()
    assert "costs layers" not in window.text("ThinPart_MeshEstimate")
    window.widget("ThinPart_MeshBudget").setValue(100_000)
    window.wait_until(lambda: "The limit costs layers: all walls would take about" in window.text("ThinPart_MeshEstimate"))
    assert "have fewer layers: they would take most of the elements." in window.text("ThinPart_MeshEstimate")
    window.widget("ThinPart_MeshBudget").setValue(5_000)
    window.wait_until(lambda: " instead of 2, which would take about" in window.text("ThinPart_MeshEstimate"))


def test_the_fem_regions_have_the_sizes_of_the_mesh_also_before_a_new_estimate(document):
    part(document)
    open_panel()
    ask_for_layers()
    window.edit_cell("ThinPart_WallSizes", 0, 1, "2.5")
    press_ok()  # at once: the estimate still says the former size
    window.wait_until(lambda: open_session() is None)
    region, = regions(document)
    assert region.CharacteristicLength.Value == pytest.approx(2.5) and "elements of 2.5" in region.Label


@pytest.mark.default_profile
def test_a_normal_part_has_one_size_until_a_wall_is_ticked(document, tmp_path):
    """A block with a groove that leaves a small thin wall."""
    shape = Part.makeBox(50, 40, 30).cut(Part.makeBox(6, 2, 3, V(20, 1, 27)))
    window.add(document, "Block", shape)
    open_panel()
    assert "A normal part" not in window.text("ThinPart_MeshEstimate")  # the error aimed at asks for sizes of all parts
    ask_for_layers()
    table = window.widget("ThinPart_WallSizes")
    assert [row["size"] for row in table.rows] == [None]
    assert window.text("ThinPart_MeshEstimate").startswith("A normal part: one size is enough.")
    assert not window.is_shown("ThinPart_SizeBar")
    # The colour of the largest size, not of the least.
    largest = tuple(ColourScale(1.0, 2.0).colours([2.0])[0])
    assert size_colours(document) == {largest}
    # Its sides are told apart by the light.
    seen = look_at(document)
    image = picture(seen, tmp_path)
    sides = [pixel(image, place_of(seen, point)) for point in (V(40, 20, 30), V(25, 0, 15), V(50, 20, 15))]
    shares = [sum(side) / sum(map(int, largest)) for side in sides]
    assert 0.68 < min(shares) and max(shares) < 1.01 and min(abs(a - b) for a, b in combinations(shares, 2)) > 0.04
    assert all(abs(part - share * whole) < 4 for side, share in zip(sides, shares)
               for part, whole in zip(side, map(int, largest)))
    window.check_cell("ThinPart_WallSizes", 0, True)
    window.wait_until(lambda: table.rows[0]["size"] is not None)
    assert table.rows[0]["size"] == pytest.approx(1.0 / 2.3, rel=0.02)
    assert not window.text("ThinPart_MeshEstimate").startswith("A normal part")
    window.wait_until(lambda: window.is_shown("ThinPart_SizeBar") and len(size_colours(document)) > 1)


def size_colours(document):
    """Colours on the part, red, green and blue: set of tuple."""
    search = coin.SoSearchAction()
    search.setType(coin.SoPackedColor.getClassTypeId())
    search.apply(Gui.getDocument(document.Name).activeView().getSceneGraph())
    values = search.getPath().getTail().orderedRGBA.getValues(0)
    return {(value >> 24 & 255, value >> 16 & 255, value >> 8 & 255) for value in map(int, values)}


def test_meshes_are_compared_and_nothing_of_the_panel_stays(document):
    part(document)
    open_panel()
    root = Gui.getDocument(document.Name).mdiViewsOfType("Gui::View3DInventor")[0].getSceneGraph()
    nodes = root.getNumChildren()
    window.click("ThinPart_MeshButton")
    window.wait_until(lambda: "As proposed:" in window.text("ThinPart_MeshFigures"))
    chart = window.widget("ThinPart_QualityChart")
    assert sum(chart.before) == pytest.approx(1.0) and sum(chart.after) == pytest.approx(1.0)
    folder = open_session().measured.folder
    assert os.path.isdir(folder)
    open_session().close()
    window.settle(50)
    assert not os.path.exists(folder) and root.getNumChildren() < nodes and meshes(document) == []


def test_cancel_half_way_changes_nothing_and_one_can_go_on(document):
    part(document)
    open_panel()
    window.click("ThinPart_MeshButton")
    window.click("ThinPart_CancelButton")
    assert "Cancelled" in window.text("ThinPart_Message") and meshes(document) == []
    window.wait_until(lambda: window.widget("ThinPart_MeshButton").isEnabled())
    window.click("ThinPart_MeshButton")
    window.wait_until(lambda: "As proposed:" in window.text("ThinPart_MeshFigures"))


def test_a_document_closed_while_gmsh_runs_leaves_nothing(document):
    part(document)
    open_panel()
    window.click("ThinPart_MeshButton")
    folder = open_session().measured.folder
    App.closeDocument(document.Name)
    window.settle(100)
    assert open_session() is None and not os.path.exists(folder)
    assert window.workers("size_worker") == []


def test_sizes_said_in_the_table_of_walls_are_taken_over(document, tmp_path):
    part(document)
    document.saveAs(str(tmp_path / "fin.FCStd"))
    window.classify()
    window.wait_until(lambda: (tmp_path / "fin.FCStd.thinpart.json").exists())
    record = open_session().measured.analysis.records
    region = next(iter(record.values()))["regions"]["listed"][0]
    note_regions(tmp_path / "fin.FCStd", [region], mesh_size_mm=1.25)
    end_session()
    open_panel()
    window.wait_until(lambda: window.widget("ThinPart_WallSizes").rows[0]["size"] == pytest.approx(1.25))


def test_several_solids_in_one_object_are_said(document):
    window.add(document, "Two", Part.makeCompound([Part.makeBox(20, 20, 1), Part.makeBox(30, 20, 1, V(50, 0, 0))]))
    window.answer("ThinPart_PartDialog", lambda dialog: dialog.accept())
    open_panel()
    assert "consists of 2 solids" in window.text("ThinPart_Message")


def test_without_gmsh_it_says_how_to_have_it(document, monkeypatch, tmp_path):
    broken = tmp_path / "gmsh"
    broken.write_text("#!/bin/sh\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    part(document)
    open_panel()
    assert "Meshing needs Gmsh: install it" in window.text("ThinPart_Message")
    press_ok()
    assert open_session() is not None and meshes(document) == []


@pytest.mark.timeout(180)  # the part is measured three times and meshed twice
def test_settings_that_worked_are_kept_with_the_part_and_offered_again(document, tmp_path):
    part(document)
    document.saveAs(str(tmp_path / "fin.FCStd"))
    info = tmp_path / "fin.FCStd.thinpart.json"
    window.classify()
    window.wait_until(info.exists)
    end_session()
    open_panel()
    ask_for_layers()
    window.widget("ThinPart_MeshLayers").setValue(1.0)
    table = window.widget("ThinPart_WallSizes")
    window.wait_until(lambda: table.rows[0]["layers"] == pytest.approx(1.0, rel=0.02))
    assert not window.is_shown("ThinPart_UseMeshSettings")
    window.edit_cell("ThinPart_WallSizes", 0, 1, "1.6")
    press_ok()
    window.wait_until(lambda: open_session() is None and not lifelong.requests.is_busy)
    meshed = read_info(info)["parts"][0]["meshed"]
    assert meshed["layers"] == 1.0 and meshed["elements"] == meshes(document)[0].FemMesh.VolumeCount
    assert [(wall["size_mm"], wall["is_changed"]) for wall in meshed["walls"]] == [(1.6, True)]
    open_panel()
    window.wait_until(lambda: window.is_shown("ThinPart_UseMeshSettings"))
    assert "Settings that worked for this part: layers: 1" in window.text("ThinPart_MeshOffer")
    assert aim() == 0.02
    window.click("ThinPart_UseMeshSettings")
    table = window.widget("ThinPart_WallSizes")
    window.wait_until(lambda: table.rows[0]["size"] == pytest.approx(1.6))
    assert window.widget("ThinPart_MeshLayers").value() == 1.0 and aim() is None
    assert window.widget("ThinPart_MeshOrder").currentIndex() == 0
    assert not window.is_shown("ThinPart_UseMeshSettings")


@pytest.mark.timeout(180)  # the part is measured three times and meshed twice
def test_settings_kept_with_an_error_are_offered_with_it(document, tmp_path):
    part(document)
    document.saveAs(str(tmp_path / "fin.FCStd"))
    info = tmp_path / "fin.FCStd.thinpart.json"
    window.classify()
    window.wait_until(info.exists)
    end_session()
    open_panel()
    assert set_aim("5\u00a0%")
    press_ok()
    window.wait_until(lambda: open_session() is None and not lifelong.requests.is_busy)
    meshed = read_info(info)["parts"][0]["meshed"]
    assert (meshed["error"], meshed["layers"], meshed["order"]) == (0.05, None, 2)
    assert meshed["elements"] == meshes(document)[0].FemMesh.VolumeCount
    open_panel()
    window.wait_until(lambda: window.is_shown("ThinPart_UseMeshSettings"))
    assert "Settings that worked for this part: error aimed at: 5\u00a0%" in window.text("ThinPart_MeshOffer")
    assert aim() == 0.02
    window.click("ThinPart_UseMeshSettings")
    window.wait_until(lambda: "for an error of 5\u00a0% in" in window.text("ThinPart_MeshEstimate"))
    assert aim() == 0.05 and not window.widget("ThinPart_MeshLayers").isEnabled()


@pytest.mark.timeout(120)  # the part is measured twice, and a library is read
def test_settings_of_a_part_alike_in_a_library_are_offered(document, tmp_path):
    part(document)
    document.saveAs(str(tmp_path / "fin.FCStd"))
    info = tmp_path / "fin.FCStd.thinpart.json"
    window.classify()
    window.wait_until(info.exists)
    end_session()
    rows = [{"kind": "plate", "thickness": 2.0, "size": None, "is_changed": False}]
    figures = {"elements": 4321, "poor_share": 0.0, "gamma_least": 0.2, "layers_share": 0.9, "tries": []}
    settings = {"order": 2, "layers": None, "growth": 1.5, "size": None, "budget": None}
    keep_mesh_settings(info, None, settings, 6.0, 60.0, rows, figures)
    (tmp_path / "library").mkdir()
    for file in (tmp_path / "fin.FCStd", info):
        shutil.move(str(file), str(tmp_path / "library" / file.name))
    set_preference_list("Libraries", [str(tmp_path / "library")])
    try:
        open_panel()
        window.wait_until(lambda: window.is_shown("ThinPart_UseMeshSettings"))
        assert "Settings that worked for Fin (" in window.text("ThinPart_MeshOffer")
        assert "4321" in window.text("ThinPart_MeshOffer").replace(",", "").replace(" ", "")
        window.click("ThinPart_UseMeshSettings")
        assert window.widget("ThinPart_MeshOrder").currentIndex() == 1
        assert window.widget("ThinPart_MeshGrowth").value() == 1.5
    finally:
        set_preference_list("Libraries", [])
