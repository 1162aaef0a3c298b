"""The window speaks the language that FreeCAD was started in; run_in_freecad.py starts it in several."""

import json
import re
import shutil
import sys
from pathlib import Path

import FreeCADGui as Gui
import pytest
import window_actions as window

from made_library import record_of, store
from seen_texts import seen
from thinpart_workbench.core.criteria import load_profile
from thinpart_workbench.core.descriptors import QUANTITIES
from thinpart_workbench.freecad_adapter.settings import set_preference, set_preference_list
from thinpart_workbench.gui import find_parts
from thinpart_workbench.gui.qt import QtCore
from thinpart_workbench.gui.result_table import CATEGORY
from thinpart_workbench.storage.info_file import info_path, read_info

TRANSLATIONS = Path(__file__).resolve().parents[2] / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

from texts_of_code import all_texts  # noqa: E402
from ts_file import read_ts  # noqa: E402

HORIZONTAL, TOOL_TIP = QtCore.Qt.Horizontal, QtCore.Qt.ToolTipRole
CODE = {"German": "de", "French": "fr"}.get(Gui.getLocale())
TEXTS = read_ts(TRANSLATIONS / f"ThinPart_{CODE}.ts") if CODE else {key: key[1] for key in all_texts()}


def said(text, context="ThinPart"):
    """How a text of the code is said in the language of this FreeCAD."""
    return TEXTS[context, text]


def below(text):
    return said(text, "ThinPartCore")


ENGLISH = re.compile("|".join(
    r"\b" + re.sub(r"\\\{[^}]*\\\}", ".*", re.escape(text.replace("&", "").strip())) + r"(?!\w)"
    for (_, text), translation in TEXTS.items()
    if translation != text and len(re.findall("[a-z]{3,}", text)) > 1))


def english(root):
    """What of it is English although it is translated."""
    return {text for text in seen(root) if CODE and ENGLISH.search(text.replace("&", ""))}


def header(view):
    model = view.model()
    return [model.headerData(column, HORIZONTAL) for column in range(model.columnCount())]


@pytest.fixture
def sample(tmp_path):
    import FreeCAD as App

    shutil.copyfile(window.SAMPLES / "ribbed_block.FCStd", tmp_path / "ribbed_block.FCStd")
    return App.openDocument(str(tmp_path / "ribbed_block.FCStd"))


def test_the_language_is_one_that_there_are_translations_for():
    assert CODE or Gui.getLocale() == "English"
    assert CODE is None or said("Thin part") != "Thin part"


def test_the_workbench_and_its_commands():
    assert Gui.listWorkbenches()["ThinPartWorkbench"].ToolTip == said(
        "Check before meshing whether a part is thin, and where")
    for command, text in (("ThinPart_Classify", "Classify part"), ("ThinPart_FindParts", "Find parts"),
                          ("ThinPart_ClassifyFolder", "Classify folder\u2026")):
        button = window.tool_button(command)
        assert button.defaultAction().text() == said(text, command)
        assert english(button) == set()


def test_the_panel_of_one_part(sample):
    window.classify()
    panel = window.widget("ThinPart_Panel")
    assert panel.windowTitle() == said("Classify part")
    assert window.text("ThinPart_Headline") == said("Part with thin features")
    title = below("Very thin wall on a filled part")
    assert title[1:] in window.text("ThinPart_Why") and "5" in window.text("ThinPart_Why")
    table = window.widget("ThinPart_CriteriaTable")
    names = [said(each) for each in ("Quantity", "Value", "Threshold", "Holds", "Margin")]
    assert header(table) == names
    assert title in table.topLevelItem(4).text(0)
    assert below(QUANTITIES[6].meaning) in table.topLevelItem(4).child(0).toolTip(0)
    assert english(panel) == set()
    record = read_info(info_path(sample.FileName))["parts"][0]
    assert record["evidence"][4]["title"] == "Very thin wall on a filled part"


def test_what_is_wrong_with_a_document(document):
    window.classify()
    assert window.text("ThinPart_Message") == below(
        "The document '{}' is empty: make or import a solid first.").format("Test")


