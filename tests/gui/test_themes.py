# SPDX-License-Identifier: LGPL-2.1-or-later
"""What ThinPart draws can be read in light and in dark themes, wherever FreeCAD puts its docks."""

import ast
from pathlib import Path

import FreeCADGui as Gui
import numpy as np
import pytest
import window_actions as window

from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.document.free_area import free_area
from thinpart_workbench.gui.library.distribution_comparison import DistributionComparison
from thinpart_workbench.gui.record.criteria_tree import CriteriaTree
from thinpart_workbench.gui.record.distribution_chart import DistributionChart
from thinpart_workbench.gui.thickness.histogram import ThicknessHistogram
from thinpart_workbench.gui.widgets.range_slider import RangeSlider

ROOT = Path(__file__).resolve().parents[2]
ICONS = ROOT / "resources" / "icons"
DARK, LIGHT = "#1a1a1a", "#f0f0f0"
THEMES = {"dark": (DARK, "#f8f9fa"), "light": (LIGHT, "#1a1a1a")}
CONTENT = {"bins": [20, 300, 700], "area": [0.2, 0.5, 0.3]}

_CLASSES = tuple(kind for module in (QtCore, QtGui, QtWidgets)
                 for kind in vars(module).values() if isinstance(kind, type))


def _distribution():
    chart = DistributionChart()
    chart.show_distribution(CONTENT["bins"], CONTENT["area"], 0.05, 100.0)
    return chart


def _histogram():
    chart = ThicknessHistogram()
    chart.show_shares(np.array([0.0, 1, 2, 3]), np.array([0.2, 0.5, 0.3]), 3.0, 10.0)
    chart.show_colours(np.full((3, 3), 120, np.uint8))
    chart.show_threshold(1.4)
    return chart


def _comparison():
    chart = DistributionComparison()
    chart.show_parts([("one", CONTENT), ("other", {"bins": [50, 600], "area": [0.6, 0.4]})])
    return chart


def _slider():
    slider = RangeSlider()
    slider.show_histogram((1.0, 100.0), [3, 1, 0, 5, 2])
    return slider


def _pixels(widget):
    widget.resize(320, 220)
    image = widget.grab().toImage().convertToFormat(QtGui.QImage.Format_RGBA8888)
    rows = np.frombuffer(bytes(image.constBits()), np.uint8).reshape(image.height(), image.bytesPerLine() // 4, 4)
    return rows[:, :image.width(), :3].astype(float)


def _luminance(rgb):
    """Relative luminance (WCAG 2.1)."""
    share = np.asarray(rgb, dtype=float) / 255.0
    linear = np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)
    return linear @ [0.2126, 0.7152, 0.0722]


def _contrast(one, other):
    light, dark = np.maximum(one, other), np.minimum(one, other)
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("theme", THEMES)
@pytest.mark.parametrize("make", [_distribution, _histogram, _comparison, _slider])
def test_charts_are_drawn_on_the_ground_of_the_theme(theme, make):
    ground, letters = THEMES[theme]
    around = QtWidgets.QWidget()
    # As FreeCAD's themes are: a style sheet, which leaves the grounds of the palette as they are.
    around.setStyleSheet(f"QWidget {{ background-color: {ground}; color: {letters}; }}")
    chart = make()
    chart.setParent(around)
    around.resize(340, 240)
    around.show()
    window.settle(30)
    pixels = _pixels(chart).reshape(-1, 3)
    behind = QtGui.QColor(ground)
    contrast = _contrast(_luminance(pixels), _luminance([behind.red(), behind.green(), behind.blue()]))
    assert np.mean(contrast < 1.35) > 0.4  # ground, and the plot that is a little off it
    assert np.mean(contrast > 7.0) > 0.001  # axes and letters
    around.close()


