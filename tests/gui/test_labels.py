# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a user says a part is: in the panel of a classification, in the results of a folder, and in the panel that finds."""

import FreeCADGui as Gui
import Part
import pytest
import window_actions as window
from find_panel import (  # noqa: F401 - fixtures among them
    classified,
    library,
    no_libraries,
    opened,
    ready,
    select,
    status,
)
from folder_dialog_use import FILE, LABELS, column, dialog, folder, no_choices, run  # noqa: F401 - fixtures among them

from thinpart_workbench.api.annotations import label_part
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.storage.info.stored_records import stored_records


@pytest.fixture(autouse=True)
def person():
    """The name under which labels are kept."""
    set_preference("Person", "Anna")
    yield "Anna"
    set_preference("Person", None)


@pytest.fixture
def saved(document, tmp_path):
    """A saved document with a plate."""
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    document.saveAs(str(tmp_path / "parts.FCStd"))
    Gui.runCommand("Std_Save")
    return tmp_path / "parts.FCStd"


def choose(action, button="ThinPart_Label"):
    """Open the menu with the mouse and take one of its entries."""
    target = window.widget(button)
    assert target.isVisible() and target.isEnabled()
    window.QtCore.QTimer.singleShot(100, lambda: _take(action))
    window.mouse_click(target)
    window.wait_until(lambda: QtWidgets.QApplication.activePopupWidget() is None)
    window.wait_until(lambda: not lifelong.requests.is_busy)
    window.settle(30)


def _take(action):
    menu = QtWidgets.QApplication.activePopupWidget()
    found = next(each for each in menu.actions() if each.objectName() == action)
    window.mouse_click(menu, menu.actionGeometry(found).center())


def labels(path, part=None):
    record, = stored_records(path, part)
    return [(each["person"], each["category"], each["sure"]) for each in record.get("labels", [])]


def button_text(name="ThinPart_Label"):
    return window.widget(name).text().replace("&", "")


def test_a_label_is_one_click_in_the_panel_and_is_replaced_and_removed(saved):
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part" and button_text() == "Not right?"
    choose("ThinPart_Label_normal")
    assert labels(saved) == [("Anna", "normal", True)] and button_text() == "My label: normal"
    choose("ThinPart_Label_thin_features_unsure")
    assert labels(saved) == [("Anna", "thin_features", False)] and button_text() == "My label: thin features?"
    choose("ThinPart_Label_remove")
    assert labels(saved) == [] and button_text() == "Not right?"


def test_labels_of_others_are_shown_and_stay_over_new_measurements(saved):
    window.classify()
    label_part(f"{saved}.thinpart.json", "normal", "Bert", False)
    choose("ThinPart_Label_thin")
    assert labels(saved) == [("Bert", "normal", False), ("Anna", "thin", True)]
    assert window.text("ThinPart_Labels") == "Labels: Bert: normal (unsure)"
    window.close_button().click()
    window.settle(100)
    window.classify()
    assert labels(saved) == [("Bert", "normal", False), ("Anna", "thin", True)]
    assert window.text("ThinPart_Labels") == "Labels: Bert: normal (unsure)" and button_text() == "My label: thin"


def test_in_an_unsaved_document_the_label_waits_for_the_info_file(document, tmp_path):
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    window.classify()
    choose("ThinPart_Label_normal")
    assert button_text() == "My label: normal" and "once the document is saved" in window.text("ThinPart_LabelMessage")
    document.saveAs(str(tmp_path / "late.FCStd"))
    window.click("ThinPart_SaveButton")
    window.wait_until(lambda: (tmp_path / "late.FCStd.thinpart.json").is_file())
    window.wait_until(lambda: labels(tmp_path / "late.FCStd") == [("Anna", "normal", True)])
    window.wait_until(lambda: not window.is_shown("ThinPart_LabelMessage"))
    assert button_text() == "My label: normal"


def test_a_label_that_cannot_be_kept_says_why(saved):
    window.classify()
    info = saved.with_name("parts.FCStd.thinpart.json")
    content = info.read_bytes()
    info.write_text("{")
    choose("ThinPart_Label_normal")
    assert info.name in window.text("ThinPart_LabelMessage") and button_text() == "Not right?"
    info.write_bytes(content)
    choose("ThinPart_Label_normal")
    assert labels(saved) == [("Anna", "normal", True)] and not window.is_shown("ThinPart_LabelMessage")


def test_in_the_panel_that_finds_parts_labels_can_be_given_and_searched(library):
    dock = opened(library)
    select(dock, "plate")
    choose("ThinPart_Label_normal")
    assert labels(library / "plate.step") == [("Anna", "normal", True)] and button_text() == "My label: normal"
    ready(dock)
    for box, count in (("ThinPart_FindLabelled", 1), ("ThinPart_FindDisputed", 1)):
        window.widget(box).setChecked(True)
        ready(dock)
        assert status().startswith(f"{count} of ") and window.widget(box).text().endswith(f"({count})")
        window.widget(box).setChecked(False)
    ready(dock)
    select(dock, "plate")
    choose("ThinPart_Label_thin")
    ready(dock)
    window.wait_until(lambda: window.widget("ThinPart_FindDisputed").text().endswith("(0)"))
    assert window.widget("ThinPart_FindLabelled").text().endswith("(1)")


def test_in_the_results_of_a_folder(dialog, folder):
    run(folder)
    assert not window.widget("ThinPart_FolderLabel").isEnabled()
    view = window.widget("ThinPart_FolderTable")
    view.selectRow(column(FILE).index("inner/plate.step"))
    choose("ThinPart_Label_thin_features", "ThinPart_FolderLabel")
    assert labels(folder / "inner" / "plate.step") == [("Anna", "thin_features", True)]
    assert button_text("ThinPart_FolderLabel") == "My label: thin features"
    assert view.model().headerData(LABELS, window.QtCore.Qt.Horizontal) == "Labels"
    assert column(LABELS)[column(FILE).index("inner/plate.step")] == "Anna: thin features"
    view.selectRow(column(FILE).index("damaged.step"))
    assert not window.widget("ThinPart_FolderLabel").isEnabled()


def test_one_label_for_all_selected_rows_of_a_folder(dialog, folder):
    run(folder)
    view = window.widget("ThinPart_FolderTable")
    view.selectAll()
    parts = [row for row in view.selected_rows if not row.error_kind]
    assert len(parts) > 1 and button_text("ThinPart_FolderLabel") == f"Label {len(parts)} parts"
    choose("ThinPart_Label_normal", "ThinPart_FolderLabel")
    window.wait_until(lambda: column(LABELS).count("Anna: normal") == len(parts))
    assert all(labels(folder / row.file, row.part) == [("Anna", "normal", True)] for row in parts)


def test_one_label_for_all_selected_parts_of_the_libraries(library):
    dock = opened(library)
    view = window.widget("ThinPart_FoundTable")
    view.selectAll()
    parts = [part for part in view.selected_rows if not part.error_kind]
    assert len(parts) > 1
    window.wait_until(lambda: button_text("ThinPart_FoundLabel") == f"Label {len(parts)} parts")
    choose("ThinPart_Label_thin", "ThinPart_FoundLabel")
    ready(dock)
    window.wait_until(lambda: window.widget("ThinPart_FindLabelled").text().endswith(f"({len(parts)})"))
