# SPDX-License-Identifier: LGPL-2.1-or-later
"""What holds for every panel, dialog and page: small screens, the keyboard in three languages, the mouse wheel."""

import re

import FreeCADGui as Gui
import pytest
import window_actions as window
from every_window import IN_MAIN_WINDOW, WINDOWS, document_to_show, wheel_over

from thinpart_workbench.gui.application.qt import QtCore, QtGui, QtWidgets
from thinpart_workbench.gui.commands import COMMANDS
from thinpart_workbench.gui.document.active_task import end_session, open_session
from thinpart_workbench.gui.guide.pages import FOLDER, PAGE_OF
from thinpart_workbench.gui.widgets.controls import controls, menu_letters, mnemonic, plain, reading_order

LANGUAGES = ("English", "German", "French")
WIDTH, HEIGHT = 1024, 700
TASK_WIDTH = 340
"""Of the task view and of docks beside the 3D view, in pixels."""


@pytest.fixture
def part(document):
    document_to_show(document)
    return document


@pytest.fixture(params=LANGUAGES)
def language(request):
    started = Gui.getLocale()
    Gui.setLocale(request.param)
    yield request.param
    Gui.setLocale(started)


@pytest.mark.timeout(180)
@pytest.mark.parametrize("name", WINDOWS)
def test_every_control_has_a_letter_of_its_own_and_all_fit_a_small_screen(name, language, part):
    with WINDOWS[name](part) as widgets:
        menus = menu_letters(Gui.getMainWindow()) if name in IN_MAIN_WINDOW else set()
        # Texts with counts change while a window fills; each change asks for a new layout, and so for letters.
        window.wait_until(lambda: not _lettered_wrongly(widgets, menus), lambda: str(_lettered_wrongly(widgets, menus)))
        for widget in widgets:
            least = widget.minimumSizeHint()
            if name in IN_MAIN_WINDOW:
                assert least.width() <= TASK_WIDTH + 60, (widget.objectName(), least)
                continue
            assert least.width() <= WIDTH and least.height() <= HEIGHT, (widget.objectName(), least)
            if widget.isWindow():
                widget.resize(WIDTH, HEIGHT)
                window.settle(50)
                assert widget.width() <= WIDTH and widget.height() <= HEIGHT, widget.size()


def _lettered_wrongly(widgets, menus):
    """What is seen together and shares a letter, takes one of the menus, or has none although one is free: texts."""
    found = [entry for widget in widgets for entry in controls(widget)]
    assert found
    pages = {}
    for page, text, _ in found:
        pages.setdefault(page, []).append(text)
    outside, wrong = pages.pop(None, []), []
    for texts in pages.values() or [[]]:
        letters = [mnemonic(text) for text in outside + texts]
        used = menus | set(letters)
        wrong += [text for text, letter in zip(outside + texts, letters)
                  if (letters.count(letter) > 1 or letter in menus if letter else _ascii_letters(text) - used)]
    return wrong


def _ascii_letters(text):
    return {letter for letter in plain(text).lower() if letter.isascii() and letter.isalpha()}


def test_the_wheel_changes_nothing_without_the_focus(part):
    for name, shown in WINDOWS.items():
        with shown(part) as widgets:
            fields = [field for widget in widgets for field in widget.findChildren(QtWidgets.QWidget)
                      if isinstance(field, (QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QAbstractSlider))
                      and not isinstance(field, QtWidgets.QScrollBar)]
            count = part.UndoCount
            for field in fields:
                field.clearFocus()
                before = _value(field)
                wheel_over(field)
                assert _value(field) == before, (name, field.objectName())
            assert part.UndoCount == count, name


def _value(field):
    if isinstance(field, QtWidgets.QComboBox):
        return field.currentIndex()
    return field.value() if hasattr(field, "value") else field.text()


@pytest.mark.timeout(120)
@pytest.mark.parametrize("name", WINDOWS)
def test_tab_goes_through_the_controls_as_one_reads_them(name, part):
    with WINDOWS[name](part) as widgets:
        window.settle(200)
        for root in widgets:
            stops = [each for each in _tab_stops(root) if each.isVisible() and each.isEnabled()]
            places = [QtCore.QRect(each.mapTo(root, QtCore.QPoint(0, 0)), each.size()) for each in stops]
            wrong = [(before.objectName(), after.objectName()) for before, after, here, there in zip(
                stops, stops[1:], places, places[1:]) if _is_back(here, there)]
            assert wrong == []
            assert {each.objectName() for each in _stops_by_hand(root)} <= {each.objectName() for each in stops}
        if name not in IN_MAIN_WINDOW and widgets[0].isWindow():
            # The first Tab starts where reading does.
            first = stops[0]
            assert places[stops.index(first)] == min(places, key=lambda place: (place.top(), place.left()))


