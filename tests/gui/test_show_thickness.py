# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button 'Show thickness': what it measures, cancelling, undo, and maps that are there already."""

import os
import signal
import tempfile
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from window_actions import V

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.freecad_adapter.objects.snapshot import write_snapshot
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.gui.commands import COMMANDS
from thinpart_workbench.gui.processes import snapshot_job
from thinpart_workbench.gui.thickness.command import is_measuring_again
from thinpart_workbench.gui.view3d.picking import add_probe


def _body(document):
    body = document.addObject("PartDesign::Body", "Body")
    box = document.addObject("PartDesign::AdditiveBox", "Block")
    box.Length, box.Width, box.Height = 40, 30, 4
    body.addObject(box)
    return [1]


def _link_array(document):
    feature = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    link = document.addObject("App::Link", "Row")
    link.LinkedObject, link.ElementCount = feature, 3
    document.recompute()
    for number, element in enumerate(link.ElementList):
        element.Placement.Base = V(0, 0, 20 * number)
    feature.ViewObject.Visibility = False
    return [3]


def _container(document):
    outer = document.addObject("App::Part", "Assembly")
    inner = document.addObject("App::Part", "Group")
    inner.Placement.Base = V(100, 0, 0)
    outer.addObject(inner)
    inner.addObject(window.add(document, "Plate", Part.makeBox(40, 30, 4)))
    return [1]


def _mesh(document):
    import Mesh

    document.addObject("Mesh::Feature", "Soup").Mesh = Mesh.createBox(40, 30, 4)
    return [1]


def _compound(document):
    window.add(document, "Both", Part.makeCompound(
        [Part.makeBox(40, 30, 4), Part.makeBox(40, 30, 9, V(0, 0, 20))]))
    return [1, 1]


def _other_document(document):
    other = App.newDocument("Other")
    plate = window.add(other, "Plate", Part.makeBox(40, 30, 4))
    folder = Path(tempfile.mkdtemp(prefix="gui-test-"))
    other.saveAs(str(folder / "other.FCStd"))
    document.saveAs(str(folder / "this.FCStd"))
    App.setActiveDocument(document.Name)
    for number in range(2):
        link = document.addObject("App::Link", f"Link{number}")
        link.LinkedObject = plate
        link.Placement = App.Placement(V(0, 0, 50 * number), App.Rotation(V(1, 0, 0), 30))
    return [2]


@pytest.mark.parametrize("make", [_body, _link_array, _container, _mesh, _compound, _other_document])
def test_every_kind_of_object(document, make):
    places = make(document)
    document.recompute()
    window.show_thickness()
    thickness, = thickness_objects(document)
    parts = parts_of(thickness)
    assert [len(part.matrices) for part in parts] == places
    assert parts[0].map.thickness.min() == pytest.approx(4.0, abs=1e-3)
    assert "Thinnest wall 4" in window.text("ThinPart_Walls")
    assert not thickness.Stale and document.UndoNames[0] == "Show thickness"


def test_a_link_array_is_coloured_where_its_copies_stand(document):
    _link_array(document)
    window.show_thickness()
    part, = parts_of(thickness_objects(document)[0])
    assert sorted(matrix[2, 3] for matrix in part.matrices) == [0, 20, 40]


def test_what_is_selected_is_measured_alone(document):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.add(document, "Lid", Part.makeBox(40, 30, 9))
    Gui.Selection.addSelection(document.Name, "Lid", "Face1")
    window.show_thickness()
    thickness, = thickness_objects(document)
    assert [source.Name for source in thickness.Sources] == ["Lid"]
    assert window.text("ThinPart_PartLabel") == "Lid"


def test_undo_takes_the_map_and_the_panel_away_and_redo_brings_the_map_back(document):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    Gui.runCommand("Std_Undo")
    window.settle(100)
    assert thickness_objects(document) == [] and not Gui.Control.activeDialog()
    assert document.getObject("Plate").ViewObject.Visibility
    Gui.runCommand("Std_Redo")
    window.settle(100)
    thickness, = thickness_objects(document)
    assert parts_of(thickness)[0].map.count > 0


def test_a_second_press_measures_again_into_the_same_map(document):
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    thickness.ColourMap = "magma"
    plate.Shape = Part.makeBox(40, 30, 7)
    document.recompute()
    Gui.Selection.clearSelection()
    window.show_thickness()
    assert [each.Name for each in thickness_objects(document)] == [thickness.Name]
    assert parts_of(thickness)[0].map.thickness.min() == pytest.approx(7.0, abs=1e-3)
    assert thickness.ColourMap == "magma" and not thickness.Stale


