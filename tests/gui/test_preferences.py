# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pages in FreeCAD's preferences: what is set there holds everywhere, what cannot be is said."""

import json
import os
import threading

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import window_actions as window

from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.number_text import number
from thinpart_workbench.freecad_adapter.preferences import (
    GROUP,
    PAGES,
    PREFERENCES,
    preference,
    preferred_analysis,
    set_preference,
)
from thinpart_workbench.gui.application import thread_work
from thinpart_workbench.gui.application.qt import QtGui, QtWidgets
from thinpart_workbench.gui.folder.settings import stored_settings
from thinpart_workbench.storage.info.info_file import read_info
from thinpart_workbench.storage.info.info_location import info_location

RED = (0.84, 0.15, 0.12)
ON_PAGES = [each for each in PREFERENCES.values() if each.page]


@pytest.fixture(autouse=True)
def defaults():
    """The defaults, before and after."""
    reset()
    yield
    reset()


def reset():
    for name in PREFERENCES:
        set_preference(name, None)
    set_preference("Profile", "paper")  # as everywhere in these tests, see conftest


def in_preferences(act, button=QtWidgets.QDialogButtonBox.Ok):
    """Open the preferences, do something there, and leave them by a button."""
    done, errors = [], []

    def go(dialog):
        try:
            done.append(act(dialog))
        except BaseException as error:  # it must not leave the dialog open for ever
            errors.append(error)
        dialog.findChild(QtWidgets.QDialogButtonBox).button(button).click()

    window.answer("", go)
    window.press("ThinPart_Preferences")
    if errors:
        raise errors[0]
    return done[0]


def field(dialog, name):
    """The field of a preference."""
    return dialog.findChild(QtWidgets.QWidget, f"ThinPart_Preferences{PREFERENCES[name].page}").fields[name]


def change(**values):
    """Set preferences by their widgets and press OK."""
    def act(dialog):
        for name, value in values.items():
            field(dialog, name).show_value(value)

    in_preferences(act)


def message(dialog, page):
    return dialog.findChild(QtWidgets.QLabel, f"ThinPart_PreferencesMessage{page}")


def notice():
    return "\n".join(window.notices())


def test_the_pages_show_every_preference_with_its_default():
    def act(dialog):
        assert [dialog.findChild(QtWidgets.QWidget, f"ThinPart_Preferences{page}").windowTitle()
                for page in PAGES] == list(PAGES)
        shown = {each.name: field(dialog, each.name).value() for each in ON_PAGES}
        texts = {each.text().replace("&", "") for kind in (QtWidgets.QLabel, QtWidgets.QCheckBox)
                 for each in dialog.findChildren(kind)}
        assert {each.title for each in ON_PAGES} <= texts
        assert {each.group for each in ON_PAGES} <= {
            each.title() for each in dialog.findChildren(QtWidgets.QGroupBox)}
        return shown

    set_preference("Profile", None)
    shown = in_preferences(act)
    for declared in ON_PAGES:
        assert shown[declared.name] == pytest.approx(declared.default, abs=0.003), declared.name
    assert len(ON_PAGES) == 26


OTHER = {
    "Accuracy": "fine", "LinearDeflection": 0.004, "AngularDeflection": 7.5,
    "KnownParts": False, "Jobs": 3, "Seconds": 77, "MemoryMegabytes": 3000,
    "ThinLimit": "share", "ThinLimitMillimetres": 4.125, "ThinLimitShare": 0.0625,
    "ThinColour": (0.0, 0.2, 1.0), "PartlyThinColour": (0.0, 1.0, 0.0), "UnmeasuredColour": (1.0, 1.0, 0.0),
    "HeatMapColours": "magma", "HeatMapReversed": True, "HeatMapBands": 12,
    "HeatMapShading": False, "HeatMapLogarithmic": True,
    "AutomaticClassification": True, "WarnOfCategory": False, "WarnWallUnder": 1.5, "KnownPartsOnSave": True,
}


def test_what_is_changed_is_kept_and_shown_again_and_cancel_keeps_nothing():
    assert set(OTHER) == {each.name for each in ON_PAGES if not each.names}
    change(**OTHER)
    for name, value in OTHER.items():
        assert preference(name) == pytest.approx(value, abs=0.003), name
    shown = in_preferences(lambda dialog: {name: field(dialog, name).value() for name in OTHER})
    for name, value in OTHER.items():
        assert shown[name] == pytest.approx(value, abs=0.003), name
    in_preferences(lambda dialog: field(dialog, "Jobs").show_value(9), QtWidgets.QDialogButtonBox.Cancel)
    assert preference("Jobs") == 3


