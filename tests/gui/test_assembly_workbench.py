# SPDX-License-Identifier: LGPL-2.1-or-later
"""Assemblies of FreeCAD's Assembly workbench in the window."""

import shutil

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
import window_actions as window
from made_assemblies import has_assembly_workbench, save_assembly
from thickness_window import look_at

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.storage.info.info_file import read_info

pytestmark = pytest.mark.skipif(not has_assembly_workbench(), reason="this FreeCAD has no Assembly workbench")


@pytest.fixture
def made(tmp_path):
    """The assembly, opened from its file."""
    made = save_assembly(tmp_path)
    for name in list(App.listDocuments()):
        App.closeDocument(name)
    App.openDocument(made.main)
    window.settle(100)
    return made


def main_document():
    return App.getDocument("Main")


def info_of(made):
    return read_info(made.main + ".thinpart.json")


def instances(made):
    return sorted(each["instances"] for each in info_of(made)["parts"])


def test_classifying_tells_each_part_once(made):
    window.classify()
    assert len(window.widget("ThinPart_PartTable").rows) == len(made.instances)
    assert window.text("ThinPart_Message") == ""
    window.mouse_click(window.close_button())
    assert instances(made) == sorted(made.instances.values())


def test_the_map_colours_the_parts_where_they_stand(made):
    document = main_document()
    look_at(document)
    window.show_thickness()
    thickness, = thickness_objects(document)
    parts = parts_of(thickness)
    assert sorted(len(part.matrices) for part in parts) == sorted(made.instances.values())
    shown, stand = _boxes(parts), _boxes_of_solids(document)
    assert len(stand) >= 18, "FreeCAD's shape has two that stand at one place once"
    assert np.allclose(sorted(set(shown)), sorted(stand), atol=0.011)


def _boxes(parts):
    """Corners of the box of every part at every place of a map, rounded."""
    found = []
    for part in parts:
        corners = part.map.points + part.map.origin
        for matrix in part.matrices:
            placed = corners @ matrix[:3, :3].T + matrix[:3, 3]
            found.append(tuple(np.round([*placed.min(axis=0), *placed.max(axis=0)], 2) + 0.0))
    return found


def _boxes_of_solids(document):
    """The same of every solid of the shape that FreeCAD itself has for the assembly."""
    import Part

    boxes = [each.BoundBox for each in Part.getShape(document.getObject("Machine")).Solids]
    return [tuple(round(each, 2) + 0.0 for each in (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax))
            for box in boxes]


def test_a_map_follows_a_part_that_is_moved(made):
    document = main_document()
    window.show_thickness()
    thickness, = thickness_objects(document)
    assert not thickness.Stale
    window.mouse_click(window.close_button())
    document.getObject("SecondPlate").Placement.Base = App.Vector(0.0, 500.0, 0.0)
    document.recompute()
    window.settle(100)
    assert thickness.Stale, "one of them moved alone"


def test_saving_classifies_it(made):
    document = main_document()
    set_preference("AutomaticClassification", True)
    try:
        window.settle(50)
        document.save()
        window.settle(50)
        window.wait_until(lambda: not lifelong.auto_classifier.is_busy)
    finally:
        set_preference("AutomaticClassification", None)
        window.settle(50)
    assert instances(made) == sorted(made.instances.values())
    assert info_of(made)["failures"] == []


def test_a_part_of_an_assembly_is_meant_by_a_click_on_it(made):
    Gui.Selection.addSelection("Main", "Machine", "Stiff.Lower.Face1")
    window.classify()
    assert window.text("ThinPart_PartLabel").startswith("FirstPlate")


def test_a_report_has_a_page_for_each_part(made, tmp_path):
    shutil.rmtree(tmp_path / "report", ignore_errors=True)
    window.press("ThinPart_Report")
    window.settle(50)
    window.widget("ThinPart_ReportFolder").setText(str(tmp_path / "report"))
    window.widget("ThinPart_ReportOpen").setChecked(False)
    window.click("ThinPart_ReportStart")
    window.wait_until(lambda: window.widget("ThinPart_ReportStart").isEnabled())
    assert "Not measured" not in window.text("ThinPart_ReportMessage")
    pages = [each for each in (tmp_path / "report").rglob("*.html") if each.name != "index.html"]
    assert len(pages) == len(made.instances)
