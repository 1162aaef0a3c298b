# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths in the window are in the unit of FreeCAD's or the document's unit system; files and properties stay in mm."""

import csv
import json
import re

import FreeCAD as App
import Part
import pytest
import window_actions as window
from find_panel import (  # noqa: F401 - fixtures among them
    SIZE,
    THINNEST,
    answered,
    classified,
    filters,
    library,
    no_libraries,
    opened,
    select,
    status,
    table,
)
from folder_dialog_use import (  # noqa: F401 - fixtures among them
    BOX,
    PART,
    column,
    dialog,
    folder,
    model,
    no_choices,
    run,
)
from folder_dialog_use import THINNEST as THINNEST_OF_FOLDER
from folder_dialog_use import select as select_row
from seen_texts import seen
from test_automatic import notice, save, switched_on  # noqa: F401 - a fixture among them
from test_preferences import field, in_preferences
from thickness_window import look_at, move_to, place_of, view_of
from window_actions import V

from thinpart_workbench.core.figures import Length
from thinpart_workbench.core.message import message
from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.objects.thickness_probes import probes_of
from thinpart_workbench.freecad_adapter.preferences import preference, set_preference
from thinpart_workbench.gui.application.length_unit import INCH, MILLIMETRE, PREFERENCES, length_unit
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets
from thinpart_workbench.gui.application.sentences import translated
from thinpart_workbench.gui.colour_bar.colour_bar import bar_image
from thinpart_workbench.gui.preferences.fields import new_field
from thinpart_workbench.gui.view3d.label_node import shown_labels
from thinpart_workbench.gui.widgets.process_field import ProcessField
from thinpart_workbench.storage.info.info_file import read_info

STANDARD, BUILDING_EURO, INCHES, FRACTIONS = 0, 4, 3, 5
IMPERIAL = {2, INCHES, FRACTIONS, 7}
GROUP = App.ParamGet(PREFERENCES)
IN_MM = re.compile(r"(?<![a-z])mm\b")


def choose(schema, *documents):
    """What FreeCAD's preferences do, and the unit menu of its status bar where documents have a unit system."""
    GROUP.SetInt("UserSchema", schema)
    App.Units.setSchema(schema)
    for document in documents or App.listDocuments().values():
        if "UnitSystem" in document.PropertiesList:
            document.UnitSystem = schema
    window.settle(60)


def choose_of(document, schema):
    """The unit menu of the status bar while a document is active: set for another one, FreeCAD 1.1 sets both."""
    App.setActiveDocument(document.Name)
    window.settle(60)
    document.UnitSystem = schema
    window.settle(60)


def in_mm(root):
    """Texts of a window that tell of millimetres."""
    return {text for text in seen(root) if IN_MM.search(text)}


@pytest.fixture(autouse=True)
def standard():
    """Millimetres before and after; the profile's own limit, and nothing classified on save."""
    set_preference("AutomaticClassification", False)
    choose(STANDARD)
    yield
    GROUP.SetBool("IgnoreProjectSchema", False)
    choose(STANDARD)


@pytest.mark.parametrize("schema", range(len(App.Units.listSchemas())))
def test_each_unit_system_is_one_of_inches_or_of_millimetres(document, schema):
    choose(schema)
    assert length_unit(document) == length_unit() == (INCH if schema in IMPERIAL else MILLIMETRE)


def test_lengths_are_written_with_three_digits_and_their_unit():
    assert MILLIMETRE.text(3.0) == "3\u00a0mm" and INCH.text(3.0) == "0.118\u00a0in"
    assert INCH.number(None) == "\u2013" and INCH.value(25.4) == 1.0
    assert INCH.bound_text(0.25) == "0.0098\u00a0in" and MILLIMETRE.bound_text(0.25) == "0.25\u00a0mm"
    said = message("{part}: {wall} or {error:.2g}.", part="lid 3 mm.step", wall=Length(3.0), error=Length(1.5e-05))
    assert translated(said, MILLIMETRE) == "lid 3 mm.step: 3\u00a0mm or 1.5e-05\u00a0mm."
    assert translated(said, INCH) == "lid 3 mm.step: 0.118\u00a0in or 5.9e-07\u00a0in."
    assert translated(said) == translated(said, MILLIMETRE), "that of the window"
    choose(INCHES)
    assert translated(said) == translated(said, INCH)


