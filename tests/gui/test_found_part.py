# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that was found: details, opening, inserting, notes, and parts like it."""

import json

import FreeCAD as App
import FreeCADGui as Gui
import pytest
import window_actions as window
from find_panel import (  # noqa: F401 - fixtures among them
    CATEGORY,
    FILE,
    PART,
    REASONS,
    SCORE,
    answered,
    cells,
    check,
    classified,
    details,
    library,
    no_libraries,
    opened,
    ready,
    row_of,
    select,
    status,
    tab,
    table,
    trigger,
    write,
)

from thinpart_workbench.api.annotations import annotate_part
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.document.insert_part import insert_part
from thinpart_workbench.gui.library.details import COMPARISON, NOTES
from thinpart_workbench.storage.info.info_file import read_info


def test_details_say_why(library):
    dock = opened(library)
    select(dock, "plate")
    assert window.text("ThinPart_Headline") == "Thin part"
    assert "(rule " in window.text("ThinPart_Why")
    assert window.text("ThinPart_PartFile") == str(library / "plate.step")
    failure = next(row for row, text in enumerate(cells(CATEGORY)) if text.startswith("\u2717"))
    table().selectRow(failure)
    window.settle(50)
    assert "damaged.thinpart.json" in window.text("ThinPart_PartSentence")
    assert not window.is_shown("ThinPart_Headline")


def test_a_double_click_opens_the_document(library):
    opened(library)
    row = row_of(None, "ribbed_block.FCStd")
    table().doubleClicked.emit(table().model().index(row, PART))  # where nothing is current nothing opens
    assert not App.listDocuments()
    table().selectRow(row)
    window.settle(30)
    table().doubleClicked.emit(table().model().index(row, PART))
    assert App.ActiveDocument.FileName == str(library / "ribbed_block.FCStd")
    assert [each.Name for each in Gui.Selection.getSelection()] == [table().current_part.name]
    table().selectRow(row_of(None, "plate.step"))
    window.settle(30)
    table().keyPressEvent(QtGui.QKeyEvent(
        QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier))
    assert len(App.listDocuments()) == 2 and len(App.ActiveDocument.Objects) >= 1


@pytest.mark.parametrize("button, opened_documents", [("Cancel", 0), ("Open", 1)])
def test_what_took_all_memory_is_opened_by_whoever_insists(library, button, opened_documents):
    info_file = library / "ribbed_block.FCStd.thinpart.json"
    content = json.loads(info_file.read_text())
    content["failures"] = [{"part": "Rib", "label": "Rib", "kind": "memory", "message": "Rib is too much."}]
    info_file.write_text(json.dumps(content))
    opened(library)
    table().selectRow(cells(PART).index("Rib"))
    window.settle(30)
    said = []
    window.answer("ThinPart_FolderDare", lambda box: (
        said.append((box.text(), box.informativeText(), box.defaultButton().text(), box.icon())),
        box.button(getattr(QtWidgets.QMessageBox, button)).click()))
    table().open_current()
    (text, question, default, icon), = said
    assert text == "Rib is too much." and question.endswith("Open it anyway?")
    assert "Cancel" in default and icon == QtWidgets.QMessageBox.Warning
    assert len(App.listDocuments()) == opened_documents


def test_a_document_that_has_gone_is_said_to_have(library):
    opened(library)
    (library / "plate.step").unlink()
    table().selectRow(row_of(None, "plate.step"))
    window.settle(30)
    table().open_current()
    assert window.text("ThinPart_FindMessage") == f"The file {library / 'plate.step'} no longer exists."


def test_inserting(library, document, tmp_path):
    dock = opened(library)
    select(dock, "plate")
    trigger("ThinPart_FoundInsert")
    assert len(document.Objects) == 1 and document.Objects[0].Shape.Volume > 0
    assert "plate.step was imported" in window.text("ThinPart_FindMessage")
    document.saveAs(str(tmp_path / "mine.FCStd"))
    select(dock, "Ribbed block", "ribbed_block.FCStd")
    trigger("ThinPart_FoundInsert")
    link = document.Objects[-1]
    assert link.TypeId == "App::Link" and link.LinkedObject.Document.FileName.endswith("ribbed_block.FCStd")
    assert App.ActiveDocument is document
    assert "A link to ribbed_block.FCStd" in window.text("ThinPart_FindMessage")


