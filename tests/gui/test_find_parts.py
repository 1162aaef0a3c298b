# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel that finds parts: filters, the list, and the order in it."""

import json
import os
from pathlib import Path

import FreeCADGui as Gui
import window_actions as window
from find_panel import (  # noqa: F401 - fixtures among them
    CATEGORY,
    FILE,
    PART,
    SIZE,
    THINNEST,
    answered,
    cells,
    check,
    choose,
    classified,
    count_of,
    details,
    library,
    no_libraries,
    opened,
    ready,
    row_of,
    select,
    status,
    table,
    workers,
    write,
)

from thinpart_workbench.core.descriptors.descriptor_table import QUANTITIES
from thinpart_workbench.freecad_adapter.preferences import preference_list
from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets


def test_the_command_shows_and_hides_one_panel():
    window.press("ThinPart_FindParts")
    dock = window.widget("ThinPart_FindParts", QtWidgets.QDockWidget)
    assert dock.isVisible() and dock.parent() is Gui.getMainWindow()
    window.press("ThinPart_FindParts")
    assert not dock.isVisible()
    window.wait_until(lambda: not workers())
    window.press("ThinPart_FindParts")
    assert window.widget("ThinPart_FindParts", QtWidgets.QDockWidget) is dock and dock.isVisible()


def test_without_a_library_it_says_what_to_do():
    opened()
    assert "Add a folder" in status()
    assert window.is_shown("ThinPart_LibraryList")


def test_all_parts_are_listed_with_failures_among_them(library):
    opened(library)
    # Three of the assembly, one of each other sample, and the damaged info file.
    assert status() == "10 of 10 parts"
    assert {"Ribbed block", "ribbed_block", "Dowel pin \u00d7 2"} < set(cells(PART))
    assert sum(text.startswith("\u2717 Failed") for text in cells(CATEGORY)) == 1
    assert "plate.step" in cells(FILE)
    assert preference_list("Libraries") == [str(library)]