def test_the_menu_of_processes_is_in_the_unit_of_each_time_it_opens(document):
    field = ProcessField("ThinPart_Processes")
    menu = field.findChild(QtWidgets.QPushButton, "ThinPart_ProcessesChoose").menu()
    for schema, wall in ((INCHES, "from 0.0315\u00a0in on"), (STANDARD, "from 0.8\u00a0mm on")):
        choose(schema)
        menu.aboutToShow.emit()
        fdm, = (action.text() for action in menu.actions() if action.text().startswith("FDM"))
        assert fdm.endswith(wall), fdm
    field.deleteLater()


def test_the_classify_panel_follows_at_once_and_the_info_file_stays_in_mm(document, tmp_path):
    window.add_ribbed_block(document)
    window.add(document, "Plate", Part.makeBox(50.8, 25.4, 2.54, V(0, 0, 200)))
    document.saveAs(str(tmp_path / "parts.FCStd"))
    window.classify()
    panel = window.widget("ThinPart_Panel")
    parts = window.widget("ThinPart_PartTable")
    assert "max 100\u00a0mm" in window.text("ThinPart_Walls")
    file = tmp_path / "parts.FCStd.thinpart.json"
    before = file.read_bytes()
    choose(INCHES)
    assert in_mm(panel) == set()
    assert window.text("ThinPart_Walls").startswith("Wall thickness: min 0.236, median 1.57, max 3.94\u00a0in")
    assert window.text("ThinPart_Box").startswith("Bounding box 3.94 \u00d7 2.36 \u00d7 2.36\u00a0in")
    assert parts.model().headerData(2, QtCore.Qt.Horizontal) == "Thinnest, in"
    assert {parts.model().index(row, 2).data() for row in (0, 1)} == {"0.236", "0.1"}
    chart = window.widget("ThinPart_DistributionChart")
    assert "\u00a0in thick" in chart.bar_text(chart.bars[0])
    # Written anew while the window is in inches, it says what it said, but when and how fast.
    window.classify()
    assert in_mm(window.widget("ThinPart_Panel")) == set()
    old, new = (json.loads(content)["parts"] for content in (before, file.read_bytes()))
    for key in ("descriptors", "thin_limit_mm", "evidence", "margin", "faces", "warnings"):
        assert [part[key] for part in new] == [part[key] for part in old], key
    assert new[0]["descriptors"]["thickness_mm"]["min"] == pytest.approx(6.0)
    choose(BUILDING_EURO)
    assert "max 100\u00a0mm" in window.text("ThinPart_Walls")


def test_an_own_limit_is_told_in_inches(document):
    set_preference("ThinLimit", "millimetres")
    set_preference("ThinLimitMillimetres", 12.7)
    try:
        choose(INCHES)
        window.add_ribbed_block(document)
        window.classify()
        assert "below 0.5\u00a0in, " in window.text("ThinPart_OwnLimit")
        choose(STANDARD)
        assert "below 12.7\u00a0mm, " in window.text("ThinPart_OwnLimit")
    finally:
        set_preference("ThinLimit", None)
        set_preference("ThinLimitMillimetres", None)


@pytest.fixture
def ribbed(document):
    """The map of a ribbed block, its panel open, in inches."""
    choose(INCHES)
    window.add_ribbed_block(document)
    window.show_thickness()
    window.settle(300)
    thickness, = thickness_objects(document)
    return thickness


BOXES = ("ThinPart_ThicknessHead", "ThinPart_DistributionBox", "ThinPart_ScaleBox", "ThinPart_FaceBox",
         "ThinPart_ProbeBox", "ThinPart_RegionBox", "ThinPart_SectionBox")


