# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window speaks the language of FreeCAD: the one that it was started in, and those that are chosen later."""

import importlib
import json
import re
import shutil
import sys
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Mesh
import pytest
import window_actions as window
from made_library import record_of, store
from seen_texts import seen

from thinpart_workbench.core.descriptors.descriptor_table import QUANTITIES
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.freecad_adapter.preferences import set_preference, set_preference_list
from thinpart_workbench.gui import workbench
from thinpart_workbench.gui.application.qt import QtCore
from thinpart_workbench.gui.library import command as find_parts
from thinpart_workbench.storage.info.info_file import info_path, read_info

TRANSLATIONS = Path(__file__).resolve().parents[2] / "resources" / "translations"
sys.path.insert(0, str(TRANSLATIONS))

from texts_of_code import all_texts  # noqa: E402
from ts_file import read_ts  # noqa: E402

HORIZONTAL, TOOL_TIP = QtCore.Qt.Horizontal, QtCore.Qt.ToolTipRole
CODES = {"German": "de", "French": "fr"}
STARTED = Gui.getLocale()
# The ordinary run is English. The one that starts translated goes on to the other languages, as people do who change theirs.
SPOKEN = [STARTED, *(each for each in CODES if STARTED in CODES and each != STARTED)]


def texts_in(name):
    """The language's text for each (context, text) of the code."""
    return read_ts(TRANSLATIONS / f"ThinPart_{CODES[name]}.ts") if name in CODES else {key: key[1] for key in all_texts()}


TEXTS = {name: texts_in(name) for name in ("English", *CODES)}


class Language:
    """One of FreeCAD's languages, and how ThinPart speaks it."""

    def __init__(self, name):
        self.name, self.texts = name, TEXTS[name]
        self._foreign = re.compile("|".join(
            r"\b" + re.sub(r"\\\{[^}]*\\\}", ".*", re.escape(text.replace("&", "").strip())) + r"(?!\w)"
            for texts in TEXTS.values() for key, text in texts.items()
            if text != self.texts[key] and len(re.findall(r"[^\W\d_]{3,}", re.sub(r"\{[^}]*\}", "", text))) > 1))

    def said(self, text, context="ThinPart"):
        """How a text of the code is said."""
        return self.texts[context, text]

    def below(self, text):
        """How a sentence of the layers below the window is said."""
        return self.said(text, "ThinPartCore")

    def foreign(self, root):
        """What of it is in another language, such as English, although it is translated."""
        return {text for text in seen(root) if self._foreign.search(text.replace("&", ""))}


@pytest.fixture(scope="module", params=SPOKEN, autouse=True)
def language(request):
    """The language that FreeCAD speaks meanwhile."""
    if request.param != STARTED:
        Gui.setLocale(request.param)
    assert Gui.getLocale() == request.param
    yield Language(request.param)
    Gui.setLocale(STARTED)


def header(view):
    model = view.model()
    return [model.headerData(column, HORIZONTAL) for column in range(model.columnCount())]


@pytest.fixture
def sample(tmp_path):
    shutil.copyfile(window.SAMPLES / "ribbed_block.FCStd", tmp_path / "ribbed_block.FCStd")
    return App.openDocument(str(tmp_path / "ribbed_block.FCStd"))


def test_the_language_is_one_that_there_are_translations_for(language):
    assert (language.said("Thin part") == "Thin part") == (Gui.getLocale() == "English")


def test_the_workbench_and_its_commands(language):
    # FreeCAD asks for this one when it starts.
    tool_tip = (Gui.listWorkbenches()["ThinPartWorkbench"].ToolTip if language.name == STARTED
                else importlib.reload(workbench).TOOL_TIP)
    assert tool_tip == language.said("Check before meshing whether a part is thin, and where")
    for command, text in (("ThinPart_Classify", "Classify part"), ("ThinPart_FindParts", "Find parts"),
                          ("ThinPart_ClassifyFolder", "Classify folder\u2026")):
        button = window.tool_button(command)
        assert button.defaultAction().text() == language.said(text, command)
        assert language.foreign(button) == set()