def test_a_copy_goes_into_a_document_without_a_file(library, document):
    dock = opened(library)
    select(dock, "Ribbed block", "ribbed_block.FCStd")
    trigger("ThinPart_FoundInsert")
    assert len(document.Objects) >= 1 and not document.FileName
    assert "was copied into" in window.text("ThinPart_FindMessage")


def test_inserting_a_shape_file(document, tmp_path):
    import Part

    file = tmp_path / "a b.brep"
    Part.makeBox(30, 20, 10).exportBrep(str(file))
    assert insert_part(str(file)) == f"a b.brep was imported into {document.Label}."
    inserted, = document.Objects
    assert inserted.Label == "a b" and inserted.Shape.Volume == pytest.approx(6000.0)
    document.undo()
    assert not document.Objects


def test_inserting_into_nothing_is_refused(library):
    dock = opened(library)
    select(dock, "plate")
    trigger("ThinPart_FoundInsert")
    assert "no document to insert into" in window.text("ThinPart_FindMessage")


def test_dragged_rows_are_files(library):
    dock = opened(library)
    select(dock, "plate")
    data = table().model().mimeData(table().selectionModel().selectedIndexes())
    assert [each.toLocalFile() for each in data.urls()] == [str(library / "plate.step")]
    trigger("ThinPart_FoundCopyPath")
    assert QtWidgets.QApplication.clipboard().text() == str(library / "plate.step")


def set_mesh(key, value):
    """Type the value of a mesh setting into its row."""
    row, settings = mesh_row(key)
    settings.item(row, 1).setText(value)


def mesh_row(key):
    settings = window.widget("ThinPart_MeshSettings")
    return next(row for row in range(settings.rowCount())
                if settings.item(row, 0).data(QtCore.Qt.UserRole) == key), settings


def stored_mesh(library):
    part, = read_info(library / "tube.step.thinpart.json")["parts"]
    return part["mesh"]


def test_mesh_settings_are_fields_and_what_they_cannot_show_is_kept(library):
    kept = {"algorithm": "HXT", "layers": 3, "zones": [{"size": 1}, {"size": 2}], "optimised": True, "size": 2.5}
    annotate_part(library / "tube.step.thinpart.json", mesh={"settings": kept})
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    shown = {}
    settings = window.widget("ThinPart_MeshSettings")
    for row in range(settings.rowCount()):
        shown[settings.item(row, 0).text()] = settings.item(row, 1).text()
    assert shown == {"Largest size, mm": "2.5", "Error aimed at": "", "Layers in thin walls": "3",
                     "Order of the elements": "", "Growth": "", "Most elements": "", "algorithm": "HXT",
                     "zones": "2 entries", "optimised": "yes", "": ""}
    assert "{" not in "".join(shown.values()) and window.widget("ThinPart_KeptMesh").text() == ""
    assert not window.widget("ThinPart_KeepNotes").isEnabled()
    set_mesh("layers", "")
    set_mesh("growth", "1.3")
    last = settings.rowCount() - 1
    settings.item(last, 0).setText("surface")
    settings.item(last, 1).setText("fine")
    assert settings.rowCount() == last + 2
    window.click("ThinPart_KeepNotes")
    window.wait_until(lambda: window.text("ThinPart_KeptMessage") == "Saved.")
    expected = {**kept, "growth": 1.3, "surface": "fine"}
    del expected["layers"]
    assert stored_mesh(library) == {"settings": expected}
    for key in ("size", "growth", "algorithm", "optimised"):
        set_mesh(key, "")
    row, _ = mesh_row("zones")
    assert not settings.item(row, 1).flags() & QtCore.Qt.ItemIsEditable


def test_the_size_of_elements_is_in_the_unit_of_the_window(library):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    before = App.Units.getSchema()
    try:
        App.Units.setSchema(3)  # inches
        lifelong.units.changed.emit()
        row, settings = mesh_row("size")
        assert settings.item(row, 0).text() == "Largest size, in"
        set_mesh("size", "0.5")
        window.click("ThinPart_KeepNotes")
        window.wait_until(lambda: window.text("ThinPart_KeptMessage") == "Saved.")
    finally:
        App.Units.setSchema(before)
        lifelong.units.changed.emit()
    assert stored_mesh(library) == {"settings": {"size": 12.7}}
    row, settings = mesh_row("size")
    assert settings.item(row, 1).text() == "12.7"


def test_settings_that_are_in_a_file_are_not_fields(library, tmp_path):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    window.widget("ThinPart_KeptMesh").setText(str(tmp_path / "settings.geo"))
    assert not window.widget("ThinPart_MeshSettings").isEnabled()
    window.widget("ThinPart_KeptMesh").setText("")
    assert window.widget("ThinPart_MeshSettings").isEnabled()