def test_every_box_of_the_thickness_panel_is_in_inches_and_follows(ribbed):
    for name in BOXES:
        assert in_mm(window.widget(name)) == set(), name
    assert "Thinnest wall 0.236\u00a0in" in window.text("ThinPart_Walls")
    faces = window.widget("ThinPart_FaceTable")
    assert [faces.model().headerData(column, QtCore.Qt.Horizontal) for column in (1, 2)] == [
        "Thinnest, in", "Median, in"]
    assert "0.236" in {faces.model().index(row, 1).data() for row in range(len(faces.rows))}
    chart = window.widget("ThinPart_ThicknessChart")
    width = (chart.edges[2] - chart.edges[1]) / INCH.millimetres
    assert f"{width:.6g}".strip("0.") in ("1", "2", "4", "5", "25"), "bars are as wide as people like in inches"
    assert "\u00a0in: " in chart.bar_text(0)
    assert window.text("ThinPart_ThinShare").endswith("\u00a0in")
    window.mouse_drag(chart, [
        QtCore.QPoint(int(chart.x_of(chart.edges[bar:bar + 2].mean())), int(chart.plot().bottom()) - 3) for bar in (0, 1)])
    assert chart.bars == (0, 1)
    assert "\u00a0in: " in window.text("ThinPart_ChosenShare")
    faces.selectRow(2)
    chosen = faces.current_row.name
    choose(STANDARD)
    assert chart.bars is None and ribbed.ViewObject.Proxy.colours.between is None
    assert faces.current_row.name == chosen
    assert ribbed.ViewObject.Proxy.colours.faces == {0: {faces.current_row.summary.face}}
    assert "Thinnest wall 6\u00a0mm" in window.text("ThinPart_Walls")
    assert faces.model().headerData(1, QtCore.Qt.Horizontal) == "Thinnest, mm"
    assert window.widget("ThinPart_Threshold").value() == pytest.approx(ribbed.Threshold, abs=1e-3)


def test_what_is_typed_in_inches_lands_in_the_map_in_mm(ribbed):
    threshold, unit = window.widget("ThinPart_Threshold"), window.widget("ThinPart_ThresholdUnit")
    assert unit.itemText(0) == "in"
    assert threshold.value() == pytest.approx(ribbed.Threshold / 25.4, abs=1e-4)
    threshold.setFocus()
    threshold.lineEdit().setText("0.25")
    window.key(threshold, QtCore.Qt.Key_Return)
    window.settle(60)
    assert ribbed.Threshold == pytest.approx(6.35, abs=1e-9)
    assert "thinner than 0.25\u00a0in" in window.text("ThinPart_ThinShare")
    unit.setCurrentIndex(1)
    assert threshold.value() == pytest.approx(6.35 / ribbed.Diagonal, abs=1e-4)
    window.widget("ThinPart_AutomaticRange").click()
    assert window.widget("ThinPart_RangeUnit").currentText() == "in"
    for name, inches in (("Low", 0.1), ("High", 1.5)):
        window.widget(f"ThinPart_{name}").setValue(inches)
        window.settle(60)
        assert getattr(ribbed, name) == pytest.approx(25.4 * inches, abs=1e-9)
    choose(STANDARD)
    assert window.widget("ThinPart_High").value() == pytest.approx(38.1) and ribbed.High == pytest.approx(38.1)
    choose(INCHES)
    window.widget("ThinPart_RangeUnit").setCurrentIndex(1)
    window.settle(60)
    share = window.widget("ThinPart_High").value()
    assert share == pytest.approx(ribbed.High, abs=1e-4) and share == pytest.approx(38.1 / ribbed.Diagonal, abs=1e-4)


def test_a_line_that_is_dragged_lands_on_a_round_number_of_inches(ribbed):
    chart = window.widget("ThinPart_ThicknessChart")
    y = int(chart.plot().center().y())
    start = QtCore.QPoint(round(chart.x_of(chart.threshold)), y)
    window.mouse_drag(chart, [start, start + QtCore.QPoint(10, 0), QtCore.QPoint(round(chart.x_of(25.4)), y)])
    window.settle(300)
    inches = ribbed.Threshold / 25.4
    assert inches == pytest.approx(1.0, rel=0.05) and inches == pytest.approx(float(f"{inches:.3g}"), abs=1e-12)


def labels(thickness):
    """What stands at walls in the 3D view."""
    return {text for text, _, _ in shown_labels(view_of(thickness.Document))}


def test_colour_bar_probes_and_the_wall_under_the_cursor(ribbed):
    view = look_at(ribbed.Document)
    bar = ribbed.ViewObject.Proxy.bar
    assert bar.unit == INCH and bar.diagonal == 0.0
    window.click("ThinPart_ProbeButton")
    place = place_of(view, V(60, 12, 40))
    move_to(view, place)
    window.wait_until(lambda: window.text("ThinPart_Hover") == "1.57\u00a0in")
    assert window.text("ThinPart_HoveredWall") == "Here: 1.57\u00a0in"
    window.mouse_drag(view.graphicsView().viewport(), [place])
    window.wait_until(lambda: len(probes_of(ribbed)) == 1)
    assert ribbed.ProbeValues[0] == pytest.approx(40.0, abs=1e-2)
    probes = window.widget("ThinPart_ProbeTable")
    window.wait_until(lambda: len(probes.rows) == 1)
    assert probes.model().index(0, 1).data() == "1.57\u00a0in"
    window.wait_until(lambda: labels(ribbed) == {"1: 1.57\u00a0in", "min 0.236\u00a0in", "thickest wall 3.94\u00a0in"})
    in_inches = bar_image(bar, 900)
    choose(STANDARD)
    assert probes.model().index(0, 1).data() == "40\u00a0mm"
    window.wait_until(lambda: labels(ribbed) == {"1: 40\u00a0mm", "min 6\u00a0mm", "thickest wall 100\u00a0mm"})
    assert ribbed.ViewObject.Proxy.bar.unit == MILLIMETRE
    assert bar_image(ribbed.ViewObject.Proxy.bar, 900) != in_inches
    assert ribbed.ProbeValues[0] == pytest.approx(40.0, abs=1e-2)


