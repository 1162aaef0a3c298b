# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of the profile editor with the limits of processes."""

import window_actions as window
from find_panel import no_libraries
from profile_editor import answer, opened, own_files, type_into

from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.storage.user_limits import known_limits, user_limits

assert no_libraries and own_files

BOX = QtWidgets.QMessageBox


def limits_tab(dialog):
    window.widget("ThinPart_ProfileTabs").setCurrentIndex(1)
    window.settle(30)
    return window.widget("ThinPart_LimitsTree")


def choose_row(tree, title):
    item, = tree.findItems(title, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0)
    tree.setCurrentItem(item)
    window.settle(10)


def test_limits_are_changed_and_an_own_process_is_added():
    dialog = opened()
    tree = limits_tab(dialog)
    assert tree.topLevelItemCount() == 8 and not window.widget("ThinPart_LimitsSave").isEnabled()
    choose_row(tree, "FDM printing")
    type_into(window.widget("ThinPart_LimitsMin"), "1.2")
    assert tree.currentItem().text(0) == "FDM printing (own)" and tree.currentItem().text(1) == "1.2"
    window.click("ThinPart_LimitsAddProcess")
    type_into(window.widget("ThinPart_LimitsTitle"), "Laser sintering of metal")
    type_into(window.widget("ThinPart_LimitsId"), "LPBF")
    type_into(window.widget("ThinPart_LimitsMin"), "0,4")
    type_into(window.widget("ThinPart_LimitsSourceAuthor"), "Workshop")
    window.click("ThinPart_LimitsHasMax")
    type_into(window.widget("ThinPart_LimitsMax"), "0.3")
    assert "has to be thinner" in window.text("ThinPart_LimitsProblem")
    assert not window.widget("ThinPart_LimitsSave").isEnabled()
    type_into(window.widget("ThinPart_LimitsMax"), "30")
    window.click("ThinPart_LimitsAddMaterial")
    type_into(window.widget("ThinPart_LimitsId"), "Ti 64")
    assert "letters, digits" in window.text("ThinPart_LimitsProblem")
    type_into(window.widget("ThinPart_LimitsId"), "Ti64")
    window.click("ThinPart_LimitsSave")
    assert window.text("ThinPart_LimitsMessage").startswith("Saved in ")
    known = known_limits()
    assert (known["LPBF"].min_mm, known["LPBF"].max_mm, known["LPBF"].source) == (0.4, 30.0, "Workshop")
    assert known["LPBF:Ti64"].min_mm == 0.4 and known["FDM"].min_mm == 1.2 and known["SLS"].min_mm == 0.7
    assert [each["id"] for each in user_limits()] == ["FDM", "LPBF"], "what is shipped is not copied"
    choose_row(tree, "FDM printing (own)")
    assert window.widget("ThinPart_LimitsRemove").text().replace("&", "") == "Back to the shipped limits"
    window.click("ThinPart_LimitsRemove")
    assert tree.currentItem().text(1) == "0.8"
    window.click("ThinPart_LimitsReset")
    assert tree.findItems("FDM printing (own)", QtCore.Qt.MatchExactly, 0)
    choose_row(tree, "Laser sintering of metal (own)")
    window.click("ThinPart_LimitsRemove")
    answer(BOX.Discard, dialog.close)
    assert not dialog.isVisible() and "LPBF" in known_limits()


def test_limits_that_cannot_be_read_are_left_alone(own_files):
    (own_files / "wall_limits.json").write_text('{"format": "thinpart-wall-limits", "version": 1, "processes": [{}]}')
    dialog = opened()
    limits_tab(dialog)
    assert "processes[0].id is missing" in window.text("ThinPart_LimitsMessage")
    assert not window.widget("ThinPart_LimitsAddProcess").isEnabled()
    assert not window.widget("ThinPart_LimitsMin").isEnabled()
    dialog.close()
    assert "[{}]" in (own_files / "wall_limits.json").read_text()
