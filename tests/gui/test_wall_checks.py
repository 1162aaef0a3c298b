# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall in the window: the preference, the panel, the folder's table and the thickness map."""

import csv
import json
import re

import FreeCAD as App
import numpy as np
import Part
import pytest
import window_actions as window
from folder_dialog_use import CATEGORY, column, dialog, folder, message, no_choices, run  # noqa: F401 - fixtures among them

from thinpart_workbench.api.document_maps import parts_of
from thinpart_workbench.core.judging.limit_bands import FAILS, JUST_ABOVE, PASSES, TOO_THICK
from thinpart_workbench.core.judging.wall_limits import shipped_limits
from thinpart_workbench.freecad_adapter.objects.thickness_object import OWN_CHECK, thickness_objects
from thinpart_workbench.freecad_adapter.preferences import set_preference
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.colour_bar.colours import BAND_COLOURS, ThicknessColours
from thinpart_workbench.gui.preferences.form import PreferencesForm
from thinpart_workbench.gui.widgets.process_field import ProcessField
from thinpart_workbench.storage.user_limits import known_limits


@pytest.fixture(autouse=True)
def preferred():
    """Checks of a test are gone after it."""
    yield
    set_preference("Checks", None)


@pytest.fixture
def own_limits(tmp_path, monkeypatch):
    """The user's own process, ``seven``, whose walls are from 7 to 30 mm."""
    file = tmp_path / "own.json"
    file.write_text(json.dumps({"format": "thinpart-wall-limits", "version": 1, "processes": [
        {"id": "seven", "title": "Seven", "min_mm": 7, "max_mm": 30}]}))
    monkeypatch.setenv("THINPART_LIMITS", str(file))
    return file


def choose_check(name):
    combo = window.widget("ThinPart_Check")
    combo.setCurrentIndex(combo.findData(name))
    window.settle(400)


def test_the_panel_tells_whether_the_part_passes(document, own_limits):
    set_preference("Checks", "seven, FDM")
    window.add_ribbed_block(document)
    window.classify()
    first, second = window.text("ThinPart_Checks").splitlines()
    assert first.startswith("\u2717 Seven: fails:") and "under 7\u00a0mm, thinnest 6\u00a0mm on Face" in first
    assert second.startswith("\u2713 FDM printing: passes:")


def test_without_a_preference_nothing_is_checked(document):
    window.add_ribbed_block(document)
    window.classify()
    assert not window.is_shown("ThinPart_Checks")


def test_a_file_of_limits_that_cannot_be_used_is_told_in_the_panel(document, own_limits):
    own_limits.write_text("{")
    set_preference("Checks", "FDM")
    window.add_ribbed_block(document)
    window.classify()
    assert "own.json" in window.text("ThinPart_Checks") and window.text("ThinPart_Headline")


def test_the_map_shows_in_red_what_fails(document, own_limits):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    choose_check("seven")
    assert (thickness.Check, thickness.Threshold, thickness.CheckMost) == ("seven", 7.0, 30.0)
    colours = ThicknessColours.of(thickness).of_values(np.array([6.0, 6.9999, 7.0, 7.69, 7.71, 20.0, 30.0, 40.0, np.nan]))
    names = {rgb: name for name, rgb in BAND_COLOURS.items()}
    assert [names.get(tuple(rgb)) for rgb in colours.tolist()] == [
        FAILS, JUST_ABOVE, JUST_ABOVE, JUST_ABOVE, PASSES, PASSES, PASSES, PASSES, None]
    assert "fails" in window.text("ThinPart_CheckResult") and "7\u00a0mm" in window.text("ThinPart_ThinShare")
    document.undo()
    window.settle(300)
    assert thickness.Check == "" and not window.is_shown("ThinPart_CheckResult")


