# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the panel that finds what libraries have more than once."""

import csv
import os
import shutil

import FreeCAD as App
import Part
import pytest
import window_actions as window
from find_panel import choose, details, no_libraries, opened, ready  # noqa: F401 - a fixture among them
from window_actions import V

from thinpart_workbench.api.classification import classify
from thinpart_workbench.freecad_adapter.preferences import set_preference_list
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.library.dock import DUPLICATES
from thinpart_workbench.gui.library.duplicates_page import BY_DOCUMENTS, BY_RECORDS, FAMILIES
from thinpart_workbench.gui.library.duplicates_view import DuplicatesView

SUMMARY, TABLE = "ThinPart_DuplicatesSummary", "ThinPart_DuplicatesTable"


def bracket(length=60.0):
    base, flange, lug = Part.makeBox(length, 30, 4), Part.makeBox(4, 30, 25), Part.makeBox(14, 8, 12, V(20, 22, 4))
    return base.fuse([flange, lug]).cut(Part.makeCylinder(4, 20, V(45, 12, -5))).removeSplitter()


@pytest.fixture(scope="module")
def drawer(tmp_path_factory):
    folder = tmp_path_factory.mktemp("drawer")
    turned = bracket()
    turned.Placement = App.Placement(V(210, -40, 9), App.Rotation(V(1, 2, 0.5), 77))
    inches = bracket()
    inches.scale(1 / 25.4)
    for name, shape in {"bracket": bracket(), "turned": turned, "left": bracket().mirror(V(), V(1, 0, 0)),
                        "inches": inches, "longer": bracket(64.0), "ball": Part.makeSphere(12)}.items():
        shape.exportStep(str(folder / f"{name}.step"))
    later = (folder / "bracket.step").stat().st_mtime + 60.0
    os.utime(folder / "bracket.step", (later, later))  # the latest of them is the one to keep
    for file in sorted(folder.glob("*.step")):
        classify(file, write_info=True)
    return folder


