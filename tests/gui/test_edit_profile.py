# SPDX-License-Identifier: LGPL-2.1-or-later
"""The profile editor: what is changed is counted, checked, saved and used."""

import json
import os
import signal

import FreeCAD as App
import pytest
import window_actions as window
from find_panel import MANY, choices, classified, library, many, no_libraries, ready, uses_many
from made_library import record_of, store
from profile_editor import answer, changes, counted, expected, named, opened, own_files, thresholds, told, type_into

from thinpart_workbench.api.reclassification import reclassify
from thinpart_workbench.core.judging.criteria import PROFILES, load_profile
from thinpart_workbench.freecad_adapter.preferences import preference, set_preference, set_preference_list
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.library import command as find_parts
from thinpart_workbench.storage.user_profiles import user_profiles

assert classified and library and many and no_libraries and own_files

BOX = QtWidgets.QMessageBox


def test_it_shows_the_preferred_profile_in_words():
    button = window.tool_button("ThinPart_EditProfile")
    assert button.toolTip() and not button.icon().isNull()
    dialog = opened()
    texts = [each.text().replace("\u00a0", " ") for each in named(dialog, "ConditionText")]
    assert texts[0] == "Share of the bounding box that the part fills  >  50 %"
    assert texts[1] == "Middle to shortest side of the bounding box  >  12"
    assert "Share of the surface over parallel walls thinner than 0.25 of the diagonal  >  60 %" in texts
    assert texts[-1] == "Least distance, in diagonals, between walls at 10 to 55 degrees  <  0.05"
    assert [each.text() for each in named(dialog, "CategoryName")] == ["thin", "thin_features"]
    assert "F[0;0.25]: Share of the area" in named(dialog, "ConditionText")[6].toolTip()
    assert not dialog.is_changed and not window.widget("ThinPart_ProfileReset").isEnabled()
    assert "Choose a folder" in window.text("ThinPart_ProfileChanges")
    dialog.close()
    assert not dialog.isVisible()


def test_every_profile_is_shown_and_given_back_unchanged(tmp_path):
    content = json.loads((PROFILES / "calibrated.json").read_text())
    content["house"] = {"kept": True}
    content["categories"][1]["criteria"][0]["conditions"] += [
        {"quantity": "d1_mm", "comparison": ">", "value": 1 / 3},
        {"quantity": "F[0.05:0.29]", "comparison": "<", "value": 0.1},
        {"quantity": "volume_mm3", "comparison": "<", "value": 1234567.891}]
    (tmp_path / "house.json").write_text(json.dumps(content))
    dialog = opened()
    for name in ("paper", "calibrated", str(tmp_path / "house.json")):
        dialog.choose(name)
        assert not dialog.is_changed and dialog._thresholds.content() == load_profile(name).content


def test_a_typed_threshold_is_counted_at_once(library):
    dialog = opened(library)
    assert window.text("ThinPart_ProfileChanges") == "0 of 9 parts change their category." and changes() == {}
    type_into(thresholds(dialog)[6], "5")  # of the surface over walls thinner than a quarter of the diagonal
    counted(dialog)
    content = json.loads(json.dumps(load_profile("paper").content))
    content["categories"][0]["criteria"][3]["conditions"][0]["value"] = 0.05
    assert dialog._thresholds.content() == content
    counts = expected(library, content)
    assert counts > 0 and sum(changes().values()) == counts
    assert window.text("ThinPart_ProfileChanges") == f"{counts} of 9 parts change their category."
    assert all(after == "Thin part" for _, after in changes())
    window.click("ThinPart_ProfileReset")
    counted(dialog)
    assert changes() == {} and not dialog.is_changed


