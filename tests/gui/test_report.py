# SPDX-License-Identifier: LGPL-2.1-or-later
"""A report about the active document, from the window."""

import hashlib
import re
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.api.annotations import annotate_part
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application.qt import QtCore, QtGui
from thinpart_workbench.storage.info.info_file import read_info


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


@pytest.mark.parametrize("language, code, heading", [
    ("German", "de", "Wo es d\u00fcnn ist"), ("French", "fr", "O\u00f9 elle est mince")])
def test_a_report_is_in_the_language_of_the_window(language, code, heading, saved, browser, tmp_path):
    broken = saved.addObject("Part::Feature", "Open")
    broken.Shape = Part.makePlane(10, 10)
    saved.recompute()
    started = Gui.getLocale()
    Gui.setLocale(language)
    try:
        opened()
        window.click("ThinPart_ReportStart")
        wait_for_end()
    finally:
        Gui.setLocale(started)
    page, = (tmp_path / "block-report").rglob("pages/*.html")
    text = page.read_text(encoding="utf-8")
    assert f'<html lang="{code}">' in text and heading in text and "Where it is thin" not in text
    overview = (tmp_path / "block-report" / "index.html").read_text(encoding="utf-8")
    assert f'<html lang="{code}">' in overview
    # What the window read itself and sent on is translated too.
    assert "bounds no solid" not in overview and "[" in overview


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
        annotate_part(info, notes="Ask before thinning this")
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


def the_page(folder):
    page, = (folder / "pages").rglob("*.html")
    return page.read_text(encoding="utf-8")


def test_a_document_that_was_never_saved_has_a_report_too(document, browser, tmp_path):
    window.add_ribbed_block(document)
    opened()
    assert message() == "" and Path(window.text("ThinPart_ReportFolder")).name == f"{document.Label}-report"
    window.widget("ThinPart_ReportFolder").setText(str(tmp_path / "out"))
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert message() == f"The report is in {tmp_path / 'out'}." and document.FileName == ""
    assert "as it was open in FreeCAD, not saved" in the_page(tmp_path / "out")
    assert "SHA-256" not in the_page(tmp_path / "out")


def test_changes_that_are_not_saved_are_in_the_report(document, browser, tmp_path):
    box = document.addObject("Part::Box", "Box")
    document.recompute()
    document.saveAs(str(tmp_path / "block.FCStd"))
    before = (tmp_path / "block.FCStd").read_bytes()
    box.Height = 2.5
    document.recompute()
    opened()
    window.click("ThinPart_ReportStart")
    wait_for_end()
    page = the_page(tmp_path / "block-report")
    assert "<dt>Thinnest wall</dt><dd>2.5 <small>" in page and "not saved" in page
    assert (tmp_path / "block.FCStd").read_bytes() == before


def test_a_saved_document_is_named_with_its_hash(saved, browser, tmp_path):
    opened()
    window.click("ThinPart_ReportStart")
    wait_for_end()
    page = the_page(tmp_path / "block-report")
    assert hashlib.sha256((tmp_path / "block.FCStd").read_bytes()).hexdigest() in page and "not saved" not in page


def test_a_folder_that_holds_something_else_is_left_alone(saved, browser, tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.txt").write_text("mine")
    opened()
    window.widget("ThinPart_ReportFolder").setText("mine")
    window.click("ThinPart_ReportStart")
    wait_for_end()
    assert "is not the folder of a report" in message() and browser.opened == []
    assert [each.name for each in (tmp_path / "mine").iterdir()] == ["thesis.txt"]


def test_it_can_be_stopped(saved, browser):
    opened()
    window.click("ThinPart_ReportStart")
    window.click("ThinPart_ReportCancel")
    wait_for_end()
    assert message() == "Stopped on request before the end."
    window.wait_until(lambda: window.workers() == [])
    assert browser.opened == []


def test_the_document_may_be_closed_meanwhile(saved, browser, tmp_path):
    opened()
    window.click("ThinPart_ReportStart")
    App.closeDocument(saved.Name)
    wait_for_end()
    assert Path(browser.opened[0]).exists()
    window.click("ThinPart_ReportStart")
    assert "is closed" in message()


@pytest.mark.parametrize("language, thinnest, said, caption", [
    ("English", "0.236", "thickness, in", "Thickness and box: in."),
    ("German", "0,236", "Dicke, in", "Dicke und H\u00fcllquader: in.")])
def test_a_report_in_inches_has_tables_in_mm(language, thinnest, said, caption, saved, browser, tmp_path):
    started = Gui.getLocale()
    Gui.setLocale(language)
    App.Units.setSchema(3)
    if "UnitSystem" in saved.PropertiesList:
        saved.UnitSystem = 3
    try:
        opened()
        window.click("ThinPart_ReportStart")
        wait_for_end()
    finally:
        App.Units.setSchema(0)
        Gui.setLocale(started)
    folder = tmp_path / "block-report"
    page, = (file.read_text(encoding="utf-8") for file in folder.rglob("pages/*.html"))
    text = re.sub(r"<style>.*?</style>", " ", page, flags=re.S)
    assert not re.search(r"\bmm\b", re.sub(r"<[^>]*>", " ", text)), re.findall(r".{30}\bmm\b.{10}", text)
    assert f"{thinnest} <small>in</small>" in text and f"{thinnest}\u00a0in" in text and said in text
    overview = (folder / "index.html").read_text(encoding="utf-8")
    assert caption in overview and f">{thinnest}<" in overview
    assert "\n" in (folder / "parts.csv").read_text() and ",6.0" in (folder / "parts.csv").read_text()
