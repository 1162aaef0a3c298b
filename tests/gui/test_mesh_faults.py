# SPDX-License-Identifier: LGPL-2.1-or-later
"""'Prepare mesh' in the window where something is wrong or changes: disks, Gmsh, FEM, links, assemblies, views, units."""

import os
import resource
import shutil
import sys

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from pivy import coin
from test_shell_in_panel import angle, choose_shell, meshes, middles, open_panel, press_ok, thicknesses
from window_actions import V

from thinpart_workbench.gui.application.length_unit import PREFERENCES
from thinpart_workbench.gui.document.active_task import open_session

pytestmark = [pytest.mark.skipif(shutil.which("gmsh") is None, reason="gmsh is not installed"),
              pytest.mark.timeout(240)]  # each measures a part, most mesh it, some do both twice

INCHES = 3


def fake_gmsh(monkeypatch, folder, then):
    """A Gmsh that is there, and does something else than meshing."""
    program = folder / "gmsh"
    program.write_text(f"#!/bin/sh\nif [ \"$1\" = --version ]; then echo 4.8.4; exit 0; fi\n{then}\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")


def nothing_was_made(document):
    return meshes(document) == middles(document) == thicknesses(document) == []


@pytest.mark.parametrize("kind", [0, 1])
def test_a_crash_of_gmsh_is_said_and_nothing_is_changed(document, monkeypatch, tmp_path, kind):
    fake_gmsh(monkeypatch, tmp_path, "kill -SEGV $$")
    angle(document)
    open_panel()
    window.widget("ThinPart_MeshKind").setCurrentIndex(kind)
    press_ok()
    assert "Gmsh crashed" in window.text("ThinPart_Message") and nothing_was_made(document)
    button = window.widget("ThinPart_ShellButton" if kind else "ThinPart_MeshButton")
    assert button.isEnabled()  # with another size, it may work


@pytest.mark.parametrize("kind", [0, 1])
def test_a_full_disk_is_said_and_one_can_go_on_when_there_is_room(document, kind):
    angle(document)
    open_panel()
    window.widget("ThinPart_MeshLayers").setValue(1.0)
    window.widget("ThinPart_MeshKind").setCurrentIndex(kind)
    worker, = window.workers("size_worker")
    limits = resource.prlimit(worker, resource.RLIMIT_FSIZE)
    resource.prlimit(worker, resource.RLIMIT_FSIZE, (500, limits[1]))  # no file may grow beyond that
    press_ok()
    message = window.text("ThinPart_Message")
    assert message.startswith("Temporary files cannot be written (") and "free some disk space" in message
    assert nothing_was_made(document)
    resource.prlimit(worker, resource.RLIMIT_FSIZE, limits)
    press_ok_again()
    assert len(meshes(document)) == 1


def press_ok_again():
    press_ok()
    window.wait_until(lambda: open_session() is None, "the panel closes")


def test_without_the_fem_workbench_it_is_said_what_to_install(document, monkeypatch):
    # This FreeCAD has it, so it is hidden.
    monkeypatch.setitem(sys.modules, "ObjectsFem", None)
    angle(document)
    open_panel()
    choose_shell()
    assert "This FreeCAD has no FEM workbench" in window.text("ThinPart_Message")
    window.wait_until(lambda: window.is_shown("ThinPart_ShellButton"))
    window.click("ThinPart_ShellButton")  # what the shell would be can be seen all the same
    window.wait_until(lambda: "triangles of up to" in window.text("ThinPart_ShellFigures"))
    press_ok()
    assert "no FEM workbench" in window.text("ThinPart_Message") and nothing_was_made(document)


def test_what_has_no_shell_is_refused_in_one_sentence_and_advised_as_a_solid(document):
    plates = [Part.makeBox(60, 40, 2, V(0, 0, 20 * number)) for number in range(2)]
    posts = [Part.makeBox(6, 6, 18, V(x, y, 2)) for x in (0, 54) for y in (0, 34)]
    window.add(document, "Stack", plates[0].fuse([plates[1], *posts]).removeSplitter())
    open_panel()
    choose_shell()
    press_ok()
    message = window.text("ThinPart_Message")
    assert "Mesh it as a solid" in message or "mesh it as a solid" in message
    window.wait_until(lambda: window.text("ThinPart_MeshAdvice").startswith("Recommended: solid."))
    assert message in window.text("ThinPart_MeshAdvice") and nothing_was_made(document)


def test_cancel_half_way_leaves_no_shell_and_one_can_go_on(document):
    angle(document)
    open_panel()
    choose_shell()
    window.click("ThinPart_ShellButton")
    window.click("ThinPart_CancelButton")
    assert "Cancelled" in window.text("ThinPart_Message") and nothing_was_made(document)
    window.wait_until(lambda: window.widget("ThinPart_ShellButton").isEnabled())
    press_ok_again()
    assert len(meshes(document)) == 1


def test_a_document_closed_while_a_shell_is_made_leaves_nothing(document):
    angle(document)
    open_panel()
    choose_shell()
    window.click("ThinPart_ShellButton")
    folder = open_session().measured.folder
    App.closeDocument(document.Name)
    window.settle(100)
    assert open_session() is None and not os.path.exists(folder) and window.workers("size_worker") == []