def test_the_parts_of_a_change_are_named_opened_and_found(library):
    dialog = opened(library)
    type_into(thresholds(dialog)[6], "5")
    counted(dialog)
    table, parts = window.widget("ThinPart_ProfileChangesTable"), window.widget("ThinPart_ProfileParts")
    assert not parts.isVisible()
    window.mouse_click(table.viewport(), table.visualItemRect(table.item(0, 0)).center())
    window.wait_until(lambda: parts.count() == int(table.item(0, 2).text()))
    texts = [parts.item(row).text() for row in range(parts.count())]
    row = next(row for row, text in enumerate(texts) if text.endswith("block.step"))
    window.mouse_click(parts.viewport(), parts.visualItemRect(parts.item(row)).center())
    window.click("ThinPart_ProfileOpenPart")
    assert App.ActiveDocument is not None
    window.click("ThinPart_ProfileFindPart")
    dock = find_parts.show_find_parts()
    ready(dock)
    table = window.widget("ThinPart_FoundTable")
    window.wait_until(lambda: table.current_part is not None)
    assert table.current_part.file == parts.item(row).toolTip()
    dialog.end()


def test_what_was_reclassified_meanwhile_is_read_again(library):
    dialog = opened(library)
    list(reclassify([library], "calibrated", write=True))
    assert window.text("ThinPart_ProfileChanges") == "0 of 9 parts change their category."
    window.click("ThinPart_ProfileReadAgain")
    counted(dialog)
    assert sum(changes().values()) == expected(library, "paper") > 0


def test_parts_that_were_measured_before_a_quantity_was_are_told_apart(tmp_path):
    old = record_of("cube", name="Solid2", label="old")
    del old["descriptors"]["plate_share"]
    store(tmp_path / "library", "Two.step", [record_of("cube"), old])
    content = json.loads((PROFILES / "calibrated.json").read_text())
    content["categories"][0]["criteria"][0]["conditions"][1]["quantity"] = "plate_share"
    (tmp_path / "house.json").write_text(json.dumps(content))
    dialog = opened(tmp_path / "library")
    dialog.choose(str(tmp_path / "house.json"))
    type_into(thresholds(dialog)[0], "0.001")
    type_into(thresholds(dialog)[1], "99")
    type_into(named(dialog, "ConditionMost")[0], "9")
    counted(dialog)
    assert changes() == {("Normal part", "to be measured again"): 1}
    said = window.text("ThinPart_ProfileChanges")
    assert said.startswith("0 of 2 parts change their category. To be measured again") and said.endswith(": 1.")


@uses_many
def test_the_window_never_waits_for_the_count(many):
    set_preference_list("Libraries", [str(many)])
    window.press("ThinPart_EditProfile")
    dialog = window.widget("ThinPart_ProfileDialog")
    window.wait_until(lambda: window.is_shown("ThinPart_ProfileBar"))
    counting = 0
    for number in range(60):
        thresholds(dialog)[6].setValue(60 + number / 10)
        QtWidgets.QApplication.processEvents(QtCore.QEventLoop.AllEvents, 20)
        counting += dialog.is_waiting
    assert counting > 20  # while numbers are typed, nothing is waited for
    window.wait_until(lambda: not dialog.is_waiting, seconds=120)
    assert f"of {MANY:,} parts" in window.text("ThinPart_ProfileChanges")
    thresholds(dialog)[6].setValue(10)
    counted(dialog)
    assert changes()


def test_a_count_that_was_killed_is_told_and_the_next_change_counts_again(library):
    dialog = opened(library)
    process, = window.workers("judging_worker")
    os.kill(process, signal.SIGKILL)
    window.wait_until(lambda: "ended unexpectedly" in window.text("ThinPart_ProfileCountMessage"))
    type_into(thresholds(dialog)[6], "5")
    counted(dialog)
    assert changes() and "ended" not in window.text("ThinPart_ProfileCountMessage")
    dialog.end()