def test_notes_are_saved_and_found(library):
    dock = opened(library)
    select(dock, "tube")
    trigger("ThinPart_FoundNotes")
    notes = window.widget("ThinPart_KeptNotes")
    notes.setPlainText("swept mesh, Zweischalengeh\u00e4use")
    set_mesh("size", "2.5")
    window.widget("ThinPart_KeptLink").setText("https://example.org/job/7")
    window.click("ThinPart_KeepNotes")
    window.wait_until(lambda: window.text("ThinPart_KeptMessage") == "Saved.")
    part, = read_info(library / "tube.step.thinpart.json")["parts"]
    assert part["notes"].endswith("Zweischalengeh\u00e4use") and part["link"].endswith("/7")
    assert part["mesh"] == {"settings": {"size": 2.5}}
    ready(dock)
    write(dock, "ThinPart_FindWords", "zweischalen swept")
    assert cells(FILE) == ["tube.step"]
    write(dock, "ThinPart_FindWords", "")
    check(dock, "ThinPart_FindNotes")
    assert cells(FILE) == ["tube.step"]
    assert notes.toPlainText().startswith("swept") and not window.widget("ThinPart_KeepNotes").isEnabled()


def test_notes_are_saved_when_another_part_is_selected(library):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    window.widget("ThinPart_KeptNotes").setPlainText("do not forget")
    select(dock, "plate")
    assert window.widget("ThinPart_KeptNotes").toPlainText() == ""
    ready(dock)
    assert read_info(library / "tube.step.thinpart.json")["parts"][0]["notes"] == "do not forget"
    select(dock, "tube")
    assert window.widget("ThinPart_KeptNotes").toPlainText() == "do not forget"


def test_what_cannot_be_saved_stays_in_the_field(library):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    window.widget("ThinPart_KeptMesh").setText("/nowhere/at/all.json")
    window.click("ThinPart_KeepNotes")
    window.wait_until(lambda: "There is no file" in window.text("ThinPart_KeptMessage"))
    assert window.widget("ThinPart_KeptMesh").text() == "/nowhere/at/all.json"
    select(dock, "plate")
    select(dock, "tube")
    assert window.widget("ThinPart_KeptMesh").text() == "/nowhere/at/all.json"
    assert window.widget("ThinPart_KeepNotes").isEnabled()
    window.widget("ThinPart_KeptMesh").setText("")
    # An info file that has gone meanwhile.
    window.widget("ThinPart_KeptNotes").setPlainText("x")
    (library / "tube.step.thinpart.json").unlink()
    window.click("ThinPart_KeepNotes")
    window.wait_until(lambda: "There is no info file" in window.text("ThinPart_KeptMessage"))
    assert window.widget("ThinPart_KeptNotes").toPlainText() == "x"


@pytest.fixture
def browser():
    """What the desktop is asked to open."""
    opened = []

    class Browser(QtCore.QObject):
        @QtCore.Slot(QtCore.QUrl)
        def take(self, url):
            opened.append(url.toString())

    browser = Browser()
    for scheme in ("http", "https", "file", "smb", "javascript"):
        QtGui.QDesktopServices.setUrlHandler(scheme, browser, "take")
    yield opened
    for scheme in ("http", "https", "file", "smb", "javascript"):
        QtGui.QDesktopServices.unsetUrlHandler(scheme)


@pytest.mark.parametrize("button", ["Cancel", "Open"])
def test_a_link_is_opened_only_after_asking_by_its_full_address(library, browser, button):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    (library / "drawing.pdf").write_text("")
    for link, shown, address in (
            ("https://user@example.org/\u0430?a=<b>", "https://user@example.org/%D0%B0?a=%3Cb%3E", None),
            ("drawing.pdf", str(library / "drawing.pdf"), (library / "drawing.pdf").as_uri())):
        window.widget("ThinPart_KeptLink").setText(link)
        asked = []
        window.answer("ThinPart_OpenLinkQuestion", lambda box, asked=asked: (
            asked.append((box.text(), box.textFormat(), box.defaultButton().text())),
            box.button(getattr(QtWidgets.QMessageBox, button)).click()))
        window.click("ThinPart_OpenLink")
        window.wait_until(lambda asked=asked: asked)
        (text, text_format, default), = asked
        assert text == shown and text_format == QtCore.Qt.PlainText and "Cancel" in default
        window.settle(50)
        assert len(browser) == (button == "Open")
        if address is not None and browser:
            assert browser == [address]
        browser.clear()