@pytest.fixture
def library(drawer, tmp_path, monkeypatch):
    """A library of its own, with a cache of its own."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    return shutil.copytree(drawer, tmp_path / "library")


def search(way):
    window.widget("ThinPart_DuplicatesWay").setCurrentIndex(way)
    window.click("ThinPart_DuplicatesSearch")
    window.wait_until(lambda: window.is_shown("ThinPart_DuplicatesSearch"))
    window.settle(50)


def rows():
    """What the table shows: list of list of str."""
    model = window.widget(TABLE).model()
    return [[str(model.index(row, column).data()).replace("\u00a0", " ") for column in range(model.columnCount())]
            for row in range(model.rowCount())]


@pytest.mark.timeout(180)  # processes start, and read five documents
def test_groups_are_shown_with_their_evidence_and_the_one_to_keep(library):
    dock = opened(library)
    choose(dock, DUPLICATES)
    assert not window.is_shown("ThinPart_FoundTable")
    search(BY_RECORDS)
    assert window.text(SUMMARY) == "Compared: 6 parts. Groups: 4. Parts besides those to keep: 4."
    found = rows()
    assert [row[:4:3] for row in found] == [[str(group), name] for group, other in enumerate(
        ("turned.step", "left.step", "inches.step", "longer.step"), 1) for name in ("bracket.step", other)]
    assert all(row[1] == "to keep" and row[4:] == ["", "", "Kept because: the latest"] for row in found[::2])
    assert [row[1] for row in found[1::2]] == ["identical", "mirror image", "0.0394 times as large", "alike"]
    search(BY_DOCUMENTS)
    found = rows()
    assert [row[1] for row in found[1::2]] == ["identical", "mirror image", "0.0394 times as large", "alike"]
    assert found[1][5] == "100 %" and found[1][6] == "The same form: its surfaces are at most 0.0001 mm apart."
    assert found[7][4] == "4" and "It is 4 mm longer." in found[7][6]
    assert window.text("ThinPart_DuplicatesProblems") == ""


def test_a_part_is_opened_and_its_details_are_shown(library):
    dock = opened(library)
    choose(dock, DUPLICATES)
    search(BY_RECORDS)
    view = dock.findChild(DuplicatesView)
    view.selectRow(1)
    part = view.current_part
    window.wait_until(lambda: details(dock).part is not None and details(dock).part.file == part.file)
    window.wait_until(lambda: window.is_shown("ThinPart_Headline"))
    view.doubleClicked.emit(view.currentIndex())
    window.wait_until(lambda: App.ActiveDocument is not None)
    assert App.ActiveDocument.Objects[-1].Shape.isValid()
    menu = view.menu(part)
    assert {"ThinPart_DuplicateOpen", "ThinPart_DuplicateFolder", "ThinPart_TableCsv"} <= {
        action.objectName() for action in menu.actions()}
    menu.deleteLater()
    choose(dock, 0)
    assert window.is_shown("ThinPart_FoundTable")


@pytest.mark.timeout(180)  # processes start, read two documents and compare them
def test_the_difference_to_the_one_to_keep_is_shown(library):
    dock = opened(library)
    choose(dock, DUPLICATES)
    search(BY_RECORDS)
    view = dock.findChild(DuplicatesView)
    view.selectRow(0)
    assert not window.is_shown("ThinPart_KnownText")
    view.selectRow(7)
    assert "It is 4 mm longer." in window.text("ThinPart_KnownText").replace("\u00a0", " ")
    window.click("ThinPart_ShowDifference")
    window.wait_until(lambda: window.is_shown("ThinPart_DifferenceLegend"))
    assert window.text("ThinPart_DifferenceMeaning0") == "not in bracket.step"
    assert App.ActiveDocument.Objects[-1].Shape.BoundBox.XLength == pytest.approx(64.0)
    window.click("ThinPart_OpenKnown")
    window.wait_until(lambda: len(App.listDocuments()) == 2)
    view.selectRow(1)
    assert not window.is_shown("ThinPart_DifferenceLegend") and not window.is_shown("ThinPart_ShowDifference")


def test_the_groups_are_exported(library, tmp_path):
    dock = opened(library)
    choose(dock, DUPLICATES)
    search(BY_RECORDS)
    view = dock.findChild(DuplicatesView)
    view.write_csv(str(tmp_path / "groups.csv"))
    window.wait_until(lambda: os.path.exists(tmp_path / "groups.csv"))
    window.wait_until(lambda: view.can_save)
    with open(tmp_path / "groups.csv", newline="", encoding="utf-8-sig") as file:
        table = list(csv.DictReader(file))
    assert len(table) == 8 and sum(row["kind"] == "reference" for row in table) == 4
    assert {row["kind"] for row in table} == {"reference", "identical", "mirrored", "scaled", "alike"}


def test_families_are_shown_with_what_varies(library):
    dock = opened(library)
    choose(dock, DUPLICATES)
    search(FAMILIES)
    assert window.text(SUMMARY).startswith("Families: 1. Parts in them: ")
    dimensions = {row[2]: row[3] for row in rows()}
    assert dimensions["longer.step"].startswith("length 64 mm") and dimensions["bracket.step"].startswith("length 60 mm")


def test_a_search_is_cancelled_and_ends_with_the_dock(library):
    dock = opened(library)
    choose(dock, DUPLICATES)
    window.widget("ThinPart_DuplicatesWay").setCurrentIndex(BY_DOCUMENTS)
    window.click("ThinPart_DuplicatesSearch")
    assert window.is_shown("ThinPart_DuplicatesBar") and window.text("ThinPart_RunningJobs") == "Searching for duplicates"
    window.click("ThinPart_DuplicatesCancel")
    assert window.text(SUMMARY) == "Cancelled." and not window.is_shown("ThinPart_RunningJobs")
    window.click("ThinPart_DuplicatesSearch")
    window.settle(300)
    dock.close()
    window.wait_until(lambda: not window.workers("request_worker"))
    assert not lifelong.requests.is_busy


def test_without_libraries_the_page_says_what_to_do(tmp_path):
    dock = opened()
    choose(dock, DUPLICATES)
    assert window.text(SUMMARY) == "Add a folder with classified parts under 'Libraries'."
    assert not window.widget("ThinPart_DuplicatesSearch").isEnabled()
    set_preference_list("Libraries", [])
    ready(dock)