def violet(thickness):
    """Of each part, which corners of its facets are violet: list of ndarray of shape (m, 3), bool."""
    colours = ThicknessColours.of(thickness)
    return [(colours.of_corners(number, part.map) == BAND_COLOURS[TOO_THICK]).all(axis=2)
            for number, part in enumerate(parts_of(thickness))]


def violet_share():
    return float(re.search(r"([\d.]+)\u00a0%&nbsp;too", window.text("ThinPart_CheckShares")).group(1))


def test_the_map_shows_in_violet_what_the_check_calls_too_thick_and_no_rims(document, own_limits):
    window.add(document, "Plate", Part.makeBox(100, 80, 10))
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    choose_check("seven")
    assert (parts_of(thickness)[0].map.thickness > 70.0).any()  # along the plate, from its rims
    assert "passes" in window.text("ThinPart_CheckResult")
    assert not violet(thickness)[0].any() and violet_share() == 0.0
    own_limits.write_text(own_limits.read_text().replace('"max_mm": 30', '"max_mm": 8'))
    choose_check("")
    choose_check("seven")
    assert thickness.CheckMost == 8.0 and "more than 8\u00a0mm" in window.text("ThinPart_CheckResult")
    assert violet(thickness)[0].mean() > 0.9 and violet_share() > 90.0
    drawn = thickness.ViewObject.Proxy.colours
    assert drawn.maps is ThicknessColours.of(thickness).maps and drawn.are_thick(0).mean() > 0.9
    chart = window.widget("ThinPart_ThicknessChart")
    at_ten = np.searchsorted(chart.edges, 10.0) - 1
    assert tuple(chart.colours[at_ten]) == BAND_COLOURS[TOO_THICK]


def test_shares_of_the_three_colours_are_those_of_the_surface(document):
    window.add(document, "Step", Part.makeBox(100, 50, 2).fuse(Part.makeBox(50, 50, 40)).removeSplitter())
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    choose_check(OWN_CHECK)
    field = window.widget("ThinPart_CheckLimit")
    assert field.isVisible()
    for limit, band in ((2.5, 0), (1.9, 1), (1.5, 2)):
        field.setValue(limit)
        window.settle(400)
        assert (thickness.Check, thickness.Threshold) == (OWN_CHECK, limit)
        shares = [float(share) for share in re.findall(r"([\d.]+)\u00a0%", window.text("ThinPart_CheckShares"))]
        assert len(shares) == 3 and sum(shares) == pytest.approx(100.0, abs=1.6)
        # Both sides of the plate that sticks out, of all the surface.
        plate = 100.0 * 2 * 50 * 50 / (2 * 100 * 50 + 2 * 150 * 2 + 2 * 50 * 38 + 2 * 50 * 38)
        assert shares[band] >= plate - 1.0 and (band == 2 or shares[band] < plate + 1.5)
    choose_check("")
    assert not field.isVisible() and not window.is_shown("ThinPart_CheckShares")


def test_another_threshold_is_the_users_own_limit(document, own_limits):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    choose_check("seven")
    window.widget("ThinPart_Threshold").setValue(5.0)
    window.settle(400)
    assert (thickness.Check, thickness.CheckMost, thickness.Threshold) == (OWN_CHECK, 0.0, 5.0)
    assert window.widget("ThinPart_Check").currentData() == OWN_CHECK
    assert "Own limit: passes" in window.text("ThinPart_CheckResult")
    choose_check("")
    assert thickness.Check == "" and ThicknessColours.of(thickness).checked is None


def test_a_process_that_is_no_longer_known_is_still_shown(document, own_limits, tmp_path):
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    choose_check("seven")
    thickness, = thickness_objects(document)
    own_limits.unlink()
    thickness.ThinOnly = True  # the boxes are filled anew
    window.settle(300)
    assert "fails" in window.text("ThinPart_CheckResult")


