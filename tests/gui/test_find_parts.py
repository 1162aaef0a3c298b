"""The panel that finds parts: libraries, filters, list, details, similar parts, other thresholds."""

import json
import os
import shutil
import subprocess
import time
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
import window_actions as window

from made_library import make_large_library
from thinpart_workbench.core.criteria import load_profile
from thinpart_workbench.freecad_adapter.settings import preference_list, set_preference_list
from thinpart_workbench.gui import find_parts
from thinpart_workbench.gui.found_table import CATEGORY, FILE, PART, REASONS, SCORE, SIZE, THINNEST, WAITING
from thinpart_workbench.gui.part_details import COMPARISON, NOTES
from thinpart_workbench.gui.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.worker_python import python_environment, python_program
from thinpart_workbench.storage.info_file import read_info

SAMPLES = ("plate.step", "block.step", "ribbed_block.FCStd", "ribbed_block.step", "tube.step",
           "heat_sink.FCStd", "assembly_of_three.FCStd")
MANY = 20000


@pytest.fixture(scope="session")
def classified(tmp_path_factory):
    """Samples, classified by the command line, and a file that cannot be."""
    folder = tmp_path_factory.mktemp("classified")
    for name in SAMPLES:
        shutil.copyfile(window.SAMPLES / name, folder / name)
    (folder / "damaged.thinpart.json").write_text("{")
    subprocess.run([python_program(), "-m", "thinpart_workbench", "classify", str(folder)],
                   env=python_environment(), check=True, stdin=subprocess.DEVNULL, capture_output=True)
    return folder


@pytest.fixture
def library(classified, tmp_path, monkeypatch):
    """A library of its own for a test that may change it."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    shutil.copytree(classified, tmp_path / "library")
    return tmp_path / "library"


@pytest.fixture(scope="session")
def many(classified, tmp_path_factory):
    folder = tmp_path_factory.mktemp("many")
    make_large_library(folder, sorted(classified.glob("*.step.thinpart.json")), MANY)
    return folder


@pytest.fixture(autouse=True)
def no_libraries():
    set_preference_list("Libraries", [])
    yield
    find_parts.end_find_parts()
    set_preference_list("Libraries", [])
    window.wait_until(lambda: not workers(), 20)


def workers():
    """Processes of the panel that still run."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
            command = (stat.parent / "cmdline").read_text()
        except OSError:
            continue
        if fields[0] != "Z" and ("library_worker" in command or "reclassify_worker" in command) and (
                int(fields[1]) == os.getpid()):
            found.append(int(stat.parent.name))
    return found


def opened(*roots):
    """The panel, with some libraries read."""
    set_preference_list("Libraries", [str(each) for each in roots])
    dock = find_parts.show_find_parts()
    ready(dock)
    return dock


def ready(dock):
    window.wait_until(lambda: not dock.is_refreshing, 120)
    answered(dock)


def answered(dock):
    window.settle(20)
    window.wait_until(lambda: not typing(dock) and not dock.is_waiting, 60)
    window.settle(20)


def typing(dock):
    return any(timer.isActive() for timer in dock.findChildren(QtCore.QTimer) if timer.isSingleShot()
               and timer.interval() > 200)


def table():
    return window.widget("ThinPart_FoundTable")


def cells(column):
    """The texts of a column; those of a short table once all of them are there."""
    model = table().model()

    def texts(column):
        return [model.index(row, column).data() for row in range(model.rowCount())]

    if model.rowCount() < 100:
        window.wait_until(lambda: WAITING not in texts(PART))
    return texts(column)


def status():
    return window.text("ThinPart_FindStatus")


def check(dock, name):
    box = window.widget(name)
    box.setChecked(not box.isChecked())
    answered(dock)
    return box


def write(dock, name, text):
    window.widget(name).setText(text)
    answered(dock)


def row_of(label, place=None):
    """The row of a part, by its label or its file or both; rows come a little after their number."""
    found = []

    def is_there():
        found[:] = [row for row, (name, file) in enumerate(zip(cells(PART), cells(FILE)))
                    if label in (None, name) and place in (None, file)]
        return bool(found)

    window.wait_until(is_there)
    return found[0]