def test_the_map_that_is_asked_for_is_seen_alone_in_its_place(document):
    """Also where 'Classify' has hidden it, and where the user has shown its part again."""
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    lid = window.add(document, "Lid", Part.makeBox(40, 30, 9, V(0, 40, 0)))
    window.show_thickness()
    both, = thickness_objects(document)
    for visible in (False, True):
        plate.ViewObject.Visibility = visible
    both.ViewObject.Visibility = False
    window.mouse_click(window.close_button())
    window.show_thickness()
    assert thickness_objects(document) == [both] and both.ViewObject.Visibility
    window.wait_until(lambda: not is_drawn(plate) and not is_drawn(lid))
    for visible in (False, True):
        plate.ViewObject.Visibility = visible
    window.settle(50)
    assert is_drawn(plate)
    Gui.Selection.addSelection(plate)
    window.show_thickness()
    of_plate = thickness_objects(document)[1]
    assert of_plate.ViewObject.Visibility and not both.ViewObject.Visibility
    window.wait_until(lambda: not is_drawn(plate) and is_drawn(lid))
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(both)
    window.show_thickness()
    assert both.ViewObject.Visibility and not of_plate.ViewObject.Visibility
    window.wait_until(lambda: not is_drawn(plate) and not is_drawn(lid))


def is_drawn(feature):
    """Whether an object itself is in the view, and not covered by a map."""
    return feature.ViewObject.SwitchNode.whichChild.getValue() != -1


def test_a_selected_map_is_shown_without_measuring(document):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    window.mouse_click(window.close_button())
    window.settle(50)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(thickness)
    window.show_thickness()
    assert window.workers() == [] and window.is_shown("ThinPart_ThicknessVerdict")


def test_a_saved_map_is_there_again_and_opens_with_a_double_click(document, tmp_path):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    document.saveAs(str(tmp_path / "plate.FCStd"))
    Gui.runCommand("Std_Save")
    window.show_thickness()
    window.wait_until(lambda: "plate.FCStd.thinpart.json" in window.text("ThinPart_InfoText"))
    document.save()
    App.closeDocument(document.Name)
    window.settle(50)
    again = App.openDocument(str(tmp_path / "plate.FCStd"))
    window.settle(50)
    thickness, = thickness_objects(again)
    assert thickness.ViewObject.Proxy.doubleClicked(thickness.ViewObject)
    window.settle(50)
    assert "Thinnest wall 4" in window.text("ThinPart_Walls") and window.workers() == []
    assert not thickness.Stale


def test_a_changed_part_makes_the_map_stale_and_recomputing_it_measures_again(document):
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    plate.Shape = Part.makeBox(40, 30, 7)
    document.recompute()
    window.settle(100)
    assert thickness.Stale and "has changed" in window.text("ThinPart_Stale")
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: "Thinnest wall 7" in window.text("ThinPart_Walls"))
    assert not thickness.Stale and not window.text("ThinPart_Stale")
    window.mouse_click(window.close_button())
    plate.Shape = Part.makeBox(40, 30, 5)
    document.recompute()
    window.settle(50)
    assert thickness.Stale
    thickness.touch()
    document.recompute()
    window.wait_until(lambda: is_measuring_again() or not thickness.Stale)
    window.wait_until(lambda: not is_measuring_again())
    assert not thickness.Stale
    assert parts_of(thickness)[0].map.thickness.min() == pytest.approx(5.0, abs=1e-3)


def test_moving_what_has_changed_measures_nothing_unasked(document):
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    window.mouse_click(window.close_button())
    thickness, = thickness_objects(document)
    plate.Shape = Part.makeBox(40, 30, 7)
    document.recompute()
    window.settle(100)
    for x in (10, 20):
        plate.Placement.Base.x = x
        document.recompute()
        window.settle(100)
        assert thickness.Stale and not is_measuring_again() and window.workers() == []


def test_measuring_again_takes_new_copies_for_sources_too(document):
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = plate
    link.Placement.Base.x = 100
    plate.Shape = Part.makeBox(40, 30, 7)
    document.recompute()
    window.settle(100)
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: "Thinnest wall 7" in window.text("ThinPart_Walls"))
    assert {each.Name for each in thickness.Sources} == {"Plate", "Copy"}
    assert len(parts_of(thickness)[0].matrices) == 2 and not thickness.Stale
    link.Placement.Base.x = 130
    document.recompute()
    window.settle(100)
    assert thickness.Stale


def test_probes_that_the_surface_has_left_are_told_of(document):
    plate = window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.show_thickness()
    thickness, = thickness_objects(document)
    add_probe(thickness, (20, 15, 4), (20, 15, 0), 4.0)
    plate.Shape = Part.makeBox(40, 30, 7)
    document.recompute()
    window.settle(100)
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: "1 probe was removed" in window.text("ThinPart_Message"))
    assert not thickness.ProbeValues