def test_apply_keeps_as_well(tmp_path):
    def act(dialog):
        field(dialog, "Jobs").show_value(5)
        dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Apply).click()
        assert preference("Jobs") == 5
        field(dialog, "Jobs").show_value(0)

    in_preferences(act)
    assert preference("Jobs") == 0


def test_what_depends_on_another_preference_is_enabled_with_it():
    def act(dialog):
        enabled = []
        for value in ("verdict", "millimetres", "share"):
            field(dialog, "ThinLimit").show_value(value)
            enabled.append([field(dialog, f"ThinLimit{each}").widget.isEnabled()
                            for each in ("Millimetres", "Share")])
        assert enabled == [[False, False], [True, False], [False, True]]
        assert not field(dialog, "WarnWallUnder").widget.isEnabled()
        field(dialog, "AutomaticClassification").show_value(True)
        assert field(dialog, "WarnWallUnder").widget.isEnabled() and field(dialog, "WarnOfCategory").widget.isEnabled()

    in_preferences(act, QtWidgets.QDialogButtonBox.Cancel)


def test_numbers_say_their_unit_and_what_zero_means():
    def act(dialog):
        bands, jobs = field(dialog, "HeatMapBands"), field(dialog, "Jobs")
        assert (bands.widget.text(), jobs.widget.text()) == ("smooth", "one per processor")
        bands.widget.stepUp()
        assert bands.value() == 2, "one band would be no heat map"
        assert field(dialog, "LinearDeflection").widget.text() == "0.001 of the diagonal"
        assert field(dialog, "AngularDeflection").widget.text() == "12\u00b0"
        field(dialog, "MemoryMegabytes").show_value(10)
        assert field(dialog, "MemoryMegabytes").value() == 700

    in_preferences(act, QtWidgets.QDialogButtonBox.Cancel)


def test_a_colour_is_chosen_in_a_dialog():
    def act(dialog):
        def choose(chooser):
            chooser.setCurrentColor(QtGui.QColor(0, 51, 255))
            chooser.accept()

        _answer_colour(choose)
        field(dialog, "ThinColour").widget.click()

    in_preferences(act)
    assert preference("ThinColour") == pytest.approx((0.0, 0.2, 1.0))


def _answer_colour(choose):
    def look():
        top = QtWidgets.QApplication.activeModalWidget()
        if isinstance(top, QtWidgets.QColorDialog):
            choose(top)
        else:
            window.QtCore.QTimer.singleShot(20, look)

    window.QtCore.QTimer.singleShot(20, look)


def test_the_defaults_of_one_page_are_restored(tmp_path):
    change(**OTHER)

    def act(dialog):
        dialog.findChild(QtWidgets.QPushButton, "ThinPart_PreferencesDefaultsDisplay").click()

    in_preferences(act)
    for declared in ON_PAGES:
        if declared.page == "Display":
            assert preference(declared.name) == pytest.approx(declared.default, abs=0.003), declared.name
        elif declared.name in OTHER:
            assert preference(declared.name) == pytest.approx(OTHER[declared.name], abs=0.003)


def test_what_somebody_has_spoilt_counts_as_default():
    group = App.ParamGet(GROUP)
    group.SetString("HeatMapColours", "jet")
    group.SetInt("HeatMapBands", 1)
    group.SetFloat("AngularDeflection", 30.0)
    assert preference("HeatMapColours") == "red is thin" and preference("HeatMapBands") == 0
    assert preferred_analysis().angular_deflection == 12.0
    group.RemInt("HeatMapBands")


def rounded(document):
    return window.add(document, "Tube", Part.makeCylinder(20, 50).cut(Part.makeCylinder(15, 50)))


def info(file):
    return file.with_name(file.name + ".thinpart.json")


def test_the_surface_mesh_is_made_as_asked_for(document, tmp_path):
    rounded(document)
    file = tmp_path / "tube.FCStd"
    document.saveAs(str(file))
    window.classify()
    usual = read_info(info(file))
    change(LinearDeflection=0.01, AngularDeflection=15.0)
    window.classify()
    coarse = read_info(info(file))
    assert coarse["settings"]["linear_deflection"] == 0.01
    assert coarse["settings"]["angular_deflection"] == 15.0
    assert coarse["parts"][0]["triangles"] < 0.9 * usual["parts"][0]["triangles"]
    arguments = stored_settings().arguments()
    assert arguments[arguments.index("--linear-deflection") + 1] == "0.01"
    assert arguments[arguments.index("--angular-deflection") + 1] == "15.0"