def select(dock, label, place=None):
    """Select the row of a part and wait for its details."""
    table().selectRow(row_of(label, place))
    window.wait_until(lambda: window.widget("ThinPart_KeptNotes").isEnabled() or (
        table().current_part.error_kind))
    window.settle(30)
    return table().current_part


def tab(dock, page):
    dock._details.setCurrentIndex(page)
    window.settle(20)


def count_of(name):
    return int(window.widget(name).text().rpartition("(")[2].rstrip(")").replace(",", ""))


def choose(dock, index):
    dock._choices.setCurrentIndex(index)
    window.settle(20)


def test_the_command_shows_and_hides_one_panel():
    window.press("ThinPart_FindParts")
    dock = window.widget("ThinPart_FindParts", QtWidgets.QDockWidget)
    assert dock.isVisible() and dock.parent() is Gui.getMainWindow()
    window.press("ThinPart_FindParts")
    assert not dock.isVisible()
    window.wait_until(lambda: not workers(), 20)
    window.press("ThinPart_FindParts")
    assert window.widget("ThinPart_FindParts", QtWidgets.QDockWidget) is dock and dock.isVisible()


def test_without_a_library_it_says_what_to_do():
    opened()
    assert "Add a folder" in status()
    assert window.is_shown("ThinPart_LibraryList")


def test_all_parts_are_listed_with_failures_among_them(library):
    opened(library)
    # Three of the assembly, one of each other sample, and the damaged info file.
    assert status() == "10 of 10 parts"
    assert {"Ribbed block", "ribbed_block", "Dowel pin \u00d7 2"} < set(cells(PART))
    assert sum(text.startswith("\u2717 Failed") for text in cells(CATEGORY)) == 1
    assert "plate.step" in cells(FILE)
    assert preference_list("Libraries") == [str(library)]