def test_results_of_a_folder_and_their_table_in_mm(dialog, folder, tmp_path):
    choose(INCHES)
    run(folder)
    index = select_row("Cover plate")
    assert index.siblingAtColumn(BOX).data() == "3.94 \u00d7 2.76 \u00d7 0.197"
    assert index.siblingAtColumn(THINNEST_OF_FOLDER).data() == "0.197"
    assert in_mm(window.widget("ThinPart_FolderTable")) == set()
    assert model().headerData(BOX, QtCore.Qt.Horizontal) == "Box, in"

    def name_it(chooser):
        chooser.findChild(QtWidgets.QLineEdit).setText(str(tmp_path / "table.csv"))
        chooser.accept()

    window.answer("ThinPart_FolderExportDialog", name_it)
    window.click("ThinPart_FolderExport")
    window.wait_until((tmp_path / "table.csv").is_file)
    with open(tmp_path / "table.csv", newline="", encoding="utf-8") as file:
        row, = [each for each in csv.DictReader(file) if each["label"] == "Cover plate"]
    assert float(row["thinnest_mm"]) == pytest.approx(5.0) and float(row["d1_mm"]) == pytest.approx(100.0)
    choose(STANDARD)
    assert column(PART)[index.row()] == "Cover plate", "the order stays"
    assert index.siblingAtColumn(BOX).data() == "100 \u00d7 70 \u00d7 5"
    assert model().headerData(THINNEST_OF_FOLDER, QtCore.Qt.Horizontal) == "Thinnest, mm"


def test_the_panel_that_finds_parts(library):
    dock = opened(library)
    choose(INCHES)
    assert {text for text in in_mm(dock) if "/" not in text} == set()
    select(dock, "Ribbed block")
    shown, place = table().model(), table().currentIndex().row()
    assert shown.headerData(SIZE, QtCore.Qt.Horizontal) == "Longest, in"
    assert (shown.index(place, THINNEST).data(), shown.index(place, SIZE).data()) == ("0.236", "3.94")
    assert "min 0.236, " in window.text("ThinPart_Walls")
    most = window.widget("ThinPart_SizeMost")
    assert float(most.placeholderText()) == pytest.approx(_longest(shown) / 25.4, rel=0.01)
    most.setText("2.5")
    most.textEdited.emit("2.5")
    answered(dock)
    assert filters(dock).query()["ranges"]["d1_mm"][1] == pytest.approx(63.5)
    assert status() != "10 of 10 parts" and all(
        float(shown.index(row, SIZE).data() or 0) <= 2.5 for row in range(shown.rowCount()))
    choose(STANDARD)
    assert most.text() == "63.5" and filters(dock).query()["ranges"]["d1_mm"][1] == pytest.approx(63.5)
    choose(INCHES)
    assert most.text() == "2.5"
    window.click("ThinPart_ClearFilters")
    answered(dock)
    dock.close()
    window.settle(50)
    choose(STANDARD)
    dock.show()
    assert shown.headerData(SIZE, QtCore.Qt.Horizontal) == "Longest, mm"
    answered(dock)


def _longest(shown):
    return max(part.d1_mm or 0.0 for part in (shown.row_at(row) for row in range(shown.rowCount())) if part)