def test_own_thresholds(document, own_profile):
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    change(Profile=str(own_profile))
    assert preference("Profile") == str(own_profile)
    window.classify()
    assert window.text("ThinPart_Headline") == "Normal part"
    assert stored_settings().profile == str(own_profile)


@pytest.fixture
def own_profile(tmp_path):
    """Thresholds by which nothing is thin."""
    content = json.loads(json.dumps(load_profile("paper").content))
    for category in content["categories"]:
        for criterion in category["criteria"]:
            criterion["conditions"] = [{"quantity": "D1", "comparison": ">", "value": 1e9}]
    path = tmp_path / "own.json"
    path.write_text(json.dumps(content))
    return path


@pytest.mark.parametrize("choice, value, red, limit", [
    ("millimetres", 5.0, 0, 5.0), ("millimetres", 7.0, 2, 7.0), ("share", 0.03, 0, 0.03 * 131.149),
    ("millimetres", 90000.0, 10, 131.149),
])
def test_another_limit_colours_other_faces_and_leaves_the_verdict(
        document, tmp_path, choice, value, red, limit):
    feature = window.add_ribbed_block(document)
    file = tmp_path / "ribbed.FCStd"
    document.saveAs(str(file))
    window.classify()
    assert window.rgb(feature).count(RED) == 2 and not window.is_shown("ThinPart_OwnLimit")
    usual = read_info(info(file))["parts"][0]
    change(**{"ThinLimit": choice, f"ThinLimit{choice.capitalize()}": value})
    window.classify()
    assert window.rgb(feature).count(RED) == red
    assert f"below {number(limit)}\u00a0mm" in window.text("ThinPart_OwnLimit")
    assert window.text("ThinPart_Headline") == "Part with thin features"
    again = read_info(info(file))["parts"][0]
    assert [again[key] for key in ("category", "margin", "thin_limit_mm", "faces")] == [
        usual[key] for key in ("category", "margin", "thin_limit_mm", "faces")]


def test_own_colours(document):
    feature = window.add_ribbed_block(document)
    change(ThinColour=(0.0, 0.2, 1.0))
    window.classify()
    assert window.rgb(feature).count((0.0, 0.2, 1.0)) == 2


def test_limits_hold_for_folders_also_where_their_window_is_there_already():
    window.press("ThinPart_ClassifyFolder")
    dialog = window.widget("ThinPart_FolderDialog")
    window.widget("ThinPart_FolderSeconds").setValue(123)
    dialog.reject()
    change(Jobs=3, Seconds=77, MemoryMegabytes=3000)
    window.press("ThinPart_ClassifyFolder")
    assert window.widget("ThinPart_FolderJobs").value() == 3
    assert window.widget("ThinPart_FolderSeconds").value() == 123, "that is the user's own choice"
    arguments = stored_settings().arguments()
    assert [arguments[arguments.index(name) + 1] for name in ("--jobs", "--timeout", "--memory")] == [
        "3", "77", "3000"]


def in_folder(folder, box, name):
    """A saved document with one part, in a folder of its own."""
    folder.mkdir()
    document = App.newDocument(name)
    window.add(document, "Box", Part.makeBox(*box))
    document.saveAs(str(folder / "part.FCStd"))
    return document


def test_info_files_in_a_folder_are_written_and_found_there(tmp_path):
    store = tmp_path / "store"
    store.mkdir()
    in_preferences(lambda dialog: field(dialog, "InfoFolder").show_value(str(store)))
    window.wait_until(lambda: preference("InfoFolder") == str(store))
    plate = in_folder(tmp_path / "a", (100, 100, 2), "A")
    window.classify()
    assert "in the preferred folder" in window.text("ThinPart_InfoText")
    block = in_folder(tmp_path / "b", (100, 100, 90), "B")
    window.classify()
    places = [info_location(each.FileName, str(store)) for each in (plate, block)]
    assert [read_info(each)["parts"][0]["category"] for each in places] == ["thin", "normal"]
    assert not list((tmp_path / "a").glob("*.json")) and window.widget(
        "ThinPart_InfoText").toolTip() == str(places[1])
    # A folder run writes the same file.
    settings = stored_settings()
    assert settings.info_file(plate.FileName) == places[0]
    arguments = settings.arguments()
    assert arguments[arguments.index("--info-dir"):][:4] == ["--info-dir", str(store), "--info-tree", "/"]
    places[0].unlink()
    window.press("ThinPart_ClassifyFolder")
    assert "preferred folder" in window.widget("ThinPart_FolderInfoBeside").text().replace("&", "")
    window.widget("ThinPart_Folder").setCurrentText(str(tmp_path))
    window.click("ThinPart_FolderStart")
    window.wait_until(window.widget("ThinPart_FolderStart").isEnabled)
    assert places[0].is_file() and len(list(tmp_path.rglob("*.thinpart.json"))) == 2