def test_thumbnails_are_those_of_the_cache(library, classified, tmp_path):
    picture = QtGui.QImage(160, 120, QtGui.QImage.Format_ARGB32)
    picture.fill(QtGui.QColor(10, 200, 30))
    opened(library)
    row = row_of(None, "block.step")
    index = table().model().index(row, PART)
    part = table().model().part_at(row)
    missing = index.data(QtCore.Qt.DecorationRole).toImage()
    Path(part.thumbnail).parent.mkdir(parents=True, exist_ok=True)
    picture.save(part.thumbnail)
    choose(find_parts._docks[0], 1)
    window.click("ThinPart_RefreshLibraries")
    ready(find_parts._docks[0])
    window.wait_until(lambda: index_of("block.step").data(QtCore.Qt.DecorationRole).toImage() != missing, 10)
    shown = index_of("block.step").data(QtCore.Qt.DecorationRole).toImage()
    assert shown.pixelColor(shown.width() // 2, shown.height() // 2) == QtGui.QColor(10, 200, 30)


def index_of(file):
    return table().model().index(cells(FILE).index(file), PART)


def test_categories_and_their_counts(library):
    dock = opened(library)
    names = ("thin", "thin_features", "normal", "unknown", "failed")
    counts = {name: count_of(f"ThinPart_Category_{name}") for name in names}
    assert sum(counts.values()) == 10 and counts["failed"] == 1
    check(dock, "ThinPart_Category_thin")
    assert status() == f"{counts['thin']} of 10 parts"
    assert {text.split(" (")[0] for text in cells(CATEGORY)} == {"Thin part"}
    # The other categories still say what they would add.
    assert {name: count_of(f"ThinPart_Category_{name}") for name in names} == counts
    check(dock, "ThinPart_Category_failed")
    assert status() == f"{counts['thin'] + 1} of 10 parts"
    write(dock, "ThinPart_FindWords", "plate.step")
    assert count_of("ThinPart_Category_failed") == 0 and count_of("ThinPart_Category_thin") == 1
    assert cells(FILE) == ["plate.step"]


def test_criteria(library):
    dock = opened(library)
    count = count_of("ThinPart_Criterion_1")
    assert 0 < count < 9
    check(dock, "ThinPart_Criterion_1")
    assert status() == f"{count} of 10 parts"
    assert count_of("ThinPart_Category_thin") == count


def test_ranges_by_hand_and_as_numbers(library):
    dock = opened(library)
    write(dock, "ThinPart_FindWords", ".step")
    everything = cells(FILE)
    window.widget("ThinPart_SizeMost").setText("100.5")
    window.widget("ThinPart_SizeMost").textEdited.emit("100.5")
    answered(dock)
    sizes = [float(each) for each in cells(SIZE)]
    assert sizes and max(sizes) <= 100.5 and len(sizes) < len(everything)
    window.widget("ThinPart_ClearFilters").click()
    answered(dock)
    assert status() == "10 of 10 parts" and window.widget("ThinPart_SizeMost").text() == ""
    slider = window.widget("ThinPart_ThinnestSlider")
    drag(slider, slider.place_of(0), slider.width() * 0.7)
    answered(dock)
    least = float(window.widget("ThinPart_ThinnestLeast").text())
    thinnest = [float(each) for each in cells(THINNEST)]
    assert thinnest and min(thinnest) >= least * 0.99 and "10 of 10" not in status()
    drag(slider, slider.place_of(0), 0)
    answered(dock)
    assert status() == "10 of 10 parts"


def drag(slider, start, end):
    y = slider.height() / 2
    for kind, x, button, buttons in (
            (QtCore.QEvent.MouseButtonPress, start, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton),
            (QtCore.QEvent.MouseMove, end, QtCore.Qt.NoButton, QtCore.Qt.LeftButton),
            (QtCore.QEvent.MouseButtonRelease, end, QtCore.Qt.LeftButton, QtCore.Qt.NoButton)):
        place = QtCore.QPointF(x, y)
        QtWidgets.QApplication.sendEvent(slider, QtGui.QMouseEvent(
            kind, place, QtCore.QPointF(slider.mapToGlobal(place.toPoint())), button, buttons,
            QtCore.Qt.NoModifier))


def test_conditions_and_what_is_wrong_with_them(library):
    dock = opened(library)
    write(dock, "ThinPart_FindConditions", "D2/D3 > 6")
    found = cells(FILE)
    assert "plate.step" in found and "block.step" not in found
    write(dock, "ThinPart_FindConditions", "D2/D3 >")
    assert "is not understood" in window.text("ThinPart_FindRefusal")
    assert cells(FILE) == found
    # What is understood goes on to hold.
    check(dock, "ThinPart_Category_thin")
    assert set(cells(FILE)) <= set(found) and "plate.step" in cells(FILE)
    check(dock, "ThinPart_Category_thin")
    write(dock, "ThinPart_FindConditions", "")
    assert not window.is_shown("ThinPart_FindRefusal") and status() == "10 of 10 parts"


def test_since(library):
    dock = opened(library)
    window.widget("ThinPart_FindSince").setCurrentIndex(1)
    answered(dock)
    assert status() == "9 of 10 parts"  # the damaged one has no date
    os.utime(library / "plate.step", (1e9, 1e9))
    info = library / "plate.step.thinpart.json"
    content = json.loads(info.read_text())
    content["source"]["modified"] = "2001-09-09T01:46:40.000000+00:00"
    info.write_text(json.dumps(content))
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    assert status() == "8 of 10 parts" and "plate.step" not in cells(FILE)


def test_sorting_by_the_header(library):
    dock = opened(library)
    view = table()
    view.sortByColumn(THINNEST, QtCore.Qt.DescendingOrder)
    answered(dock)
    values = [float(each) for each in cells(THINNEST) if each]
    assert values == sorted(values, reverse=True) and cells(THINNEST)[-1] == ""
    view.sortByColumn(FILE, QtCore.Qt.AscendingOrder)
    answered(dock)
    assert cells(FILE) == sorted(cells(FILE), key=str.casefold)


def test_the_selected_part_stays_selected(library):
    dock = opened(library)
    part = select(dock, "tube")
    table().sortByColumn(SIZE, QtCore.Qt.DescendingOrder)
    answered(dock)
    assert table().current_part.info_file == part.info_file
    check(dock, f"ThinPart_Category_{part.category}")
    assert table().current_part.info_file == part.info_file
    assert dock._details.part.info_file == part.info_file


def test_details_say_why(library):
    dock = opened(library)
    select(dock, "plate")
    assert window.text("ThinPart_Headline") == "Thin part"
    assert "criteri" in window.text("ThinPart_Why")
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


def test_a_document_that_has_gone_is_said_to_have(library):
    opened(library)
    (library / "plate.step").unlink()
    table().selectRow(row_of(None, "plate.step"))
    window.settle(30)
    table().open_current()
    assert window.text("ThinPart_FindMessage") == f"There is no file {library / 'plate.step'} any more."


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


def test_inserting_into_nothing_is_refused(library):
    dock = opened(library)
    select(dock, "plate")
    trigger("ThinPart_FoundInsert")
    assert "no document to insert into" in window.text("ThinPart_FindMessage")


def trigger(name):
    menu = table().menu()
    next(each for each in menu.actions() if each.objectName() == name).trigger()
    window.settle(30)


def test_dragged_rows_are_files(library):
    dock = opened(library)
    select(dock, "plate")
    data = table().model().mimeData(table().selectionModel().selectedIndexes())
    assert [each.toLocalFile() for each in data.urls()] == [str(library / "plate.step")]
    trigger("ThinPart_FoundCopyPath")
    assert QtWidgets.QApplication.clipboard().text() == str(library / "plate.step")


def test_notes_are_saved_and_found(library):
    dock = opened(library)
    select(dock, "tube")
    trigger("ThinPart_FoundNotes")
    notes = window.widget("ThinPart_KeptNotes")
    notes.setPlainText("swept mesh, Zweischalengeh\u00e4use")
    window.widget("ThinPart_KeptMesh").setText('{"size": 2.5}')
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
    assert dock._details.currentIndex() == COMPARISON and chart.isVisible()
    assert chart.names == ["Ribbed block", "plate"]
    assert "% like:" in window.text("ThinPart_Likeness").replace("\u00a0", " ")
    colours = {chart.grab().toImage().pixelColor(x, y).name()
               for x in range(chart.width()) for y in range(chart.height())}
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
    window.click("ThinPart_LikeActive")
    assert "is empty" in window.text("ThinPart_FindMessage")
    window.add_ribbed_block(document)
    window.click("ThinPart_LikeActive")
    assert "classify the part first" in window.text("ThinPart_FindMessage")
    window.classify()
    window.click("ThinPart_LikeActive")  # from the session: the document has no file
    window.wait_until(lambda: status().startswith("The 9 parts most like Ribbed, among 10 of 10"))
    window.click("ThinPart_EndLike")
    App.closeDocument(document.Name)
    App.openDocument(str(library / "ribbed_block.FCStd"))
    window.click("ThinPart_LikeActive")
    window.wait_until(lambda: status().startswith("The 8 parts most like Ribbed block"))
    assert cells(FILE)[0] == "ribbed_block.step"
    answered(dock)


@pytest.fixture
def other_profile(tmp_path):
    """Thresholds by which far more is a plate."""
    content = json.loads(json.dumps(load_profile("paper").content))
    content.update(name="generous", title="Generous")
    content["categories"][0]["criteria"][0]["conditions"] = [
        {"quantity": "V/VBB", "comparison": ">", "value": 0.01}]
    path = tmp_path / "generous.json"
    path.write_text(json.dumps(content))
    return path


def test_reclassify_previews_and_writes(library, other_profile):
    dock = opened(library)
    choose(dock, 2)
    window.widget("ThinPart_ReclassifyProfile").choose(str(other_profile))
    before = {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")}
    window.click("ThinPart_ReclassifyPreview")
    window.wait_until(lambda: "change their category" in window.text("ThinPart_ReclassifyMessage"))
    assert "damaged.thinpart.json" in window.text("ThinPart_ReclassifyMessage")
    counts = window.widget("ThinPart_ReclassifyTable")
    rows = [[counts.item(row, column).text() for column in range(3)] for row in range(counts.rowCount())]
    assert ["Thin part", "9"] in [[name, after] for name, _, after in rows]
    assert sum(int(now) for _, now, _ in rows) == 9
    assert before == {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")}
    window.wait_until(window.widget("ThinPart_ReclassifyWrite").isEnabled, 10)
    said = []
    window.answer("ThinPart_ReclassifyQuestion", lambda box: (
        said.append(box.text()), box.button(QtWidgets.QMessageBox.Yes).click()))
    window.click("ThinPart_ReclassifyWrite")
    window.wait_until(lambda: "were updated" in window.text("ThinPart_ReclassifyMessage"))
    assert said[0].startswith("7 info files will be updated")
    ready(dock)
    assert count_of("ThinPart_Category_thin") == 9
    assert read_info(library / "block.step.thinpart.json")["profile"]["name"] == "generous"
    assert (library / "damaged.thinpart.json").read_text() == "{"


def test_a_profile_that_is_none_is_refused(library, tmp_path):
    dock = opened(library)
    choose(dock, 2)
    (tmp_path / "none.json").write_text("[]")
    window.widget("ThinPart_ReclassifyProfile").choose(str(tmp_path / "none.json"))
    window.click("ThinPart_ReclassifyPreview")
    assert "is not a ThinPart profile" in window.text("ThinPart_ReclassifyMessage")


def test_adding_and_removing_libraries(library, tmp_path):
    dock = opened(library)
    choose(dock, 1)
    inner = library / "inner"
    inner.mkdir()
    dock._libraries.add(str(inner))
    assert "is in the list already" in window.text("ThinPart_LibraryProblems")
    other = tmp_path / "other"
    other.mkdir()
    shutil.copyfile(library / "plate.step.thinpart.json", other / "plate.step.thinpart.json")
    dock._libraries.add(str(other))
    ready(dock)
    assert status() == "11 of 11 parts"
    entries = window.widget("ThinPart_LibraryList")
    entries.item(0).setSelected(True)
    window.click("ThinPart_RemoveLibrary")
    ready(dock)
    assert status() == "1 of 1 parts" and preference_list("Libraries") == [str(other)]
    dock._libraries.add(str(tmp_path))
    ready(dock)
    assert preference_list("Libraries") == [str(tmp_path)]
    assert (library / "plate.step.thinpart.json").is_file()


def test_a_folder_that_is_gone_keeps_what_was_known_and_says_so(library):
    dock = opened(library)
    library.rename(library.with_name("elsewhere"))
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    assert f"There is no folder {library} any more" in window.text("ThinPart_LibraryProblems")
    assert status() == "10 of 10 parts"
    part = table().model().part_at(row_of(None, "plate.step"))
    table().selectRow(row_of(None, "plate.step"))
    window.wait_until(lambda: window.is_shown("ThinPart_PartSentence"))
    assert part.file == str(library / "plate.step")
    window.widget("ThinPart_LibraryList").item(0).setSelected(True)
    window.click("ThinPart_RemoveLibrary")
    ready(dock)
    assert "Add a folder" in status()


def test_an_index_that_cannot_be_kept_is_said_to_be_in_memory(library, tmp_path, monkeypatch):
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "file"))
    dock = opened(library)
    choose(dock, 1)
    assert "was built in memory" in window.text("ThinPart_LibraryProblems")
    assert status() == "10 of 10 parts"
    write(dock, "ThinPart_FindWords", "tube")
    assert cells(FILE) == ["tube.step"]


def test_a_process_that_dies_is_told_and_started_again(library):
    dock = opened(library)
    os.kill(workers()[0], 9)
    window.wait_until(lambda: "ended unexpectedly" in window.text("ThinPart_FindMessage"))
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    write(dock, "ThinPart_FindWords", "tube")
    assert cells(FILE) == ["tube.step"]


@pytest.mark.parametrize("width, larger", [(340, 1.0), (420, 1.4)])
def test_nothing_is_cut_off_where_the_panel_is_narrow(library, width, larger):
    dock = opened(library)
    font = dock.font()
    font.setPointSizeF(font.pointSizeF() * larger)
    dock.setFont(font)
    dock.setFloating(True)
    dock.resize(width, 800)
    part = select(dock, "ribbed_block")
    trigger("ThinPart_FoundSimilar")
    answered(dock)
    assert dock._details.part is not None and part is not None
    assert dock.width() <= width + 2
    for tabs in (dock._choices, dock._details):
        for page in range(tabs.count()):
            tabs.setCurrentIndex(page)
            window.settle(50)
            area = tabs.widget(page)
            assert area.horizontalScrollBar().maximum() == 0, tabs.tabText(page)
            for each in [*area.findChildren(QtWidgets.QLabel), *area.findChildren(QtWidgets.QAbstractButton)]:
                if each.isVisible() and each.text():
                    needed = each.heightForWidth(each.width()) if each.hasHeightForWidth() else 0
                    assert each.height() >= needed - 1, each.text()
                    assert each.width() >= min(each.minimumSizeHint().width(), width), each.text()


@pytest.fixture
def many_opened(many, tmp_path_factory, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(many.with_name("cache of many")))
    return opened(many)


class Ticks:
    """Counts how often the window had its turn."""

    def __init__(self):
        self._timer = QtCore.QTimer(interval=10)
        self._timer.timeout.connect(self._tick)
        self.times = []

    def __enter__(self):
        self._timer.start()
        self._tick()
        return self

    def __exit__(self, *_):
        self._tick()
        self._timer.stop()

    def _tick(self):
        self.times.append(time.monotonic())

    @property
    def longest(self):
        return max(later - earlier for earlier, later in zip(self.times, self.times[1:]))


def test_closing_while_loading(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    set_preference_list("Libraries", [str(many)])
    dock = find_parts.show_find_parts()
    window.wait_until(lambda: "info files read" in window.widget("ThinPart_LibraryProgress").text())
    assert workers()
    dock.close()
    window.wait_until(lambda: not workers(), 20)


def test_stopping_a_refresh_keeps_what_was_read(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    set_preference_list("Libraries", [str(many)])
    dock = find_parts.show_find_parts()
    choose(dock, 1)
    window.wait_until(lambda: "info files read" in window.text("ThinPart_LibraryProgress"))
    window.click("ThinPart_StopRefresh")
    ready(dock)
    count = int(status().partition(" of ")[0].replace(",", ""))
    assert 0 < count < MANY


def test_the_window_has_its_turn_while_a_large_library_is_read_and_searched(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(many.with_name("cache of many")))
    with Ticks() as loading:
        dock = opened(many)
    print(f"loading {MANY}: {len(loading.times)} ticks, longest {loading.longest:.3f} s")
    assert len(loading.times) > 50
    assert status() == "20,000 of 20,000 parts"
    field = window.widget("ThinPart_FindWords")
    with Ticks() as typed:
        for text in ("p", "pl", "pla", "plat", "plate", "plate 1", "plate 12"):
            field.setText(text)
            window.settle(150)
        answered(dock)
    print(f"typing: {len(typed.times)} ticks, longest {typed.longest:.3f} s")
    assert len(typed.times) > 20
    assert 0 < len(cells(PART)) < MANY and all("plate" in text for text in cells(PART)[:50])
    field.setText("")
    answered(dock)
    with Ticks() as scrolled:
        bar = table().verticalScrollBar()
        for step in range(40):
            bar.setValue(bar.maximum() * step // 40)
            window.settle(20)
        window.wait_until(lambda: table().model().index(
            table().rowAt(5), PART).data() not in (None, WAITING))
    print(f"scrolling: {len(scrolled.times)} ticks, longest {scrolled.longest:.3f} s")
    assert len(scrolled.times) > 20
    with Ticks() as filtered:
        for name in ("thin", "thin_features", "normal"):
            check(dock, f"ThinPart_Category_{name}")
    print(f"filtering: {len(filtered.times)} ticks, longest {filtered.longest:.3f} s")
    assert len(filtered.times) > 5


def test_the_answer_to_an_outdated_question_is_thrown_away(many_opened):
    dock = many_opened
    shown = []
    dock._search.found.connect(lambda found: shown.append(found["count"]))
    write_now = window.widget("ThinPart_FindWords")
    write_now.setText("part")
    dock._ask()
    window.settle(60)  # it is on its way
    write_now.setText("part 000012")
    dock._ask()
    answered(dock)
    assert shown[-1] == 1 and cells(FILE) == [os.path.join("0000", "part 000012.step")]
    dock._search._take({"found": {"serial": 1}})  # an old answer that comes late
    assert cells(FILE) == [os.path.join("0000", "part 000012.step")]


def test_cancelling_a_preview(many_opened):
    dock = many_opened
    choose(dock, 2)
    window.click("ThinPart_ReclassifyPreview")
    window.wait_until(lambda: window.widget("ThinPart_ReclassifyBar").maximum() > 1
                      or window.text("ThinPart_ReclassifyMessage"))
    window.click("ThinPart_ReclassifyCancel")
    window.wait_until(lambda: "Stopped after" in window.text("ThinPart_ReclassifyMessage"))
    window.wait_until(window.widget("ThinPart_ReclassifyPreview").isEnabled, 20)