def _tab_stops(root):
    """The controls below a widget as Tab visits them, until it leaves it."""
    known = reading_order(root)
    if not known:
        return []
    found, each = [known[0]], known[0].nextInFocusChain()
    while root.isAncestorOf(each) and each is not known[0]:
        found += [each] if each in known else []
        each = each.nextInFocusChain()
    return found


def _is_back(here, there):
    """Whether a place lies before another one that was to be read first: above and not to the right, or left in its row."""
    if there.bottom() < here.top():
        return there.left() < here.right()
    shared = min(here.bottom(), there.bottom()) - max(here.top(), there.top())
    return shared > 0.5 * min(here.height(), there.height()) and there.right() < here.left()


def _stops_by_hand(root):
    """Buttons and fields that are seen: no Tab may leave them out."""
    kinds = (QtWidgets.QAbstractButton, QtWidgets.QComboBox, QtWidgets.QAbstractSpinBox, QtWidgets.QLineEdit)
    return [each for kind in kinds for each in root.findChildren(kind)
            if each.isVisible() and each.isEnabled() and each.objectName().startswith("ThinPart_")]


def test_commands_have_shortcuts_that_nothing_else_has():
    taken = {}
    for action in Gui.getMainWindow().findChildren(QtWidgets.QAction if hasattr(QtWidgets, "QAction") else type(
            Gui.getMainWindow().menuBar().actions()[0])):
        for sequence in action.shortcuts():
            taken.setdefault(sequence.toString(), set()).add(action.objectName() or action.text())
    for name, command in COMMANDS.items():
        keys = command.keys
        assert keys.startswith("T, "), name
        window.tool_button(name)
        assert taken.get(keys, {name}) == {name}, (keys, taken.get(keys))
        assert [other for other in taken if other and keys.startswith(other + ",")] == [], keys


def test_the_guide_lists_the_keys_of_all_commands():
    page = (FOLDER / "keys.md").read_text(encoding="utf-8")
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| T, ")]
    listed = {keys: (title, re.search(r"\]\((.*)\)", link).group(1)) for keys, title, link in rows}
    assert listed == {each.keys: (each.text, PAGE_OF[name]) for name, each in COMMANDS.items()}


@pytest.mark.parametrize("name", ["folder", "report", "profile", "learning"])
def test_escape_closes_a_window_from_the_start(name, part):
    with WINDOWS[name](part) as widgets:
        window.key(widgets[0].focusWidget() or widgets[0], QtCore.Qt.Key_Escape)
        window.wait_until(lambda: not widgets[0].isVisible())


def test_escape_closes_a_panel_from_the_start(part):
    window.classify()
    panel = window.widget("ThinPart_Panel")
    QtWidgets.QApplication.sendEvent(panel, QtGui.QKeyEvent(
        QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier))
    window.wait_until(lambda: open_session() is None)


@pytest.mark.parametrize("name, first", [
    ("classification", "ThinPart_PartTable"), ("thickness", "ThinPart_FlyButton"), ("mesh sizes", "ThinPart_MeshKind")])
def test_a_panel_that_opens_has_the_keyboard(name, first, part):
    Gui.getMainWindow().activateWindow()
    with WINDOWS[name](part) as widgets:
        window.wait_until(lambda: _focused() == first, lambda: f"the focus is on {_focused()}")
        chosen = QtWidgets.QApplication.focusWidget()
        before = _value(chosen) if isinstance(chosen, QtWidgets.QComboBox) else None
        wheel_over(chosen)
        assert before is None or _value(chosen) == before
        assert any(widget.isAncestorOf(chosen) for widget in widgets)


def _focused():
    widget = QtWidgets.QApplication.focusWidget()
    return widget and widget.objectName()


def test_a_panel_leaves_the_keyboard_where_the_user_has_gone_meanwhile(part):
    window.press("ThinPart_ShowThickness")
    bar = Gui.getMainWindow().menuBar()
    bar.setFocus()
    window.wait_until(window.is_thickness_told)
    window.settle(200)
    assert QtWidgets.QApplication.focusWidget() is bar
    end_session()