def test_the_shell_of_a_link_is_that_of_its_object_and_seen_where_the_link_is(document):
    feature = angle(document)
    link = document.addObject("App::Link", "Copy")
    link.LinkedObject = feature
    link.Placement = App.Placement(V(0, 500, 0), App.Rotation())
    feature.Visibility = False
    document.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(link)
    open_panel()
    low, high = drawn_box(Gui.getDocument(document.Name).ActiveView)
    assert (low[1], high[1]) == (pytest.approx(500.0), pytest.approx(540.0))
    choose_shell()
    press_ok_again()
    middle, = middles(document)
    assert middle.ThinPartShellOf == feature and middle.Shape.BoundBox.YMax == pytest.approx(40.0)


def test_the_shell_of_a_part_in_an_assembly_is_seen_where_it_stands(document):
    feature = angle(document)
    assembly = document.addObject("App::Part", "Assembly")
    assembly.addObject(feature)
    assembly.Placement = App.Placement(V(0, 0, 300), App.Rotation())
    document.recompute()
    open_panel()
    choose_shell()
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: "triangles of up to" in window.text("ThinPart_ShellFigures"))
    low, high = drawn_box(Gui.getDocument(document.Name).ActiveView)
    assert (low[2], high[2]) == (pytest.approx(301.0, abs=1e-3), pytest.approx(330.0, abs=1e-3))
    press_ok_again()
    middle, = middles(document)
    assert middle.Shape.BoundBox.ZMin == pytest.approx(1.0)  # FEM meshes a part in its own coordinates


def test_second_order_reaches_the_mesh_of_fem(document):
    angle(document)
    open_panel()
    window.widget("ThinPart_MeshOrder").setCurrentIndex(1)
    press_ok_again()
    mesh, = meshes(document)
    assert mesh.ElementOrder == "2nd"
    assert {len(mesh.FemMesh.getElementNodes(each)) for each in mesh.FemMesh.Volumes} == {10}


@pytest.fixture
def inches():
    """Chooses inches as FreeCAD's preferences do."""
    group = App.ParamGet(PREFERENCES)
    former = group.GetInt("UserSchema", 0), App.Units.getSchema()

    def choose(document):
        group.SetInt("UserSchema", INCHES)
        App.Units.setSchema(INCHES)
        if hasattr(document, "UnitSystem"):
            document.UnitSystem = document.getEnumerationsOfProperty("UnitSystem")[INCHES]

    yield choose
    group.SetInt("UserSchema", former[0])
    App.Units.setSchema(former[1])


def test_another_unit_system_is_followed_while_the_panel_is_open(document, inches):
    angle(document)
    open_panel()
    choose_shell()
    window.click("ThinPart_ShellButton")
    window.wait_until(lambda: "triangles of up to" in window.text("ThinPart_ShellFigures"))
    measured = open_session().measured
    inches(document)
    window.wait_until(lambda: "in" in window.widget("ThinPart_ShellBar").ticks[-1][1], "the bar is in inches")
    assert "mm" not in window.text("ThinPart_ShellFigures")
    table = window.widget("ThinPart_ShellWalls")
    assert [float(table.model().index(row, 1).data()) for row in range(2)] == [
        pytest.approx(2 / 25.4, rel=0.01), pytest.approx(4 / 25.4, rel=0.01)]
    assert measured is open_session().measured
    window.widget("ThinPart_MeshKind").setCurrentIndex(0)
    assert "0.307\u00a0in" in window.text("ThinPart_MeshEstimate")
    choose_shell()
    press_ok_again()
    assert sorted(each.Thickness.Value for each in thicknesses(document)) == [pytest.approx(2.0), pytest.approx(4.0)]


def test_sizes_and_shell_are_in_every_view_of_the_document_also_in_a_later_one(document):
    angle(document)
    open_panel()
    Gui.runCommand("Std_ViewCreate")
    shown = Gui.getDocument(document.Name)
    window.wait_until(lambda: len(shown.mdiViewsOfType("Gui::View3DInventor")) == 2)
    views = shown.mdiViewsOfType("Gui::View3DInventor")
    window.wait_until(lambda: [coloured(view) for view in views] == [1, 1], "both views show the sizes")
    assert window.is_shown("ThinPart_SizeBar")
    choose_shell()
    assert [coloured(view) for view in views] == [0, 0]
    open_session().close()
    window.settle(50)
    assert [coloured(view) for view in views] == [0, 0]


def _search(view):
    search = coin.SoSearchAction()
    search.setType(coin.SoPackedColor.getClassTypeId())
    search.setInterest(coin.SoSearchAction.ALL)
    search.apply(view.getSceneGraph())
    return search


def coloured(view):
    """How many surfaces with a colour for each corner a view has."""
    search = _search(view)
    return search.getPaths().getLength()


def drawn_box(view):
    """The least and greatest coordinates of the coloured surface in a view."""
    search = _search(view)
    assert search.getPaths().getLength() == 1
    path = search.getPaths()[0]
    box = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    box.apply(path.getNode(path.getLength() - 4))  # of the panel, with its transform
    found = box.getBoundingBox()
    return tuple(found.getMin().getValue()), tuple(found.getMax().getValue())
