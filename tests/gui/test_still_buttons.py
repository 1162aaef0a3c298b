# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is pressed stays where it is when something comes or goes: results, messages, progress, answers of processes."""

import Part
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference_list
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.library.command import show_find_parts
from thinpart_workbench.gui.reclassify.reclassify_page import ReclassifyPage

PRESSED = (QtWidgets.QAbstractButton, QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QAbstractItemView)
LONG = "A sentence that takes more than one line of a narrow panel, since it says what happened and what is to be done."


def places(root):
    """How far below the top of a widget everything is that can be pressed: dict of int by object name."""
    window.settle(60)
    return {each.objectName(): each.mapTo(root, QtCore.QPoint()).y() for kind in PRESSED for each in root.findChildren(kind)
            if each.isVisible() and each.objectName().startswith("ThinPart_")}


def assert_still(before, root, at_least):
    """Nothing that was there has moved, among it some things by name."""
    now = places(root)
    assert set(at_least) <= set(before) & set(now)
    assert {name: (before[name], now[name]) for name in before if name in now and before[name] != now[name]} == {}


def mouse_is(where, widget):
    """The mouse comes over a widget (QEvent.Enter), or leaves it."""
    middle = QtCore.QPointF(widget.rect().center())
    come = QtGui.QEnterEvent(middle, middle, QtCore.QPointF(widget.mapToGlobal(widget.rect().center())))
    QtWidgets.QApplication.sendEvent(widget, come if where == QtCore.QEvent.Enter else QtCore.QEvent(where))


def test_a_result_stays_where_it_is_when_the_progress_above_it_goes(document):
    for number in range(3):
        window.add(document, f"Part{number}", Part.makeBox(100, 60, 3 + number))
    window.press("ThinPart_Classify")
    window.wait_until(lambda: window.is_shown("ThinPart_Panel"))
    panel = window.widget("ThinPart_Panel")
    mouse_is(QtCore.QEvent.Enter, panel)
    window.wait_until(lambda: window.is_shown("ThinPart_Headline"))
    before = places(panel)
    window.wait_until_measured()
    assert_still(before, panel, ["ThinPart_Label", "ThinPart_PartTable"])
    panel.known.show_known({"file": "bracket.step", "kind": "alike"}, LONG)
    panel.show_info(LONG, can_repeat=True)
    panel.show_ended(LONG)
    panel.result.show_flight("It is behind another part.")
    panel.result.show_labels((), LONG)
    assert_still(before, panel, ["ThinPart_Label", "ThinPart_PartTable", "ThinPart_CriteriaFold"])
    before = places(panel)
    assert "ThinPart_AgainButton" in before
    panel.show_info("")
    panel.show_info(LONG, can_repeat=True)
    assert_still(before, panel, ["ThinPart_AgainButton"])
    # The room of the progress is given up once the mouse has left.
    mouse_is(QtCore.QEvent.Leave, panel)
    assert places(panel)["ThinPart_Label"] < before["ThinPart_Label"]


def test_saving_does_not_put_another_button_under_the_mouse(document):
    window.add_ribbed_block(document)
    window.classify()
    panel = window.widget("ThinPart_Panel")
    save = places(panel)["ThinPart_SaveButton"]
    panel.show_info(LONG, can_repeat=True)
    assert places(panel)["ThinPart_AgainButton"] > save


def test_what_is_said_of_a_map_moves_nothing(document):
    block = window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    head = window.widget("ThinPart_ThicknessHead")
    before = places(head)
    pressed = [f"ThinPart_{name}" for name in ("FlyButton", "NextWall", "Measure", "ExportButton", "AgainButton")]
    block.Shape = Part.makeBox(100, 60, 2)
    document.recompute()
    thickness, = thickness_objects(document)
    window.wait_until(lambda: thickness.Stale and window.is_shown("ThinPart_Stale"))
    assert_still(before, head, pressed)
    head.show_flight(LONG)
    head.show_export("Written: part-thickness.png")
    assert_still(before, head, pressed)
    top = places(window.widget("ThinPart_RegionBox"))
    window.click("ThinPart_AgainButton")
    window.wait_until(lambda: window.is_shown("ThinPart_Progress"))
    assert_still(before, head, pressed)
    window.wait_until(lambda: not window.is_shown("ThinPart_Progress") and not thickness.Stale)
    assert_still(before, head, pressed)
    assert_still(top, window.widget("ThinPart_RegionBox"), ["ThinPart_RegionsTable", "ThinPart_ShowAllWalls"])