@pytest.mark.parametrize("link, sentence", [
    ("javascript:alert(1)", "javascript:alert(1) was not opened: a link may lead to"),
    ("smb://host/share", "smb://host/share was not opened"),
    ("file:///etc/passwd", "file:///etc/passwd was not opened"),
    ("/etc/passwd", "/etc/passwd was not opened"),
    ("gone.pdf", "There is no file")])
def test_links_to_anywhere_else_are_not_opened(library, browser, link, sentence):
    dock = opened(library)
    select(dock, "tube")
    tab(dock, NOTES)
    window.widget("ThinPart_KeptLink").setText(link)
    window.click("ThinPart_OpenLink")
    window.wait_until(lambda: sentence in window.text("ThinPart_KeptMessage"))
    assert not browser


def test_an_info_file_does_not_have_a_macro_opened(library):
    (library / "evil.FCMacro").write_text("import os; os.mkdir(os.path.join(os.path.dirname(__file__), 'ran'))")
    info_file = library / "plate.step.thinpart.json"
    content = json.loads(info_file.read_text())
    content["source"]["file"] = "evil.FCMacro"
    info_file.write_text(json.dumps(content))
    dock = opened(library)
    select(dock, "plate")
    table().open_current()
    assert "evil.FCMacro was not opened: it is not a CAD file" in window.text("ThinPart_FindMessage")
    assert not (library / "ran").exists()


def test_parts_like_this_one(library):
    dock = opened(library)
    select(dock, "Ribbed block", "ribbed_block.FCStd")
    trigger("ThinPart_FoundSimilar")
    window.wait_until(lambda: status().startswith("The 8 parts most like Ribbed block"))
    assert cells(FILE)[0] == "ribbed_block.step" and cells(SCORE)[0] == "100\u00a0%"
    assert "same wall distribution" in cells(REASONS)[0]
    scores = [int(text.split("\u00a0")[0]) for text in cells(SCORE)]
    assert scores == sorted(scores, reverse=True)
    assert not table().isColumnHidden(SCORE)
    select(dock, "plate")
    chart = window.widget("ThinPart_DistributionComparison")
    assert details(dock).currentIndex() == COMPARISON and chart.isVisible()
    assert chart.names == ["Ribbed block", "plate"]
    assert "% like:" in window.text("ThinPart_Likeness").replace("\u00a0", " ")
    picture = chart.grab().toImage()
    colours = {picture.pixelColor(x, y).name() for x in range(chart.width()) for y in range(chart.height())}
    assert {"#204a87", "#ce5c00"} <= colours
    # Filters hold for similar parts as well.
    check(dock, "ThinPart_Category_thin")
    assert all(text.startswith("Thin part") for text in cells(CATEGORY))
    check(dock, "ThinPart_Category_thin")
    check(dock, "ThinPart_SameSize")
    assert 0 < len(cells(FILE)) < 8
    window.click("ThinPart_EndLike")
    answered(dock)
    assert status() == "10 of 10 parts" and table().isColumnHidden(SCORE)


def test_parts_like_the_active_one(library, document):
    dock = opened(library)
    window.wait_until(lambda: dock.width() >= 50 * dock.fontMetrics().averageCharWidth())
    place = table().mapTo(dock, QtCore.QPoint())
    window.click("ThinPart_LikeActive")
    assert "is empty" in window.text("ThinPart_FindMessage")
    window.settle(50)
    assert window.widget("ThinPart_FindMessage").height() < 2 * dock.fontMetrics().height()
    assert table().mapTo(dock, QtCore.QPoint()) == place, "what is said moves nothing that is pressed"
    window.add_ribbed_block(document)
    window.click("ThinPart_LikeActive")
    assert "classify the part first" in window.text("ThinPart_FindMessage")
    window.classify()
    assert not window.text("ThinPart_FindMessage")
    window.click("ThinPart_LikeActive")  # from the session: the document has no file
    window.wait_until(lambda: status().startswith("The 9 parts most like Ribbed, among 10 of 10"))
    window.click("ThinPart_EndLike")
    App.closeDocument(document.Name)
    App.openDocument(str(library / "ribbed_block.FCStd"))
    window.click("ThinPart_LikeActive")
    window.wait_until(lambda: status().startswith("The 8 parts most like Ribbed block"))
    assert cells(FILE)[0] == "ribbed_block.step"
    answered(dock)
