# SPDX-License-Identifier: LGPL-2.1-or-later
"""The libraries of the panel: other thresholds, folders that come and go, and very many parts."""

import json
import os
import shutil

import pytest
import window_actions as window
from find_panel import (  # noqa: F401 - fixtures among them
    FILE,
    MANY,
    PART,
    add_library,
    answered,
    cells,
    check,
    choices,
    choose,
    classified,
    count_of,
    details,
    filters,
    library,
    many,
    no_libraries,
    opened,
    ready,
    row_of,
    select,
    status,
    table,
    trigger,
    uses_many,
    workers,
    write,
)
from made_library import make_large_library

from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.preferences import preference_list, set_preference_list
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtWidgets
from thinpart_workbench.gui.library import command as find_parts
from thinpart_workbench.gui.library.search_client import SearchClient
from thinpart_workbench.gui.processes.conversation import Conversation
from thinpart_workbench.gui.reclassify.reclassify_page import ReclassifyPage
from thinpart_workbench.gui.tables.fetched_rows import WAITING
from thinpart_workbench.gui.widgets.controls import plain
from thinpart_workbench.storage.info.info_file import read_info


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


def reclassify_page(dock):
    """The page that reclassifies, once it has counted."""
    choose(dock, 2)
    page = dock.findChild(ReclassifyPage)
    window.wait_until(lambda: not page.is_waiting)
    window.settle(20)
    return page


def chosen(page, profile):
    window.widget("ThinPart_ReclassifyProfile").choose(str(profile))
    window.wait_until(lambda: not page.is_waiting)
    window.settle(20)