def test_choosing_a_part_of_a_map_does_not_move_the_table(document):
    window.add(document, "Plate", Part.makeBox(100, 60, 2))
    window.add(document, "Block", Part.makeBox(50, 50, 50))
    window.show_thickness()
    window.settle(300)
    head, table = window.widget("ThinPart_ThicknessHead"), window.widget("ThinPart_PartTable")
    before = places(head)
    for row in range(2):
        window.mouse_click(table.viewport(), table.visualRect(table.model().index(row, 0)).center())
        assert_still(before, head, ["ThinPart_PartTable", "ThinPart_FlyButton", "ThinPart_ExportButton"])


def test_bars_and_walls_of_a_map_are_chosen_without_moving_fields(document):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    box, chart = window.widget("ThinPart_DistributionBox"), window.widget("ThinPart_ThicknessChart")
    before = places(box)
    box.show_choice((1.0, 2.0), 0.25, 12)
    assert_still(before, box, ["ThinPart_Threshold", "ThinPart_ThinOnly", "ThinPart_Check"])
    assert chart.isVisible()
    probes = window.widget("ThinPart_ProbeBox")
    before = places(probes)
    window.click("ThinPart_ProbeButton")
    assert_still(before, probes, ["ThinPart_ProbeButton", "ThinPart_ProbeTable"])


@pytest.mark.timeout(120)  # it proposes sizes twice
def test_a_setting_of_a_mesh_is_worked_out_without_moving_fields(document):
    window.add_ribbed_block(document)
    window.press("ThinPart_MeshSizes")
    window.wait_until(lambda: window.is_shown("ThinPart_MeshEstimate") and not window.is_shown("ThinPart_Progress"))
    panel = window.widget("ThinPart_MeshSizesPanel")
    pressed = ["ThinPart_MeshAim", "ThinPart_MeshSize", "ThinPart_MeshButton", "ThinPart_MakeAnalysis"]
    window.wait_until(lambda: window.widget("ThinPart_MeshButton").isEnabled())
    before = places(panel)
    window.widget("ThinPart_MeshAim").setCurrentIndex(3)
    assert_still(before, panel, pressed)
    window.wait_until(lambda: not window.is_shown("ThinPart_Progress") and window.widget("ThinPart_MeshButton").isEnabled())
    panel.show_offer(LONG)
    panel.show_message(LONG)
    assert_still(before, panel, pressed)


def test_messages_of_dialogs_move_no_button(document, tmp_path):
    window.add_ribbed_block(document)
    window.press("ThinPart_ClassifyFolder")
    dialog = window.widget("ThinPart_FolderDialog")
    before = places(dialog)
    window.widget("ThinPart_Folder").setCurrentText(str(tmp_path / "not there"))
    window.click("ThinPart_FolderStart")
    window.wait_until(lambda: window.is_shown("ThinPart_FolderMessage"))
    assert_still(before, dialog, [f"ThinPart_Folder{name}" for name in ("Start", "Table", "Close", "Label")])
    dialog.reject()
    window.press("ThinPart_Report")
    dialog = window.widget("ThinPart_ReportDialog")
    before = places(dialog)
    window.widget("ThinPart_ReportFolder").setText(str(tmp_path / "report"))
    window.widget("ThinPart_ReportOpen").setChecked(False)
    window.click("ThinPart_ReportStart")
    window.wait_until(lambda: window.is_shown("ThinPart_ReportMessage"))
    assert_still(before, dialog, ["ThinPart_ReportStart", "ThinPart_ReportCancel", "ThinPart_ReportClose"])
    dialog.end()


def test_what_the_libraries_say_moves_no_button(tmp_path):
    set_preference_list("Libraries", [str(tmp_path)])
    try:
        dock = show_find_parts()
        window.wait_until(lambda: not dock.is_refreshing and not dock.is_waiting)
        dock.setFloating(True)
        dock.resize(500, 800)
        window.widget("ThinPart_FindChoices").setCurrentIndex(1)
        before = places(dock)
        library = {"root": str(tmp_path), "parts": 0, "problems": [LONG], "busy": True}
        page = window.widget("ThinPart_LibraryList").parentWidget()
        page.show_libraries([library])
        page.show_progress({"root": str(tmp_path), "done": 3, "total": 9})
        assert_still(before, dock, ["ThinPart_AddLibrary", "ThinPart_RefreshLibraries", "ThinPart_LibraryList",
                                    "ThinPart_LikeActive", "ThinPart_FoundTable"])
        page = dock.findChild(ReclassifyPage)
        window.widget("ThinPart_FindChoices").setCurrentIndex(2)
        window.wait_until(lambda: not page.is_waiting)
        before = places(page)
        assert {"ThinPart_ReclassifyProfile", "ThinPart_ReclassifyWrite"} <= set(before)
        dock.find_like_active()  # no document is open, which is said
        assert_still(before, page, ["ThinPart_ReclassifyProfile", "ThinPart_ReclassifyWrite"])
    finally:
        set_preference_list("Libraries", [])