def test_a_full_disk_is_told_and_leaves_nothing_behind(document, monkeypatch):
    """A disk that is full cannot be had in a test."""
    def write(*_):
        raise RuntimeError("Writing of BREP failed")  # FreeCAD has a class of its own for it

    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    folders = _temporary_folders()
    with monkeypatch.context() as patch:
        patch.setattr(snapshot_job, "write_snapshot", write)
        window.press("ThinPart_ShowThickness")
        window.wait_until(lambda: "Temporary files cannot be written" in window.text("ThinPart_Message"))
    assert window.workers() == [] and _temporary_folders() == folders
    window.click("ThinPart_AgainButton")
    window.wait_until(window.is_thickness_told)
    assert len(thickness_objects(document)) == 1


def test_a_disk_that_is_full_in_the_middle_of_the_snapshot_ends_the_run(document, monkeypatch):
    """The shapes that a part was made from are written while it is measured."""
    def write(*arguments):
        list(write_snapshot(*arguments))

        def steps():
            yield "the first shape"
            raise RuntimeError("Writing of BREP failed")

        return steps()

    window.add(document, "Sieve", window.slow_shape())
    folders = _temporary_folders()
    with monkeypatch.context() as patch:
        patch.setattr(snapshot_job, "write_snapshot", write)
        window.press("ThinPart_ShowThickness")
        window.wait_until(lambda: "files cannot be written (FreeCAD cannot write them)" in window.text("ThinPart_Message"))
    window.wait_until(lambda: window.workers() == [])
    assert _temporary_folders() == folders and thickness_objects(document) == []


def test_cancel_half_way_leaves_nothing_behind(document):
    window.add(document, "Sieve", window.slow_shape())
    folders = _temporary_folders()
    window.press("ThinPart_ShowThickness")
    window.wait_until(lambda: window.widget("ThinPart_ProgressBar").value() > 0)
    window.click("ThinPart_CancelButton")
    assert window.text("ThinPart_Message").startswith("Cancelled")
    window.wait_until(lambda: window.workers() == [])
    assert _temporary_folders() == folders
    assert thickness_objects(document) == [] and "Show thickness" not in document.UndoNames


def test_a_part_that_fails_is_named_and_the_others_are_shown(document):
    import Mesh

    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    flat = document.addObject("Mesh::Feature", "Flat")
    flat.Mesh = Mesh.Mesh([(V(0, 0, 0), V(1, 0, 0), V(0, 1, 0)), (V(0, 0, 0), V(0, 1, 0), V(1, 0, 0))])
    window.show_thickness()
    assert "Flat" in window.text("ThinPart_Message")
    thickness, = thickness_objects(document)
    assert [part.record["name"] for part in parts_of(thickness)] == ["Plate"]


def test_a_worker_that_dies_is_one_sentence(document):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_ShowThickness")
    window.wait_until(window.workers)
    os.kill(window.workers()[0], signal.SIGKILL)
    window.wait_until(window.is_thickness_told)
    assert "ended unexpectedly" in window.text("ThinPart_Message")
    assert thickness_objects(document) == []


@pytest.mark.timeout(120)  # the part is measured to its end, by a process that leaves the processors to others
def test_a_part_that_is_deleted_meanwhile(document):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_ShowThickness")
    window.wait_until(window.workers)
    document.removeObject("Sieve")
    window.wait_until(window.is_thickness_told, seconds=110)
    assert "changed while it was measured" in window.text("ThinPart_Message")
    assert thickness_objects(document) == []


def test_closing_the_document_meanwhile(document):
    window.add(document, "Sieve", window.slow_shape())
    window.press("ThinPart_ShowThickness")
    window.wait_until(window.workers)
    App.closeDocument(document.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog() and window.workers() == [])


def test_another_document_in_front_meanwhile(document):
    window.add(document, "Plate", Part.makeBox(40, 30, 4))
    window.press("ThinPart_ShowThickness")
    other = App.newDocument("Other")
    window.wait_until(lambda: thickness_objects(document) and window.is_shown("ThinPart_Elsewhere"))
    assert len(thickness_objects(document)) == 1 and thickness_objects(other) == []
    window.add(other, "Lid", Part.makeBox(40, 30, 9))
    App.setActiveDocument(other.Name)
    window.show_thickness()
    assert "Thinnest wall 9" in window.text("ThinPart_Walls")
    App.closeDocument(document.Name)
    window.settle(50)
    assert window.is_shown("ThinPart_ThicknessVerdict"), "it is about the other document"
    App.closeDocument(other.Name)
    window.wait_until(lambda: not Gui.Control.activeDialog())


def test_without_a_document_it_cannot_be_pressed_and_says_why_when_called():
    assert not Gui.isCommandActive("ThinPart_ShowThickness")
    COMMANDS["ThinPart_ShowThickness"].Activated()
    window.settle(50)
    assert window.text("ThinPart_Message") == "There is no document: open or create one first."


def test_an_empty_document_is_said_to_be_empty(document):
    window.show_thickness()
    assert "is empty" in window.text("ThinPart_Message")
    assert not window.is_shown("ThinPart_FaceTable")


def _temporary_folders():
    return {each.name for each in Path(tempfile.gettempdir()).glob("thinpart-*")
            if not each.name.startswith("thinpart-gui-")}