@pytest.mark.parametrize("ground", [DARK, LIGHT])
@pytest.mark.parametrize("name", sorted(path.name for path in ICONS.glob("*.svg")))
def test_icons_are_seen(name, ground):
    picture = QtGui.QPixmap(48, 48)
    picture.fill(QtCore.Qt.transparent)
    painter = QtGui.QPainter(picture)
    QtGui.QIcon(str(ICONS / name)).paint(painter, 0, 0, 48, 48)
    painter.end()
    image = picture.toImage().convertToFormat(QtGui.QImage.Format_RGBA8888)
    rgba = np.frombuffer(bytes(image.constBits()), np.uint8).reshape(-1, 4)
    drawn = rgba[rgba[:, 3] > 200][:, :3]
    if not len(drawn):
        pytest.skip("this Qt has no plug-in for SVG")
    behind = QtGui.QColor(ground)
    contrast = _contrast(_luminance(drawn), _luminance([behind.red(), behind.green(), behind.blue()]))
    # Of a white page on a light ground the lines are seen.
    assert np.mean(contrast > 2.0) > 0.3, np.mean(contrast > 2.0)


def test_criteria_can_be_read_in_another_theme():
    around = QtWidgets.QWidget()
    table = CriteriaTree(around)
    around.show()
    table.show_evidence([{"criterion": "5", "title": "Very thin wall on a filled part", "holds": True,
                          "margin": 0.2, "conditions": []}])
    seen = {}
    for theme, (ground, letters) in THEMES.items():
        around.setStyleSheet(f"QWidget {{ background-color: {ground}; color: {letters}; }}")
        window.settle(30)
        seen[theme] = table.topLevelItem(0).foreground(0).color()
    for theme, (ground, _) in THEMES.items():
        rgb, behind = ([each.red(), each.green(), each.blue()] for each in (seen[theme], QtGui.QColor(ground)))
        assert _contrast(_luminance(rgb), _luminance(behind)) > 4.5, theme
    around.close()


def test_what_overlays_leave_of_a_view_is_free(document):
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    window.add_ribbed_block(document)
    widget = Gui.getDocument(document.Name).activeView().graphicsView().viewport()
    whole = widget.rect()
    overlays = {name: Gui.getMainWindow().findChild(QtWidgets.QTabWidget, name)
                for name in ("OverlayLeft", "OverlayRight", "OverlayTop", "OverlayBottom")}
    shown = [name for name, each in overlays.items() if each is not None and each.isVisible() and each.count()]
    free = free_area(widget)
    assert area is not None and whole.contains(free)
    if not shown:
        assert free == whole
    for name in shown:
        corner = widget.mapFromGlobal(overlays[name].mapToGlobal(QtCore.QPoint(0, 0)))
        assert not QtCore.QRect(corner, overlays[name].size()).intersects(free), name


def _instances_with_enums(tree):
    """(line, text) of what looks like an enum taken from an instance, as Qt 5 allowed."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Attribute) or not node.attr[0].isupper():
            continue
        owner = node.value
        last = owner.attr if isinstance(owner, ast.Attribute) else getattr(owner, "id", "")
        if last[:1].isupper() or not _is_enum_member(node.attr):
            continue
        yield node.lineno, ast.unparse(node)


def _is_enum_member(name):
    """Whether all of Qt that knows a name knows it as a number of an enumeration; else it may be FreeCAD's."""
    found = [getattr(kind, name) for kind in _CLASSES if hasattr(kind, name)]
    return bool(found) and not any(isinstance(each, type) or callable(each) for each in found) and (
        name not in _NAMES_OF_FREECAD)


_NAMES_OF_FREECAD = {"Name", "Label", "Document", "Object", "FileName", "Modified", "Map", "Reversed", "Area",
                     "Point", "Base", "Signature", "Version", "Tool", "ToolTip", "Random", "Rotation", "High",
                     "Low"}


@pytest.mark.parametrize("path", sorted((ROOT / "thinpart_workbench" / "gui").rglob("*.py"))
                         + sorted((ROOT / "tests" / "gui").glob("*.py")),
                         ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_enums_are_taken_from_their_class(path):
    assert list(_instances_with_enums(ast.parse(path.read_text(encoding="utf-8")))) == []


def test_an_enum_of_an_instance_is_found():
    tree = ast.parse("self.setSelectionMode(self.SingleSelection)\nform.AllNonFixedFieldsGrow\nview.Object.Name\n"
                     "QtWidgets.QComboBox.AdjustToContents\n")
    assert sorted(line for line, _ in _instances_with_enums(tree)) == [1, 2]