def test_conditions_that_exclude_each_other_are_told_at_the_field(library):
    dialog = opened(library)
    window.mouse_click(named(dialog, "ConditionAdd")[0])
    window.settle(30)
    row = named(dialog, "ConditionQuantity")[2].parentWidget()
    quantity = row.findChild(QtWidgets.QComboBox, "ThinPart_ConditionQuantity")
    quantity.setCurrentIndex(quantity.findData("volume_ratio"))
    comparison = row.findChild(QtWidgets.QComboBox, "ThinPart_ConditionComparison")
    comparison.setCurrentIndex(comparison.findData("<"))
    type_into(row.findChild(QtWidgets.QWidget, "ThinPart_ConditionValue"), "30")
    counted(dialog)
    sentence = "V/VBB > 0.5 and V/VBB < 0.3 exclude each other"
    assert row.findChild(QtWidgets.QLabel, "ThinPart_ConditionProblem").text() == f"\u26a0 {sentence}"
    assert window.text("ThinPart_ProfileChanges") == f"Not counted: {sentence}"
    assert not any(window.widget(f"ThinPart_Profile{name}").isEnabled() for name in ("Save", "SaveAs", "Use"))
    type_into(row.findChild(QtWidgets.QWidget, "ThinPart_ConditionValue"), "80")
    counted(dialog)
    assert not row.findChild(QtWidgets.QLabel, "ThinPart_ConditionProblem").isVisible()
    assert "parts change" in window.text("ThinPart_ProfileChanges")
    dialog.end()


def test_what_never_holds_and_names_that_are_there_twice_are_told():
    dialog = opened()
    type_into(thresholds(dialog)[0], "100")
    counted(dialog)
    assert "V/VBB > 1 never holds" in named(dialog, "ConditionProblem")[0].text()
    window.click("ThinPart_ProfileReset")
    type_into(named(dialog, "ConditionLeast")[0], "0.5")  # to 0.25
    counted(dialog)
    assert "second bound has to be greater" in named(dialog, "ConditionProblem")[0].text()
    window.click("ThinPart_ProfileReset")
    type_into(named(dialog, "CategoryName")[1], "thin")
    type_into(named(dialog, "CriterionId")[1], "1")
    counted(dialog)
    assert named(dialog, "CategoryProblem")[0].text() == "\u26a0 There are two categories thin."
    assert named(dialog, "CriterionProblem")[0].text() == "\u26a0 There are two criteria 1."
    type_into(named(dialog, "CategoryName")[1], "normal")
    counted(dialog)
    assert "choose another name" in named(dialog, "CategoryProblem")[0].text()
    dialog.end()


@pytest.mark.parametrize("locale, typed", [("C", "12.5"), ("C", "12,5"), ("de_DE", "12,5"), ("de_DE", "12.5")])
def test_point_and_comma_are_the_decimal_point(locale, typed):
    before = QtCore.QLocale()
    QtCore.QLocale.setDefault(QtCore.QLocale(locale))
    try:
        dialog = opened()
        type_into(thresholds(dialog)[0], typed)
        assert dialog._thresholds.content()["categories"][0]["criteria"][0]["conditions"][0]["value"] == 0.125
        type_into(thresholds(dialog)[1], typed)
        assert dialog._thresholds.content()["categories"][0]["criteria"][0]["conditions"][1]["value"] == 12.5
    finally:
        QtCore.QLocale.setDefault(before)
    dialog.end()


def test_arrows_change_the_second_digit_and_the_wheel_nothing():
    dialog = opened()
    share, ratio = thresholds(dialog)[:2]
    window.key(share, QtCore.Qt.Key_Up)
    window.key(ratio, QtCore.Qt.Key_Down)
    assert (share.text(), ratio.text()) == ("51\u00a0%", "11")
    dialog.findChild(QtWidgets.QWidget, "ThinPart_ProfileTitle").setFocus()
    place = QtCore.QPointF(5, 5)
    for field in (share, named(dialog, "ConditionQuantity")[0], named(dialog, "ConditionComparison")[0]):
        before = dialog._thresholds.content()
        QtWidgets.QApplication.sendEvent(field, QtGui.QWheelEvent(
            place, place, QtCore.QPoint(), QtCore.QPoint(0, 120), QtCore.Qt.NoButton, QtCore.Qt.NoModifier,
            QtCore.Qt.NoScrollPhase, False))
        assert dialog._thresholds.content() == before
    dialog.end()