def test_the_folder_has_a_column_for_each_process(dialog, folder, tmp_path):
    window.widget("ThinPart_FolderChecks", QtWidgets.QLineEdit).setText("sheet_metal,FDM")
    run(folder)
    passes = dict(zip(column(1), column(CATEGORY + 1)))
    assert passes["Block"] == "\u2717 fails" and passes["Cover plate"] == "\u2713 passes" and passes[""] == ""
    assert set(column(CATEGORY + 2)) == {"\u2713 passes", ""}

    def choose_name(box):
        box.findChild(QtWidgets.QLineEdit).setText(str(tmp_path / "table.csv"))
        box.accept()

    window.answer("ThinPart_FolderExportDialog", choose_name)
    window.click("ThinPart_FolderExport")
    window.wait_until(lambda: message() != "")
    with open(tmp_path / "table.csv", newline="", encoding="utf-8") as file:
        assert {row["label"]: row["check sheet_metal"] for row in csv.DictReader(file)}["Block"] == "fails"


def test_an_unknown_process_is_refused_before_the_folder_is_measured(dialog, folder):
    window.widget("ThinPart_FolderChecks", QtWidgets.QLineEdit).setText("wood")
    window.widget("ThinPart_Folder").setCurrentText(str(folder))
    window.click("ThinPart_FolderStart")
    assert "wood" in message() and not dialog.is_running


def test_the_preference_is_chosen_from_a_menu_and_checked():
    page = PreferencesForm("Classification")
    page.show()
    line = page.findChild(QtWidgets.QLineEdit, "ThinPart_PreferenceChecks")
    menu = page.findChild(QtWidgets.QPushButton, "ThinPart_PreferenceChecksChoose").menu()
    menu.aboutToShow.emit()
    next(action for action in menu.actions() if action.text().startswith("FDM")).trigger()
    die_casting = next(each for each in menu.findChildren(QtWidgets.QMenu) if each.title() == "Die casting")
    next(action for action in die_casting.actions() if "Zinc, small" in action.text()).trigger()
    assert line.text() == "FDM, die_casting:zinc"
    fdm = next(action for action in menu.actions() if action.text().startswith("FDM"))
    assert fdm.toolTip().startswith("Two lines of a nozzle") and "geometry restrictions" in fdm.toolTip()
    assert menu.toolTipsVisible() and die_casting.toolTipsVisible()
    menu.aboutToShow.emit()
    page.save()
    assert App.ParamGet("User parameter:BaseApp/Preferences/Mod/ThinPart").GetString("Checks") == line.text()
    assert any("mm" in action.text() and action.isChecked() for action in menu.actions() if "FDM" in action.text())
    line.setText("wood")
    window.wait_until(lambda: "wood" in page.findChild(QtWidgets.QLabel, "ThinPart_PreferencesMessageClassification").text())
    page.hide()
    page.deleteLater()


def test_own_limits_are_made_of_the_shipped_ones_and_opened(tmp_path, monkeypatch):
    class Editor(QtCore.QObject):
        opened = []

        @QtCore.Slot(QtCore.QUrl)
        def open_file(self, url):
            self.opened.append(url.toLocalFile())

    file, editor = tmp_path / "new" / "own.json", Editor()
    monkeypatch.setenv("THINPART_LIMITS", str(file))
    QtGui.QDesktopServices.setUrlHandler("file", editor, "open_file")
    try:
        field = ProcessField("ThinPart_TestProcesses")
        menu = field.findChild(QtWidgets.QPushButton).menu()
        for content in ("shipped", "changed"):
            menu.aboutToShow.emit()
            menu.actions()[-1].trigger()
            window.wait_until(lambda: editor.opened == [str(file)])
            if content == "shipped":
                assert set(known_limits()) == set(shipped_limits())
                file.write_text(file.read_text().replace('"min_mm": 0.8', '"min_mm": 0.9'))
                editor.opened.clear()
        assert known_limits()["FDM"].min_mm == 0.9
    finally:
        QtGui.QDesktopServices.unsetUrlHandler("file")