def test_the_search_finds_the_active_part_there(tmp_path):
    store = tmp_path / "store"
    store.mkdir()
    set_preference("InfoFolder", str(store))
    in_folder(tmp_path / "a", (100, 100, 2), "A")
    window.classify()
    window.mouse_click(window.close_button())
    window.press("ThinPart_FindParts")
    window.click("ThinPart_LikeActive")
    window.wait_until(lambda: window.is_shown("ThinPart_EndLike"))
    assert window.text("ThinPart_FindMessage") == ""


def test_a_file_that_is_no_profile_is_said_and_not_kept(document, tmp_path):
    file = tmp_path / "no.json"
    file.write_text("{}")

    def act(dialog):
        field(dialog, "Profile").show_value(str(file))
        window.wait_until(lambda: "is not a ThinPart profile" in message(dialog, "Classification").text())

    in_preferences(act)
    assert preference("Profile") == "paper"
    assert "is not a ThinPart profile" in notice()
    window.add(document, "Plate", Part.makeBox(100, 100, 2))
    window.classify()
    assert window.text("ThinPart_Headline") == "Thin part"


def test_what_is_no_folder_is_said_and_not_kept(tmp_path):
    file = tmp_path / "file"
    file.write_text("")

    def act(dialog):
        line = dialog.findChild(QtWidgets.QLineEdit, "ThinPart_PreferenceInfoFolder")
        line.setText(str(file))
        window.wait_until(lambda: "There is no folder" in message(dialog, "Classification").text())
        line.setText(str(tmp_path))
        window.wait_until(lambda: not message(dialog, "Classification").text())
        line.setText(str(tmp_path / "nothing"))

    in_preferences(act)
    window.wait_until(lambda: "There is no folder" in notice())
    assert preference("InfoFolder") == ""
    window.dismiss_notices()


def test_a_folder_that_does_not_answer_holds_nobody_up(monkeypatch):
    # A server that is off cannot be had here.
    released, is_folder = threading.Event(), os.path.isdir
    monkeypatch.setattr(os.path, "isdir", lambda path: released.wait(30) if path == "/far/away" else is_folder(path))
    monkeypatch.setattr(thread_work, "PATIENCE", 0.4)
    in_preferences(lambda dialog: field(dialog, "InfoFolder").show_value("/far/away"))
    assert notice() == "" and preference("InfoFolder") == "", "the dialog was left before there was an answer"
    window.wait_until(lambda: "has not answered" in notice())
    assert preference("InfoFolder") == ""
    released.set()


def test_an_empty_folder_means_beside_the_document_again(tmp_path):
    set_preference("InfoFolder", str(tmp_path))
    in_preferences(lambda dialog: dialog.findChild(
        QtWidgets.QLineEdit, "ThinPart_PreferenceInfoFolder").clear())
    assert preference("InfoFolder") == ""


@pytest.mark.parametrize("size", [(700, 500), (620, 380)])
def test_nothing_is_cut_off_on_a_small_screen(size):
    def act(dialog):
        for page in PAGES:
            form = dialog.findChild(QtWidgets.QWidget, f"ThinPart_Preferences{page}")
            assert form.minimumSizeHint().width() <= size[0] - 140, page
            assert form.minimumSizeHint().height() <= size[1] - 120, page
            area = form.findChild(QtWidgets.QScrollArea)
            assert area.widget().minimumSizeHint().width() <= area.minimumWidth()

    in_preferences(act, QtWidgets.QDialogButtonBox.Cancel)


def test_the_wheel_scrolls_and_does_not_change_what_is_under_it():
    def act(dialog):
        bands = field(dialog, "HeatMapBands")
        place = window.QtCore.QPointF(5, 5)
        event = QtGui.QWheelEvent(
            place, place, window.QtCore.QPoint(), window.QtCore.QPoint(0, 120), window.QtCore.Qt.NoButton,
            window.QtCore.Qt.NoModifier, window.QtCore.Qt.NoScrollPhase, False)
        QtWidgets.QApplication.sendEvent(bands.widget, event)
        assert bands.value() == 0

    in_preferences(act, QtWidgets.QDialogButtonBox.Cancel)
    assert Gui.isCommandActive("ThinPart_Preferences")