def test_the_panel_of_one_part(language, sample):
    window.classify()
    panel = window.widget("ThinPart_Panel")
    assert panel.windowTitle() == language.said("Classify part")
    assert window.text("ThinPart_Headline") == language.said("Part with thin features")
    title = language.below("Very thin wall on a filled part")
    assert title[1:] in window.text("ThinPart_Why") and "5" in window.text("ThinPart_Why")
    table = window.widget("ThinPart_CriteriaTable")
    names = [language.said(each) for each in ("Quantity", "Value", "Threshold", "Holds", "Margin")]
    assert header(table) == names
    assert title in table.topLevelItem(4).text(0)
    assert language.below(QUANTITIES[6].meaning) in table.topLevelItem(4).child(0).toolTip(0)
    assert language.foreign(panel) == set()
    record = read_info(info_path(sample.FileName))["parts"][0]
    assert record["evidence"][4]["title"] == "Very thin wall on a filled part"


def test_what_is_wrong_with_a_document(language, document):
    window.classify()
    assert window.text("ThinPart_Message") == language.below(
        "The document '{document}' is empty: make or import a solid first.").format(document="Test")


def add_mesh(document, corners, triangles):
    document.addObject("Mesh::Feature", "Soup").Mesh = Mesh.Mesh([[corners[each] for each in one] for one in triangles])
    document.recompute()


def test_warnings_and_why_nothing_can_be_told(language, document):
    box = Mesh.createBox(10, 10, 10)
    corners, triangles = box.Topology
    add_mesh(document, corners, triangles[2:])
    window.classify()
    assert window.text("ThinPart_Headline") == language.said("Unknown")
    reason = language.below("{quantities} could not be measured, so criterion {criteria} cannot be decided.")
    assert window.text("ThinPart_Why") == reason.format(quantities="V/VBB", criteria="3")
    assert language.below("The surface is open ({edges} free edges), so it has no certain volume.").format(edges=4) in (
        window.text("ThinPart_Warnings"))
    assert language.foreign(window.widget("ThinPart_Panel")) == set()


def test_a_measurement_that_fails(language, document):
    corners = [App.Vector(*each) for each in ((0, 0, 0), (1, 0, 0), (0, 1, 0))]
    add_mesh(document, corners, [(0, 1, 2), (0, 2, 1)])
    window.classify()
    assert window.text("ThinPart_Message") == language.below("Its surface encloses no volume.")


def test_the_window_for_folders(language, tmp_path):
    shutil.copyfile(window.SAMPLES / "plate.step", tmp_path / "plate.step")
    (tmp_path / "empty.step").touch()
    window.press("ThinPart_ClassifyFolder")
    dialog = window.widget("ThinPart_FolderDialog")
    assert dialog.windowTitle() == language.said("Classify folder")
    assert language.foreign(dialog) == set()
    window.widget("ThinPart_Folder").setCurrentText("/no/such/folder")
    window.click("ThinPart_FolderStart")
    assert window.text("ThinPart_FolderMessage").endswith(
        language.said("There is no folder {}: choose another one.").format("/no/such/folder"))
    window.widget("ThinPart_Folder").setCurrentText(str(tmp_path))
    window.click("ThinPart_FolderStart")
    window.wait_until(window.widget("ThinPart_FolderStart").isEnabled)
    table = window.widget("ThinPart_FolderTable").model()
    category = table.number_of("category")
    told = {table.index(row, category).data(): table.index(row, 0).data(TOOL_TIP) for row in range(table.rowCount())}
    failed = "\u2717 " + language.said("Failed: {}").format(language.below("the file or document is empty"))
    assert set(told) == {language.said("Thin part"), failed}
    assert told[failed] == language.below("{file} is empty (0 bytes).").format(file="empty.step")
    assert language.said("{} of {} files").format(2, 2) in window.text("ThinPart_FolderProgress")
    assert language.foreign(dialog) == set()