def test_thumbnails_are_those_of_the_cache(library, classified, tmp_path):
    picture = QtGui.QImage(160, 120, QtGui.QImage.Format_ARGB32)
    picture.fill(QtGui.QColor(10, 200, 30))
    dock = opened(library)
    row = row_of(None, "block.step")
    index = table().model().index(row, PART)
    part = table().model().row_at(row)
    missing = index.data(QtCore.Qt.DecorationRole).toImage()
    Path(part.thumbnail).parent.mkdir(parents=True, exist_ok=True)
    picture.save(part.thumbnail)
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    window.wait_until(lambda: index_of("block.step").data(QtCore.Qt.DecorationRole).toImage() != missing)
    shown = index_of("block.step").data(QtCore.Qt.DecorationRole).toImage()
    assert shown.pixelColor(shown.width() // 2, shown.height() // 2) == QtGui.QColor(10, 200, 30)


def index_of(file):
    return table().model().index(cells(FILE).index(file), PART)


def test_categories_and_their_counts(library):
    dock = opened(library)
    names = ("thin", "thin_features", "normal", "unknown", "failed")
    counts = {name: count_of(f"ThinPart_Category_{name}") for name in names}
    assert sum(counts.values()) == 10 and counts["failed"] == 1
    check(dock, "ThinPart_Category_thin")
    assert status() == f"{counts['thin']} of 10 parts"
    assert {text.split(" (")[0] for text in cells(CATEGORY)} == {"Thin part"}
    # The other categories still say what they would add.
    assert {name: count_of(f"ThinPart_Category_{name}") for name in names} == counts
    check(dock, "ThinPart_Category_failed")
    assert status() == f"{counts['thin'] + 1} of 10 parts"
    write(dock, "ThinPart_FindWords", "plate.step")
    assert count_of("ThinPart_Category_failed") == 0 and count_of("ThinPart_Category_thin") == 1
    assert cells(FILE) == ["plate.step"]


def test_criteria(library):
    dock = opened(library)
    count = count_of("ThinPart_Criterion_1")
    assert 0 < count < 9
    check(dock, "ThinPart_Criterion_1")
    assert status() == f"{count} of 10 parts"
    assert count_of("ThinPart_Category_thin") == count


def test_every_quantity_that_records_have_can_get_a_range(library):
    dock = opened(library)
    combo = window.widget("ThinPart_FindQuantity")
    names = [combo.itemData(row) for row in range(1, combo.count())]
    assert names == ["risk", *(each.name for each in QUANTITIES if each.keys and each.name not in ("d1_mm", "volume_ratio"))]
    combo.setCurrentIndex(combo.findData("d2_d3"))
    combo.activated.emit(combo.currentIndex())
    answered(dock)
    assert combo.findData("d2_d3") == -1 and combo.currentIndex() == 0 and status() == "10 of 10 parts"
    assert float(window.widget("ThinPart_d2_d3Most").placeholderText()) > 6
    window.widget("ThinPart_d2_d3Least").setText("6")
    window.widget("ThinPart_d2_d3Least").textEdited.emit("6")
    answered(dock)
    write(dock, "ThinPart_FindConditions", "D2/D3 < 6")
    assert status() == "0 of 10 parts"
    write(dock, "ThinPart_FindConditions", "")
    assert 0 < len(cells(FILE)) < 9


def test_ranges_by_hand_and_as_numbers(library):
    dock = opened(library)
    write(dock, "ThinPart_FindWords", ".step")
    everything = cells(FILE)
    window.widget("ThinPart_SizeMost").setText("100.5")
    window.widget("ThinPart_SizeMost").textEdited.emit("100.5")
    answered(dock)
    sizes = [float(each) for each in cells(SIZE)]
    assert sizes and max(sizes) <= 100.5 and len(sizes) < len(everything)
    window.widget("ThinPart_ClearFilters").click()
    answered(dock)
    assert status() == "10 of 10 parts" and window.widget("ThinPart_SizeMost").text() == ""
    slider = window.widget("ThinPart_ThinnestSlider")
    drag(slider, slider.handle_x(0), slider.width() * 0.7)
    answered(dock)
    least = float(window.widget("ThinPart_ThinnestLeast").text())
    thinnest = [float(each.split()[0]) for each in cells(THINNEST)]
    assert thinnest and min(thinnest) >= least * 0.99 and "10 of 10" not in status()
    drag(slider, slider.handle_x(0), 0)
    answered(dock)
    assert status() == "10 of 10 parts"


def drag(slider, start, end):
    y = slider.height() / 2
    for kind, x, button, buttons in (
            (QtCore.QEvent.MouseButtonPress, start, QtCore.Qt.LeftButton, QtCore.Qt.LeftButton),
            (QtCore.QEvent.MouseMove, end, QtCore.Qt.NoButton, QtCore.Qt.LeftButton),
            (QtCore.QEvent.MouseButtonRelease, end, QtCore.Qt.LeftButton, QtCore.Qt.NoButton)):
        place = QtCore.QPointF(x, y)
        QtWidgets.QApplication.sendEvent(slider, QtGui.QMouseEvent(
            kind, place, QtCore.QPointF(slider.mapToGlobal(place.toPoint())), button, buttons,
            QtCore.Qt.NoModifier))


def test_conditions_and_what_is_wrong_with_them(library):
    dock = opened(library)
    write(dock, "ThinPart_FindConditions", "D2/D3 > 6")
    found = cells(FILE)
    assert "plate.step" in found and "block.step" not in found
    write(dock, "ThinPart_FindConditions", "D2/D3 >")
    assert "is not understood" in window.text("ThinPart_FindRefusal")
    assert cells(FILE) == found
    # What is understood goes on to hold.
    check(dock, "ThinPart_Category_thin")
    assert set(cells(FILE)) <= set(found) and "plate.step" in cells(FILE)
    check(dock, "ThinPart_Category_thin")
    write(dock, "ThinPart_FindConditions", "")
    assert not window.is_shown("ThinPart_FindRefusal") and status() == "10 of 10 parts"


def test_since(library):
    dock = opened(library)
    window.widget("ThinPart_FindSince").setCurrentIndex(1)
    answered(dock)
    assert status() == "9 of 10 parts"  # the damaged one has no date
    os.utime(library / "plate.step", (1e9, 1e9))
    info = library / "plate.step.thinpart.json"
    content = json.loads(info.read_text())
    content["source"]["modified"] = "2001-09-09T01:46:40.000000+00:00"
    info.write_text(json.dumps(content))
    choose(dock, 1)
    window.click("ThinPart_RefreshLibraries")
    ready(dock)
    assert status() == "8 of 10 parts" and "plate.step" not in cells(FILE)


def test_sorting_by_the_header(library):
    dock = opened(library)
    view = table()
    view.sortByColumn(THINNEST, QtCore.Qt.DescendingOrder)
    answered(dock)
    values = [float(each.split()[0]) for each in cells(THINNEST) if each]
    assert values == sorted(values, reverse=True) and cells(THINNEST)[-1] == ""
    view.sortByColumn(FILE, QtCore.Qt.AscendingOrder)
    answered(dock)
    assert cells(FILE) == sorted(cells(FILE), key=str.casefold)


def test_the_selected_part_stays_selected(library):
    dock = opened(library)
    part = select(dock, "tube")
    table().sortByColumn(SIZE, QtCore.Qt.DescendingOrder)
    answered(dock)
    assert table().current_part.info_file == part.info_file
    check(dock, f"ThinPart_Category_{part.category}")
    assert table().current_part.info_file == part.info_file
    assert details(dock).part.info_file == part.info_file
