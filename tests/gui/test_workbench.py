# SPDX-License-Identifier: LGPL-2.1-or-later
"""The workbench is there, and its commands are active when they make sense."""

import xml.etree.ElementTree as ElementTree
from importlib import import_module
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
import window_actions as window

from thinpart_workbench.gui.commands import COMMANDS

ROOT = Path(__file__).resolve().parents[2]


def test_the_workbench_has_its_tool_bar_and_menu():
    assert "ThinPartWorkbench" in Gui.listWorkbenches()
    assert "ThinPart" in Gui.activeWorkbench().listToolbars()
    for command in ("ThinPart_Classify", "ThinPart_ClassifyFolder", "ThinPart_ClearColours",
                    "ThinPart_Preferences"):
        button = window.tool_button(command)
        assert button.toolTip() and not button.icon().isNull()


@pytest.mark.parametrize("name", COMMANDS)
def test_what_a_command_opens_is_there(name):
    module, _, opened = COMMANDS[name].opens.partition(":")
    assert callable(getattr(import_module(f"thinpart_workbench.gui.{module}"), opened))


def test_package_xml_names_the_workbench_and_files_that_exist():
    manifest = ElementTree.parse(ROOT / "package.xml").getroot()
    names = {each.tag.rpartition("}")[2]: each.text for each in manifest.iter()}
    assert names["classname"] in Gui.listWorkbenches()
    assert names["subdirectory"] == "./"
    assert (ROOT / names["icon"]).is_file()


def test_without_a_document_nothing_can_be_pressed():
    assert not Gui.isCommandActive("ThinPart_Classify")
    assert not Gui.isCommandActive("ThinPart_ClearColours")


def test_called_without_a_document_it_says_so():
    COMMANDS["ThinPart_Classify"].Activated()
    # Not whether it is in sight: a new FreeCAD 1.1 keeps its tasks out of sight until there is a document.
    said = window.widget("ThinPart_Message").text
    window.wait_until(lambda: said() == "There is no document: open or create one first.")


def test_an_empty_document_is_said_to_be_empty(document):
    window.classify()
    assert "is empty" in window.text("ThinPart_Message")
    assert not window.is_shown("ThinPart_Headline")


def test_clearing_is_possible_only_after_colouring(document):
    window.add_ribbed_block(document)
    assert not Gui.isCommandActive("ThinPart_ClearColours")
    window.classify()
    assert Gui.isCommandActive("ThinPart_ClearColours")
    window.press("ThinPart_ClearColours")
    assert not Gui.isCommandActive("ThinPart_ClearColours")


def test_another_open_task_is_left_alone(document):
    class Task:
        form = window.QtWidgets.QWidget()

    Gui.Control.showDialog(Task())
    window.press("ThinPart_Classify")
    window.settle(50)
    assert "one task at a time" in Gui.getMainWindow().statusBar().currentMessage()
    assert not window.is_shown("ThinPart_Panel") and Task.form.isVisible()
    assert App.ActiveDocument is document