def test_categories_and_criteria_are_added_moved_and_removed(library):
    dialog = opened(library)
    window.mouse_click(named(dialog, "CategoryUp")[1])
    counted(dialog)
    content = dialog._thresholds.content()
    assert [each["name"] for each in content["categories"]] == ["thin_features", "thin"]
    assert sum(changes().values()) == expected(library, content)
    window.mouse_click(named(dialog, "CategoryRemove")[0])
    window.mouse_click(named(dialog, "CriterionRemove")[0])
    window.click("ThinPart_CategoryAdd")
    counted(dialog)
    content = dialog._thresholds.content()
    assert [each["name"] for each in content["categories"]] == ["thin", "category_1"]
    assert [each["id"] for each in content["categories"][0]["criteria"]] == [2, 3, 4]
    assert content["categories"][1]["criteria"][0]["conditions"] == [
        {"quantity": "K[0;0.1]", "comparison": ">", "value": 0.5}]
    assert sum(changes().values()) == expected(library, content)
    assert not named(dialog, "ConditionRemove")[-1].isEnabled(), "a criterion has a condition"
    dialog.end()


def test_a_shipped_profile_is_saved_as_another_and_used(library, own_files):
    find_parts.show_find_parts()
    dialog = opened(library)
    dialog.choose("calibrated")
    shipped = (PROFILES / "calibrated.json").read_bytes()
    assert not window.is_shown("ThinPart_ProfileMargin") and named(dialog, "ProfileUnsure")
    type_into(thresholds(dialog)[0], "80")
    counted(dialog)
    assert "belong to its thresholds before" in named(dialog, "ProfileProbabilities")[0].text()
    assert not window.widget("ThinPart_ProfileSave").isEnabled()
    for name in ("calibrated", "Paper"):
        assert not dialog.save_as(str(own_files / f"{name}.json"))
        assert "comes with ThinPart" in told(dialog)
    answer_file_dialog(own_files / "profiles" / "house", "ThinPart_ProfileSaveAs")
    file = own_files / "profiles" / "house.json"
    assert told(dialog).startswith(f"Saved in {file}, without the probabilities")
    assert not dialog.is_changed and user_profiles() == [file]
    profile = load_profile(file)
    assert (profile.name, profile.title, profile.probability) == ("house", "house", None)
    assert profile.criteria[0].conditions[0].value == 0.8
    assert profile.source.startswith("Changed by hand from: Calibrated on real parts. ")
    assert (PROFILES / "calibrated.json").read_bytes() == shipped
    assert window.widget("ThinPart_ProfileChoice").currentText() == "house"
    window.click("ThinPart_ProfileUse")
    assert preference("Profile") == str(file) and "from now on" in told(dialog)
    window.click("ThinPart_ProfileReclassify")
    dock = find_parts.show_find_parts()
    assert choices(dock).currentIndex() == 2
    assert window.widget("ThinPart_ReclassifyProfile").currentData() == str(file)
    dialog.end()


def answer_file_dialog(file, button):
    """Press a button that opens a file dialog, and type a file there."""
    def choose(dialog):
        line = dialog.findChild(QtWidgets.QLineEdit)
        line.setText(str(file))
        dialog.findChild(QtWidgets.QDialogButtonBox).buttons()[0].click()

    window.answer("", choose)
    window.click(button)
    window.settle(50)


def test_an_own_profile_is_saved_in_its_place_and_shared(tmp_path):
    file = tmp_path / "profiles" / "house.json"
    file.parent.mkdir()
    content = {**load_profile("paper").content, "name": "house", "title": "House"}
    file.write_text(json.dumps(content))
    dialog = opened()
    answer_file_dialog(file, "ThinPart_ProfileOpen")
    assert window.widget("ThinPart_ProfileChoice").currentText() == "House"
    type_into(window.widget("ThinPart_ProfileTitle"), "Our house")
    counted(dialog)
    window.click("ThinPart_ProfileSave")
    assert load_profile(file).title == "Our house" and load_profile(file).source == content["source"]
    assert window.widget("ThinPart_ProfileChoice").currentText() == "Our house"
    menu = window.widget("ThinPart_ProfileShare").menu()
    next(each for each in menu.actions() if each.objectName() == "ThinPart_ProfileShareCopyPath").trigger()
    assert QtWidgets.QApplication.clipboard().text() == str(file)


