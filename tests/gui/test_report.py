"""A report about the active document, from the window."""

import re
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.settings import set_preference
from thinpart_workbench.gui.qt import QtCore, QtGui
from thinpart_workbench.storage.info_file import read_info
from thinpart_workbench.workflow.kept_notes import keep_with_part


class Browser(QtCore.QObject):
    """Takes the files that would be opened in the user's browser."""

    def __init__(self):
        super().__init__()
        self.opened = []

    @QtCore.Slot(QtCore.QUrl)
    def take(self, url):
        self.opened.append(url.toLocalFile())


@pytest.fixture
def browser():
    browser = Browser()
    QtGui.QDesktopServices.setUrlHandler("file", browser, "take")
    yield browser
    QtGui.QDesktopServices.unsetUrlHandler("file")


@pytest.fixture
def saved(document, tmp_path):
    """A saved document with a ribbed block."""
    window.add_ribbed_block(document)
    document.saveAs(str(tmp_path / "block.FCStd"))
    Gui.runCommand("Std_Save")
    assert not Gui.getDocument(document.Name).Modified
    return document


def opened():
    window.press("ThinPart_Report")
    window.wait_until(lambda: window.is_shown("ThinPart_ReportDialog"))
    return window.widget("ThinPart_ReportDialog")


def wait_for_end():
    window.wait_until(lambda: window.widget("ThinPart_ReportStart").isEnabled())


def message():
    return window.text("ThinPart_ReportMessage")


def test_the_command_has_a_button_and_wants_a_document(document):
    button = window.tool_button("ThinPart_Report")
    assert button.toolTip() and not button.icon().isNull()
    App.closeDocument(document.Name)
    assert not Gui.isCommandActive("ThinPart_Report")


def test_a_report_is_written_beside_the_document_and_opened(saved, browser, tmp_path):
    dialog = opened()
    assert not dialog.isModal()
    assert window.widget("ThinPart_ReportFolder").text() == str(tmp_path / "block-report")
    window.click("ThinPart_ReportStart")
    assert window.is_shown("ThinPart_ReportProgress")
    wait_for_end()
    assert message() == f"The report is in {tmp_path / 'block-report'}."
    overview = tmp_path / "block-report" / "index.html"
    assert browser.opened == [str(overview)]
    assert "1 part" in overview.read_text() and len(list(overview.parent.rglob("pages/*.html"))) == 1
    assert not window.is_shown("ThinPart_ReportProgress")
    window.click("ThinPart_ReportLook")
    assert browser.opened == [str(overview)] * 2


def test_it_measures_by_the_preferences_and_has_the_notes_of_their_folder(document, browser, tmp_path):
    window.add(document, "Tube", Part.makeCylinder(20, 30).cut(Part.makeCylinder(18, 30)))
    document.saveAs(str(tmp_path / "block.FCStd"))
    library = tmp_path / "library"
    library.mkdir()
    wanted = {"InfoFolder": str(library), "AngularDeflection": 1.0}
    try:
        for name, value in wanted.items():
            set_preference(name, value)
        window.classify()
        window.wait_until(lambda: "preferred folder" in window.text("ThinPart_InfoText"))
        info, = library.rglob("*.thinpart.json")
        keep_with_part(info, notes="Ask before thinning this")
        opened()
        window.click("ThinPart_ReportStart")
        wait_for_end()
    finally:
        for name in wanted:
            set_preference(name, None)
    page, = (tmp_path / "block-report").rglob("pages/*.html")
    triangles = read_info(info)["parts"][0]["triangles"]
    assert "Ask before thinning this" in page.read_text()
    found = re.search(r"([0-9]+) triangles", page.read_text())
    assert int(found[1]) == pytest.approx(triangles, rel=0.02) and triangles > 3000


def test_who_does_not_want_to_look_need_not(saved, browser):
    opened()
    window.widget("ThinPart_ReportOpen").setChecked(False)
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert message().startswith("The report is in") and browser.opened == []


def test_a_document_that_was_never_saved_is_offered_to_be_saved(document):
    window.add_ribbed_block(document)
    opened()
    window.click("ThinPart_ReportStart")
    assert "has never been saved" in message() and window.workers() == []
    assert window.is_shown("ThinPart_ReportSave")


def test_changes_that_are_not_saved_are_saved_first(saved, browser, tmp_path):
    saved.Objects[0].Placement.Base.x = 3.0
    saved.recompute()
    assert Gui.getDocument(saved.Name).Modified
    opened()
    window.click("ThinPart_ReportStart")
    assert "not saved" in message() and not (tmp_path / "block-report").exists()
    window.click("ThinPart_ReportSave")
    assert message() == "" and not window.is_shown("ThinPart_ReportSave")
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert len(browser.opened) == 1


def test_a_folder_that_holds_something_else_is_left_alone(saved, browser, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("mine")
    opened()
    window.widget("ThinPart_ReportFolder").setText("mine")
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert "holds something else than a report" in message() and browser.opened == []
    assert [each.name for each in (tmp_path / "mine").iterdir()] == ["thesis.txt"]


def test_it_can_be_stopped(saved, browser):
    opened()
    window.click("ThinPart_ReportStart")
    window.click("ThinPart_ReportCancel")
    wait_for_end()
    assert message() == "Stopped before the end, as asked."
    assert window.workers() == [] and browser.opened == []


def test_the_document_may_be_closed_meanwhile(saved, browser, tmp_path):
    opened()
    window.click("ThinPart_ReportStart")
    App.closeDocument(saved.Name)
    wait_for_end()
    assert Path(browser.opened[0]).exists()
    window.click("ThinPart_ReportStart")
    assert "is closed" in message()