def test_the_panel_that_finds_parts(language, tmp_path, monkeypatch):
    monkeypatch.setenv("THINPART_CACHE", str(tmp_path / "cache"))
    for shape in ("plate", "long_plate", "cube"):
        store(tmp_path / "library", f"{shape}.step", [record_of(shape)])
    (tmp_path / "library" / "damaged.thinpart.json").write_text("{")
    set_preference_list("Libraries", [str(tmp_path / "library")])
    dock = find_parts.show_find_parts()
    window.wait_until(lambda: not dock.is_refreshing and not dock.is_waiting)
    view = window.widget("ThinPart_FoundTable")
    rows = {view.model().row_at(row).label: row for row in range(view.model().rowCount())}
    damaged = view.model().index(rows.pop(None), 1).data(TOOL_TIP)
    assert damaged.startswith(language.below("The info file {info_file} cannot be read ({problem}).").partition("{")[0])
    view.selectRow(rows["plate"])
    next(each for each in view.menu().actions() if each.objectName() == "ThinPart_FoundSimilar").trigger()
    window.wait_until(lambda: window.is_shown("ThinPart_EndLike") and not dock.is_waiting)
    window.settle(300)
    assert dock.windowTitle() == language.said("Find parts")
    choices = window.widget("ThinPart_FindChoices")
    assert choices.tabText(2).replace("&", "") == language.said("Reclassify")
    assert choices.tabText(1).replace("&", "").startswith(language.said("Libraries"))
    assert header(view)[3] == language.said("Why")
    reasons = view.model().index(0, 3).data().split(", ")
    assert reasons and set(reasons) <= {translation for (context, _), translation in language.texts.items()
                                        if context == "ThinPartCore"}
    assert language.said("Thin part") in window.widget("ThinPart_Category_thin").text()
    assert window.text("ThinPart_Criterion_1").replace("&", "").startswith(language.below("Plate"))
    window.widget("ThinPart_FindConditions").setText("D9 > 6")
    window.wait_until(lambda: window.is_shown("ThinPart_FindRefusal"))
    refusal = language.below("There is no quantity {quantity!r} in the condition {condition!r}: there are {known}.")
    start = refusal.partition("{")[0]
    assert start in window.text("ThinPart_FindRefusal")
    assert language.foreign(dock) == set()
    set_preference_list("Libraries", [])


def test_the_profile_editor(language, tmp_path):
    store(tmp_path / "library", "Plate.step", [record_of("plate", label="Platte")])
    set_preference_list("Libraries", [str(tmp_path / "library")])
    window.press("ThinPart_EditProfile")
    window.wait_until(lambda: window.is_shown("ThinPart_ProfileDialog"))
    dialog = window.widget("ThinPart_ProfileDialog")
    dialog.choose("calibrated")
    window.wait_until(lambda: not dialog.is_waiting)
    field = dialog.findChild(QtCore.QObject, "ThinPart_ConditionValue")
    field.setValue(100.0)
    window.wait_until(lambda: not dialog.is_waiting)
    never = language.below("{condition} never holds, because it is never above {limit:g}").format(
        condition=f"{load_profile('calibrated').criteria[0].conditions[0].quantity.symbol} > 1", limit=1)
    assert window.text("ThinPart_ProfileChanges") == language.said("Not counted: {}").format(never)
    assert window.widget("ThinPart_ProfileSource").text() == language.below(load_profile("calibrated").content["source"])
    assert language.foreign(dialog) == set()
    window.widget("ThinPart_ProfileTabs").setCurrentIndex(1)
    assert language.foreign(dialog) == set()
    set_preference_list("Libraries", [])


def test_a_profile_of_ones_own_keeps_its_titles(language, tmp_path, sample):
    content = json.loads(json.dumps(load_profile("paper").content))
    content["categories"][1]["criteria"][0]["title"] = "Too thin to cast"
    (tmp_path / "own.json").write_text(json.dumps(content))
    set_preference("Profile", str(tmp_path / "own.json"))
    try:
        window.classify()
        table = window.widget("ThinPart_CriteriaTable")
        assert "Too thin to cast" in table.topLevelItem(4).text(0)
        assert language.below("Plate") in table.topLevelItem(0).text(0)
    finally:
        set_preference("Profile", None)


def test_the_language_can_be_changed_while_freecad_runs():
    from thinpart_workbench.gui.application.sentences import translated

    before = Gui.getLocale()
    try:
        Gui.setLocale("English")
        assert translated("It holds no triangles.") == "It holds no triangles."
        Gui.setLocale("German")
        assert translated("It holds no triangles.") == "Es enthält keine Dreiecke."
    finally:
        Gui.setLocale(before)
    assert Gui.getLocale() == before