@pytest.mark.parametrize("text, says", [
    ("{", "cannot be read"), ("[]", "is not a ThinPart profile"),
    (json.dumps(load_profile("paper").content).replace("D2/D3", "D9"), "names 'D9', which is no quantity"),
    (json.dumps(load_profile("paper").content).replace('"value": 0.6', '"value": 60'), "never above 1"),
])
def test_a_file_that_cannot_be_used_is_told_with_the_place(tmp_path, text, says):
    (tmp_path / "from_bert.json").write_text(text)
    dialog = opened()
    dialog.open_file(str(tmp_path / "from_bert.json"))
    assert says in told(dialog) and "from_bert.json" in told(dialog)
    assert window.widget("ThinPart_ProfileChoice").currentData() == "paper"
    assert load_profile("paper").content == dialog._thresholds.content()


def test_a_preferred_profile_that_cannot_be_read_does_not_hinder(tmp_path):
    set_preference("Profile", str(tmp_path / "gone.json"))
    dialog = opened()
    assert "gone.json" in told(dialog)
    assert window.widget("ThinPart_ProfileChoice").currentData() == "calibrated" and not dialog.is_changed


def test_unsaved_changes_are_asked_about(own_files):
    dialog = opened()
    type_into(thresholds(dialog)[0], "55")
    answer(BOX.Cancel, dialog.close)
    assert dialog.isVisible() and dialog.is_changed
    choice = window.widget("ThinPart_ProfileChoice")
    answer(BOX.Cancel, lambda: choice.setCurrentIndex(choice.findData("calibrated")))
    assert choice.currentData() == "paper" and dialog.is_changed
    answer(BOX.Discard, lambda: choice.setCurrentIndex(choice.findData("calibrated")))
    assert choice.currentData() == "calibrated" and not dialog.is_changed
    dialog.choose("paper")
    assert dialog.save_as(str(own_files / "profiles" / "house.json"))
    type_into(thresholds(dialog)[0], "55")
    counted(dialog)
    answer(BOX.Save, lambda: window.key(dialog, QtCore.Qt.Key_Escape))
    assert not dialog.isVisible()
    assert load_profile(own_files / "profiles" / "house.json").criteria[0].conditions[0].value == 0.55


def test_it_opens_from_the_preferences_and_what_is_used_is_chosen_there(tmp_path):
    seen = []

    def edit(dialog):
        assert dialog.isModal()
        seen.append(window.widget("ThinPart_ProfileChoice").currentData())
        assert dialog.save_as(str(tmp_path / "profiles" / "house.json"))
        window.click("ThinPart_ProfileUse")
        assert not window.is_shown("ThinPart_ProfileReclassify")
        dialog.close()

    def act(dialog):
        window.answer("ThinPart_ProfileDialog", edit)
        dialog.findChild(QtWidgets.QToolButton, "ThinPart_PreferenceProfileEdit").click()
        seen.append(dialog.findChild(QtWidgets.QComboBox, "ThinPart_PreferenceProfile").currentData())
        dialog.findChild(QtWidgets.QDialogButtonBox).button(QtWidgets.QDialogButtonBox.Ok).click()

    window.answer("", act)
    window.press("ThinPart_Preferences")
    house = str(tmp_path / "profiles" / "house.json")
    assert seen == ["paper", house] and preference("Profile") == house


def test_it_opens_from_the_reclassify_page_with_the_profile_chosen_there(library):
    set_preference_list("Libraries", [str(library)])
    dock = find_parts.show_find_parts()
    ready(dock)
    choices(dock).setCurrentIndex(2)
    page = window.widget("ThinPart_ReclassifyProfile")
    page.setCurrentIndex(page.findData("calibrated"))
    window.click("ThinPart_ReclassifyEdit")
    window.wait_until(lambda: window.is_shown("ThinPart_ProfileDialog"))
    assert window.widget("ThinPart_ProfileChoice").currentData() == "calibrated"
    counted(window.widget("ThinPart_ProfileDialog"))