def test_preferences_are_shown_and_taken_in_inches_and_kept_in_mm():
    choose(INCHES)
    try:
        def look(dialog):
            limit, warn = (field(dialog, name) for name in ("ThinLimitMillimetres", "WarnWallUnder"))
            assert limit.widget.suffix() == warn.widget.suffix() == " in" and limit.widget.text() == "0.07874 in"
            assert warn.value() == 0.0
            warn.widget.setValue(0.05)
            field(dialog, "ThinLimit").show_value("millimetres")

        in_preferences(look)
        assert preference("WarnWallUnder") == pytest.approx(1.27)
        assert preference("ThinLimitMillimetres") == 2.0, "what nobody has changed is not rounded"

        def follow(dialog):
            warn = field(dialog, "WarnWallUnder")
            warn.widget.setValue(0.25)
            choose(STANDARD)
            assert warn.widget.text() == "6.35 mm" and warn.value() == pytest.approx(6.35)

        in_preferences(follow)
        assert preference("WarnWallUnder") == pytest.approx(6.35)
    finally:
        for name in ("WarnWallUnder", "ThinLimitMillimetres", "ThinLimit"):
            set_preference(name, None)


@pytest.mark.parametrize("limit", [0.001, 100_000.0, 3.0])
def test_a_field_keeps_to_the_range_in_every_unit(limit):
    from thinpart_workbench.freecad_adapter.preferences import PREFERENCES as DECLARED

    choose(INCHES)
    parent = QtWidgets.QWidget()
    made = new_field(DECLARED["ThinLimitMillimetres"], parent)
    made.widget.setValue(limit / 25.4)
    assert made.value() == pytest.approx(limit, rel=0.05) and DECLARED["ThinLimitMillimetres"].allows(made.value())
    parent.deleteLater()


def test_a_warning_on_save_is_in_inches(document, tmp_path):
    set_preference("AutomaticClassification", True)
    set_preference("WarnWallUnder", 3.0)
    choose(INCHES)
    window.add(document, "Plate", Part.makeBox(100, 100, 2.54))
    save(document, tmp_path / "new.FCStd")
    assert "has a wall of 0.1\u00a0in, below the limit of 0.118\u00a0in." in notice()
    content = read_info(tmp_path / "new.FCStd.thinpart.json")
    assert content["parts"][0]["descriptors"]["thickness_mm"]["min"] == pytest.approx(2.54)


PER_DOCUMENT = "FreeCAD before 1.0 has one unit system for all documents"


def _has_unit_system(document):
    return "UnitSystem" in document.PropertiesList


def test_each_document_has_its_own_unit_system(document, tmp_path, library):
    if not _has_unit_system(document):
        pytest.skip(PER_DOCUMENT)
    other = App.newDocument("Other")
    for each in (document, other):
        window.add_ribbed_block(each)
    choose_of(document, FRACTIONS)
    App.setActiveDocument(other.Name)
    window.settle(60)
    assert length_unit(document) == INCH and length_unit(other) == length_unit() == MILLIMETRE
    dock = opened(library)
    headings = table().model()
    assert headings.headerData(SIZE, QtCore.Qt.Horizontal) == "Longest, mm"
    App.setActiveDocument(document.Name)
    window.settle(60)
    assert headings.headerData(SIZE, QtCore.Qt.Horizontal) == "Longest, in"
    window.classify()
    assert "min 0.236, " in window.text("ThinPart_Walls")
    App.setActiveDocument(other.Name)
    window.wait_until(lambda: window.is_shown("ThinPart_Elsewhere"))
    assert headings.headerData(SIZE, QtCore.Qt.Horizontal) == "Longest, mm"
    App.setActiveDocument(document.Name)
    window.wait_until(lambda: "min 0.236, " in window.text("ThinPart_Walls"))
    choose_of(document, STANDARD)
    assert "min 6, " in window.text("ThinPart_Walls")
    dock.close()
    choose_of(document, INCHES)
    document.saveAs(str(tmp_path / "inches.FCStd"))
    App.closeDocument(document.Name)
    again = App.openDocument(str(tmp_path / "inches.FCStd"))
    assert length_unit(again) == INCH and length_unit(other) == MILLIMETRE
    App.setActiveDocument(again.Name)
    GROUP.SetBool("IgnoreProjectSchema", True)
    App.Units.setSchema(STANDARD)  # as FreeCAD's preferences do then
    window.settle(60)
    assert length_unit(again) == MILLIMETRE


def test_colour_bars_of_two_documents_are_each_in_their_unit(document, tmp_path):
    if not _has_unit_system(document):
        pytest.skip(PER_DOCUMENT)
    from thickness_window import show_map

    maps = []
    for each, schema in ((document, INCHES), (App.newDocument("Other"), STANDARD)):
        maps.append(show_map(each, window.add_ribbed_block(each)))
        choose_of(each, schema)
    window.settle(100)
    assert [each.ViewObject.Proxy.bar.unit for each in maps] == [INCH, MILLIMETRE]
