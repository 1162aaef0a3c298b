# SPDX-License-Identifier: LGPL-2.1-or-later
"""The examples of docs/extending.md that need FreeCAD: a file format, and a panel in its window."""

import json
import os

import made_meshes
import numpy as np
import pytest
from copied_program import answer, copied_program, copied_workbench
from started_freecad import start_freecad
from worked_examples import follow_example

READ = """
import json
from pathlib import Path
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.file_formats import CHOICES, ENDINGS, format_of
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.workflow.analysis.find_documents import find_documents

def refusal(name):
    try:
        read_parts(name)
    except ThinPartError as error:
        return error.kind, str(error)

part, = read_parts("plate.tri").parts
print(json.dumps({
    "label": part.label, "points": part.points.tolist(), "triangles": part.triangles.tolist(),
    "format": format_of("PLATE.TRI").name, "listed": ".tri" in ENDINGS, "choice": ".tri" in CHOICES["Mesh"],
    "found": [Path(each.path).name for each in find_documents(["."]).documents],
    "word": refusal("word.tri"), "corner": refusal("corner.tri"),
}))
"""

COUNT = """
import FreeCAD as App, FreeCADGui as Gui
import thinpart_workbench
from thinpart_workbench.gui.application.qt import QtWidgets

def add(name, length):
    box = document.addObject("Part::Box", name)
    box.Length, box.Width, box.Height = length, 10, 10
    document.recompute()

def find(kind, name):
    return Gui.getMainWindow().findChild(kind, name)

Gui.activateWorkbench("ThinPartWorkbench")
before = Gui.isCommandActive("ThinPart_Count")
document = App.newDocument("Test")
add("One", 10)
add("Two", 20)
Gui.runCommand("ThinPart_Count")
answer = find(QtWidgets.QLabel, "ThinPart_CountAnswer")
first, is_open = answer.text(), bool(Gui.Control.activeDialog())
add("Three", 30)
find(QtWidgets.QPushButton, "ThinPart_CountAgain").click()
buttons = Gui.getMainWindow().findChildren(QtWidgets.QToolButton)
tell({
    "package": os.path.dirname(os.path.realpath(thinpart_workbench.__file__)),
    "in_tool_bar": "ThinPart_Count" in [button.defaultAction().objectName() for button in buttons if button.defaultAction()],
    "active": [before, Gui.isCommandActive("ThinPart_Count")], "is_open": is_open, "said": [first, answer.text()],
})
"""


@pytest.fixture
def package(tmp_path):
    return copied_program(tmp_path)


def lines_of(points, triangles):
    return "".join(f"{letter} {' '.join(map(str, row))}\n"
                   for letter, rows in (("v", points.tolist()), ("t", triangles.tolist())) for row in rows)


def test_a_new_mesh_format_is_read_and_listed(package):
    follow_example("A file format", package)
    points, triangles = made_meshes.box(100, 80, 2)
    good = lines_of(points, triangles)
    for name, text in (("plate", good), ("word", good + "v 1 2 three\n"), ("corner", good + f"t 0 1 {len(points)}\n")):
        (package.parent / f"{name}.tri").write_text(text, encoding="utf-8")
    told = json.loads(answer(package, READ))
    assert told["label"] == "plate" and np.array_equal(told["points"], points)
    assert np.array_equal(told["triangles"], triangles)
    assert told["format"] == "TRI" and told["listed"] and told["choice"]
    assert {"plate.tri", "word.tri", "corner.tri"} <= set(told["found"])
    for name, problem in (("word", "three"), ("corner", "a triangle has a corner that is not there")):
        kind, sentence = told[name]
        assert kind == "unreadable" and problem in sentence
        assert sentence.startswith(f"{name}.tri is damaged or not what its ending says (")


def test_a_new_panel_opens_in_the_window(tmp_path):
    home, program = tmp_path / "home", tmp_path / "program"
    home.mkdir()
    program.mkdir()
    package = copied_workbench(program)
    follow_example("A panel", package)
    told = start_freecad(home, COUNT, "-M", os.fspath(program))
    assert told["package"] == os.path.realpath(package)
    assert told["in_tool_bar"] and told["active"] == [False, True] and told["is_open"]
    assert told["said"] == ["Different parts in this document: 2", "Different parts in this document: 3"]