def test_the_window_for_folders(tmp_path):
    shutil.copyfile(window.SAMPLES / "plate.step", tmp_path / "plate.step")
    (tmp_path / "empty.step").touch()
    window.press("ThinPart_ClassifyFolder")
    dialog = window.widget("ThinPart_FolderDialog")
    assert dialog.windowTitle() == said("Classify folder")
    assert english(dialog) == set()
    window.widget("ThinPart_Folder").setCurrentText("/no/such/folder")
    window.click("ThinPart_FolderStart")
    assert window.text("ThinPart_FolderMessage").endswith(
        said("There is no folder {}: choose another one.").format("/no/such/folder"))
    window.widget("ThinPart_Folder").setCurrentText(str(tmp_path))
    window.click("ThinPart_FolderStart")
    window.wait_until(window.widget("ThinPart_FolderStart").isEnabled)
    table = window.widget("ThinPart_FolderTable").model()
    told = {table.index(row, CATEGORY).data(): table.index(row, 0).data(TOOL_TIP) for row in range(table.rowCount())}
    failed = "\u2717 " + said("Failed: {}").format(below("the file or document holds nothing"))
    assert set(told) == {said("Thin part"), failed}
    assert told[failed] == below("{} is empty (0 bytes).").format("empty.step")
    assert said("{} of {} files").format(2, 2) in window.text("ThinPart_FolderProgress")
    assert english(dialog) == set()


def test_the_panel_that_finds_parts(tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    for shape in ("plate", "long_plate", "cube"):
        store(tmp_path / "library", f"{shape}.step", [record_of(shape)])
    (tmp_path / "library" / "damaged.thinpart.json").write_text("{")
    set_preference_list("Libraries", [str(tmp_path / "library")])
    dock = find_parts.show_find_parts()
    window.wait_until(lambda: not dock.is_refreshing and not dock.is_waiting)
    view = window.widget("ThinPart_FoundTable")
    rows = {view.model().part_at(row).label: row for row in range(view.model().rowCount())}
    damaged = view.model().index(rows.pop(None), 1).data(TOOL_TIP)
    assert damaged.startswith(below("The info file {} cannot be read ({}).").partition("{")[0])
    view.selectRow(rows["plate"])
    next(each for each in view.menu().actions() if each.objectName() == "ThinPart_FoundSimilar").trigger()
    window.wait_until(lambda: window.is_shown("ThinPart_EndLike") and not dock.is_waiting)
    window.settle(300)
    assert dock.windowTitle() == said("Find parts")
    choices = window.widget("ThinPart_FindChoices")
    assert choices.tabText(2) == said("Reclassify")
    assert choices.tabText(1).startswith(said("Libraries"))
    assert header(view)[3] == said("Why")
    reasons = view.model().index(0, 3).data().split(", ")
    assert reasons and set(reasons) <= {translation for (context, _), translation in TEXTS.items()
                                        if context == "ThinPartCore"}
    assert said("Thin part") in window.widget("ThinPart_Category_thin").text()
    assert window.widget("ThinPart_Criterion_1").toolTip() == below("Plate")
    window.widget("ThinPart_FindConditions").setText("D9 > 6")
    window.wait_until(lambda: window.is_shown("ThinPart_FindRefusal"))
    start = below("There is no quantity {} in the condition {}: there are {}.").partition("{")[0]
    assert start in window.text("ThinPart_FindRefusal")
    assert english(dock) == set()
    set_preference_list("Libraries", [])


def test_a_profile_of_ones_own_keeps_its_titles(tmp_path, sample):
    content = json.loads(json.dumps(load_profile("paper").content))
    content["categories"][1]["criteria"][0]["title"] = "Too thin to cast"
    (tmp_path / "own.json").write_text(json.dumps(content))
    set_preference("Profile", str(tmp_path / "own.json"))
    try:
        window.classify()
        table = window.widget("ThinPart_CriteriaTable")
        assert "Too thin to cast" in table.topLevelItem(4).text(0)
        assert below("Plate") in table.topLevelItem(0).text(0)
    finally:
        set_preference("Profile", None)


def test_the_language_can_be_changed_while_freecad_runs():
    from thinpart_workbench.gui.sentences import translated

    before = Gui.getLocale()
    try:
        Gui.setLocale("English")
        assert translated("It holds no triangles.") == "It holds no triangles."
        Gui.setLocale("German")
        assert translated("It holds no triangles.") == "Es enthält keine Dreiecke."
    finally:
        Gui.setLocale(before)
    assert Gui.getLocale() == before
