# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that finds parts, as its tests use it: libraries to search, and what a user does there."""

import shutil
import subprocess

import pytest
import window_actions as window
from made_library import make_large_library

from thinpart_workbench.freecad_adapter.preferences import set_preference_list
from thinpart_workbench.freecad_adapter.python_beside_freecad import python_environment
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.library import command as find_parts
from thinpart_workbench.gui.library.details import PartDetails
from thinpart_workbench.gui.library.filters_page import FiltersPage
from thinpart_workbench.gui.library.libraries_page import LibrariesPage
from thinpart_workbench.gui.processes.freecad_python import python_program
from thinpart_workbench.gui.tables.fetched_rows import WAITING

SAMPLES = ("plate.step", "block.step", "ribbed_block.FCStd", "ribbed_block.step", "tube.step",
           "heat_sink.FCStd", "assembly_of_three.FCStd")
MANY = 8000
SCORE, PART, CATEGORY, REASONS, THINNEST, SIZE, FILE = range(7)
"""The columns that are not hidden at first, or shown when parts are alike."""


@pytest.fixture(scope="session")
def classified(tmp_path_factory):
    """Samples, classified by the command line, and a file that cannot be."""
    folder = tmp_path_factory.mktemp("classified")
    for name in SAMPLES:
        shutil.copyfile(window.SAMPLES / name, folder / name)
    (folder / "damaged.thinpart.json").write_text("{")
    subprocess.run([python_program(), "-m", "thinpart_workbench", "classify", str(folder), "--profile", "paper"],
                   env=python_environment(), check=True, stdin=subprocess.DEVNULL, capture_output=True)
    return folder


@pytest.fixture
def library(classified, tmp_path, monkeypatch):
    """A library of its own for a test that may change it."""
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    shutil.copytree(classified, tmp_path / "library")
    return tmp_path / "library"


uses_many = pytest.mark.timeout(180)  # the first of them writes all these files
"""For the tests that take `many`."""


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
    window.wait_until(lambda: not workers())


def workers():
    """Processes of the panel that still run."""
    return window.workers("library_worker", "judging_worker")


def opened(*roots):
    """The panel, with some libraries read."""
    set_preference_list("Libraries", [str(each) for each in roots])
    dock = find_parts.show_find_parts()
    ready(dock)
    return dock


def ready(dock):
    window.wait_until(lambda: not dock.is_refreshing)
    answered(dock)


def answered(dock):
    window.settle(20)
    window.wait_until(lambda: not typing(dock) and not dock.is_waiting)
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


def details(dock):
    """The tabs of the selected part."""
    return dock.findChild(PartDetails)


def choices(dock):
    """The tabs of filters, libraries and reclassifying."""
    return dock.findChild(QtWidgets.QTabWidget, "ThinPart_FindChoices")


def filters(dock):
    """All filters together."""
    return dock.findChild(FiltersPage)


def add_library(dock, folder):
    """As the button does with the folder that was chosen."""
    dock.findChild(LibrariesPage).add(str(folder))


def tab(dock, page):
    details(dock).setCurrentIndex(page)
    window.settle(20)


def count_of(name):
    return int(window.widget(name).text().rpartition("(")[2].rstrip(")").replace(",", ""))


def choose(dock, index):
    choices(dock).setCurrentIndex(index)
    window.settle(20)


def trigger(name):
    menu = table().menu()
    next(each for each in menu.actions() if each.objectName() == name).trigger()
    window.settle(30)
