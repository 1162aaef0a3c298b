# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog for whole folders, as its tests use it: folders to classify, and what a user does there."""

import shutil

import FreeCAD as App
import pytest
import window_actions as window

from thinpart_workbench.freecad_adapter.preferences import GROUP
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets

MANY = 5
FILE, PART, CATEGORY, CRITERIA, BOX, RATIO, THINNEST, INSTANCES, LABELS = range(9)
"""The columns where nothing is checked."""

CANCELLED = "cancelled: finished results are saved, Start continues with the rest"


@pytest.fixture(autouse=True)
def no_choices():
    """Nothing is known of earlier choices, before and after."""
    _forget_choices()
    yield
    _forget_choices()


def _forget_choices():
    group = App.ParamGet(GROUP)
    for kind, name, _ in group.GetContents() or ():
        if name.startswith("Folder"):
            {"String": group.RemString, "Integer": group.RemInt}[kind](name)


@pytest.fixture
def dialog():
    """The dialog, opened as a user does."""
    window.press("ThinPart_ClassifyFolder")
    window.wait_until(lambda: window.is_shown("ThinPart_FolderDialog"))
    return window.widget("ThinPart_FolderDialog")


@pytest.fixture
def folder(tmp_path):
    """Three documents with five parts, and a damaged file."""
    parts = tmp_path / "parts"
    (parts / "inner").mkdir(parents=True)
    for name, place in (("block.FCStd", "block.FCStd"), ("plate.step", "inner/plate.step"),
                        ("assembly_of_three.FCStd", "assembly.FCStd")):
        shutil.copyfile(window.SAMPLES / name, parts / place)
    (parts / "damaged.step").write_text("ISO-10303-21;\nthis is no STEP file\n")
    return parts


@pytest.fixture
def many(tmp_path):
    """So many documents that some are left when the first is done."""
    parts = tmp_path / "many"
    parts.mkdir()
    for number in range(MANY):
        shutil.copyfile(window.SAMPLES / "flange.FCStd", parts / f"flange{number:02}.FCStd")
    return parts


def choose(folder, **choices):
    """Fill the form."""
    window.widget("ThinPart_Folder").setCurrentText(str(folder))
    window.widget("ThinPart_FolderJobs").setValue(choices.pop("jobs", 2))
    for name, text in choices.items():
        window.widget(f"ThinPart_Folder{name}").setText(text)


def start(folder, **choices):
    choose(folder, **choices)
    window.click("ThinPart_FolderStart")


def message():
    return window.text("ThinPart_FolderMessage")


def progress():
    return window.text("ThinPart_FolderProgress")


def wait_for_end():
    window.wait_until(lambda: window.widget("ThinPart_FolderStart").isEnabled())


def run(folder, **choices):
    start(folder, **choices)
    wait_for_end()


def model():
    return window.widget("ThinPart_FolderTable").model()


def column(number):
    return [model().index(row, number).data() for row in range(model().rowCount())]


def count_of(category):
    """The count beside a category's check box."""
    return int(window.widget(f"ThinPart_Show_{category}").text().rpartition("(")[2].rstrip(")"))


def sort_by(number, order=QtCore.Qt.AscendingOrder):
    window.widget("ThinPart_FolderTable").sortByColumn(number, order)


def select(part):
    row = column(PART).index(part)
    view = window.widget("ThinPart_FolderTable")
    view.selectRow(row)
    return view.model().index(row, FILE)


def press_key(target, key):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        QtWidgets.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier))


def info_files(folder):
    return sorted(folder.rglob("*.thinpart.json"))


def press_answer(name):
    return lambda box: window.mouse_click(next(
        each for each in box.buttons() if each.objectName() == f"ThinPart_Folder{name}"))