def test_reclassify_shows_what_would_change_and_writes_it(library, other_profile):
    dock = opened(library)
    page = reclassify_page(dock)
    before = {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")}
    chosen(page, other_profile)
    assert "of 9 parts change their category" in window.text("ThinPart_ReclassifyChanges")
    assert "damaged.thinpart.json" in window.text("ThinPart_ReclassifyCountMessage")
    changes = window.widget("ThinPart_ReclassifyChangesTable")
    assert {changes.item(row, 1).text() for row in range(changes.rowCount())} == {"Thin part"}
    assert before == {path.name: path.read_bytes() for path in library.glob("*.thinpart.json")}
    assert window.widget("ThinPart_ReclassifyWrite").isEnabled()
    said = []
    window.answer("ThinPart_ReclassifyQuestion", lambda box: (
        said.append(box.text()), box.button(QtWidgets.QMessageBox.Yes).click()))
    window.click("ThinPart_ReclassifyWrite")
    window.wait_until(lambda: "were updated" in window.text("ThinPart_ReclassifyMessage"))
    assert said[0].startswith("7 info files will be updated")
    assert "damaged.thinpart.json" in window.text("ThinPart_ReclassifyMessage")
    window.wait_until(lambda: not page.is_waiting)
    assert window.text("ThinPart_ReclassifyChanges") == "0 of 9 parts change their category."
    assert not window.widget("ThinPart_ReclassifyWrite").isEnabled()
    ready(dock)
    assert count_of("ThinPart_Category_thin") == 9
    assert read_info(library / "block.step.thinpart.json")["profile"]["name"] == "generous"
    assert (library / "damaged.thinpart.json").read_text() == "{"


def test_a_part_that_changes_is_shown_in_the_list(library, other_profile):
    dock = opened(library)
    chosen(reclassify_page(dock), other_profile)
    changes, parts = window.widget("ThinPart_ReclassifyChangesTable"), window.widget("ThinPart_ReclassifyParts")
    changes.selectRow(0)
    window.wait_until(lambda: parts.count())
    parts.setCurrentRow(0)
    window.click("ThinPart_ReclassifyFindPart")
    window.wait_until(lambda: table().current_part is not None)
    assert table().current_part.file == parts.item(0).toolTip()


def judged_by_another_version(library, names):
    """As if the profile *paper* had had another floor when it judged these documents."""
    for name in names:
        path = library / f"{name}.thinpart.json"
        content = json.loads(path.read_text())
        content["profile"]["area_floor"] = 0.002
        path.write_text(json.dumps(content))


def test_what_another_version_of_a_profile_has_judged_is_said_once(library):
    note = "ThinPart_JudgedOtherwise"
    judged_by_another_version(library, ["plate.step", "tube.step"])
    dock = opened(library)
    assert window.text(note) == "2 info files were judged by another version of the profile paper."
    window.click(f"{note}Reclassify")
    page = dock.findChild(ReclassifyPage)
    window.wait_until(lambda: not page.is_waiting and window.widget("ThinPart_ReclassifyWrite").isEnabled())
    assert window.widget("ThinPart_ReclassifyProfile").currentData() == "paper"
    assert not window.widget(note).isVisible()
    find_parts.end_find_parts()
    opened(library)
    assert not window.widget(note).isVisible()  # said before
    find_parts.end_find_parts()
    set_preference_list("ProfileVersionsTold", [f"paper 123456789abc {library}"])  # the profile has changed since
    opened(library)
    assert window.widget(note).isVisible()
    window.click(f"{note}Hide")
    assert not window.widget(note).isVisible()
    find_parts.end_find_parts()
    opened(library)
    assert not window.widget(note).isVisible()


def test_a_profile_that_is_none_is_refused(library, tmp_path):
    dock = opened(library)
    page = reclassify_page(dock)
    (tmp_path / "none.json").write_text("[]")
    chosen(page, tmp_path / "none.json")
    assert "is not a ThinPart profile" in window.text("ThinPart_ReclassifyChanges")
    assert not window.widget("ThinPart_ReclassifyWrite").isEnabled()


def test_adding_and_removing_libraries(library, tmp_path):
    dock = opened(library)
    choose(dock, 1)
    inner = library / "inner"
    inner.mkdir()
    add_library(dock, inner)
    assert "is in the list already" in window.text("ThinPart_LibraryProblems")
    other = tmp_path / "other"
    other.mkdir()
    shutil.copyfile(library / "plate.step.thinpart.json", other / "plate.step.thinpart.json")
    add_library(dock, other)
    ready(dock)
    assert status() == "11 of 11 parts"
    entries = window.widget("ThinPart_LibraryList")
    entries.item(0).setSelected(True)
    window.click("ThinPart_RemoveLibrary")
    ready(dock)
    assert status() == "1 of 1 parts" and preference_list("Libraries") == [str(other)]
    add_library(dock, tmp_path)
    ready(dock)
    assert preference_list("Libraries") == [str(tmp_path)]
    assert (library / "plate.step.thinpart.json").is_file()


def test_a_folder_that_is_gone_keeps_what_was_known_and_says_so(library):
    dock = opened(library)
    library.rename(library.with_name("elsewhere"))
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    assert f"The folder {library} no longer exists" in window.text("ThinPart_LibraryProblems")
    assert status() == "10 of 10 parts"
    part = table().model().row_at(row_of(None, "plate.step"))
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
    assert details(dock).part is not None and part is not None
    assert dock.width() <= width + 2
    for tabs in (choices(dock), details(dock)):
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


@uses_many
def test_closing_while_loading(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    set_preference_list("Libraries", [str(many)])
    dock = find_parts.show_find_parts()
    window.wait_until(lambda: "info files read" in window.widget("ThinPart_LibraryProgress").text())
    assert workers()
    dock.close()
    window.wait_until(lambda: not workers())


@uses_many
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


@uses_many
def test_the_window_has_its_turn_while_a_large_library_is_read_and_searched(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(many.with_name("cache of many")))
    with window.Turns() as loading:
        dock = opened(many)
    assert loading.count > 5
    assert status() == f"{MANY:,} of {MANY:,} parts"
    field = window.widget("ThinPart_FindWords")
    with window.Turns() as typed:
        for text in ("p", "pl", "pla", "plat", "plate", "plate 1", "plate 12"):
            field.setText(text)
            window.settle(150)
        answered(dock)
    assert typed.count > 20
    assert 0 < len(cells(PART)) < MANY and all("plate" in text for text in cells(PART)[:50])
    field.setText("")
    answered(dock)
    with window.Turns() as scrolled:
        bar = table().verticalScrollBar()
        for step in range(40):
            bar.setValue(bar.maximum() * step // 40)
            window.settle(20)
        window.wait_until(lambda: table().model().index(
            table().rowAt(5), PART).data() not in (None, WAITING))
    assert scrolled.count > 20
    with window.Turns() as filtered:
        for name in ("thin", "thin_features", "normal"):
            check(dock, f"ThinPart_Category_{name}")
    assert filtered.count > 5


@uses_many
def test_the_answer_to_an_outdated_question_is_thrown_away(many_opened):
    dock = many_opened
    shown = []
    search = dock.findChild(SearchClient)
    search.found.connect(lambda found: shown.append(found["count"]))
    write_now = window.widget("ThinPart_FindWords")
    write_now.setText("part")
    filters(dock).changed.emit()
    window.settle(60)  # it is on its way
    write_now.setText("part 000012")
    filters(dock).changed.emit()
    answered(dock)
    assert shown[-1] == 1 and cells(FILE) == [os.path.join("0000", "part 000012.step")]
    search.findChild(Conversation).received.emit({"found": {"serial": 1}})  # an old answer that comes late
    assert cells(FILE) == [os.path.join("0000", "part 000012.step")]


@pytest.mark.timeout(120)
def test_writing_is_named_in_the_status_bar_and_cancelled(classified, other_profile, tmp_path):
    make_large_library(tmp_path / "own", sorted(classified.glob("*.step.thinpart.json")), 1500)
    dock = opened(tmp_path / "own")
    page = reclassify_page(dock)
    chosen(page, other_profile)
    window.answer("ThinPart_ReclassifyQuestion", lambda box: box.button(QtWidgets.QMessageBox.Yes).click())
    window.click("ThinPart_ReclassifyWrite")
    window.wait_until(lambda: window.widget("ThinPart_ReclassifyWriteBar").maximum() > 1)
    assert window.widget("ThinPart_RunningJobs").text().startswith("Classifying again by another profile")
    window.click("ThinPart_ReclassifyCancel")
    window.wait_until(lambda: "Stopped: " in window.text("ThinPart_ReclassifyMessage"))
    assert window.widget("ThinPart_ReclassifyProfile").isEnabled()
    window.wait_until(lambda: not page.is_waiting)
    assert window.widget("ThinPart_ReclassifyWrite").isEnabled()


@uses_many
def test_the_status_bar_leads_to_the_page_of_each_job(many, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    set_preference_list("Libraries", [str(many)])
    dock = find_parts.show_find_parts()
    window.wait_until(lambda: window.is_shown("ThinPart_RunningJobs"))
    pages = window.widget("ThinPart_FindChoices")
    other = QtWidgets.QDialog(dock)
    try:
        choose(dock, 2)
        dock.hide()
        window.click("ThinPart_RunningJobs")
        assert dock.isVisible() and plain(pages.tabText(pages.currentIndex())).startswith("Libraries")
        lifelong.running_jobs.show("reading", "Reading something", other, lambda: choose(dock, 0))
        assert window.widget("ThinPart_RunningJobs").text().startswith("2 jobs: ")
        window.click("ThinPart_RunningJobs")
        menu = QtWidgets.QApplication.activePopupWidget()
        assert [action.text() for action in menu.actions()] == ["Refreshing the libraries", "Reading something"]
        menu.actions()[1].trigger()
        menu.close()
        assert other.isVisible() and pages.currentIndex() == 0
    finally:
        lifelong.running_jobs.end("reading")
        other.deleteLater()
    dock.close()
    window.wait_until(lambda: not workers())
    assert not window.is_shown("ThinPart_RunningJobs")
