# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour bar in the 3D view: moved, sized and hidden with the mouse, kept for the next map, never off the view."""

import pytest
import window_actions as window
from thickness_window import bar_of_document, click_at, look_at, mouse, show_map, view_of, wheel, widget_of

from thinpart_workbench.freecad_adapter.objects.thickness_object import thickness_objects
from thinpart_workbench.freecad_adapter.objects.thickness_probes import probes_of
from thinpart_workbench.freecad_adapter.preferences import preference, set_preference
from thinpart_workbench.gui.application import lifelong
from thinpart_workbench.gui.application.qt import QtCore, QtWidgets

PREFERENCES = ("MapLabels", "ColourBarShown", "ColourBarAcross", "ColourBarDown", "ColourBarSize")


@pytest.fixture(autouse=True)
def at_first():
    """The bar is where it is at first, before and after."""
    for name in PREFERENCES:
        set_preference(name, None)
    yield
    for name in PREFERENCES:
        set_preference(name, None)


@pytest.fixture
def thickness(document):
    document.UndoMode = 1
    made = show_map(document, window.add_ribbed_block(document))
    window.wait_until(lambda: not bar_of(made).isEmpty())
    return made


def bar_of(thickness):
    """QRect that the bar covers in the widget of the view."""
    return bar_of_document(thickness.Document)


def room_of(thickness):
    """QRect of the view."""
    return widget_of(view_of(thickness.Document)).rect()


def camera(thickness):
    """Where the camera stands and looks."""
    return view_of(thickness.Document).getCamera()


def drag(thickness, start, by):
    """Drag with the left button and wait until the bar has changed."""
    before = bar_of(thickness)
    click_at(view_of(thickness.Document), start, start + by)
    window.wait_until(lambda: bar_of(thickness) != before)


def menu_action(thickness, text):
    """Press an entry of the menu of the bar."""
    view, place = view_of(thickness.Document), bar_of(thickness).center()
    mouse(view, QtCore.QEvent.MouseButtonPress, place, QtCore.Qt.RightButton)
    mouse(view, QtCore.QEvent.MouseButtonRelease, place, QtCore.Qt.RightButton, QtCore.Qt.NoButton)
    window.wait_until(lambda: isinstance(QtWidgets.QApplication.activePopupWidget(), QtWidgets.QMenu))
    menu = QtWidgets.QApplication.activePopupWidget()
    action, = [each for each in menu.actions() if each.text().replace("&", "") == text]
    action.trigger()
    menu.close()
    window.settle(60)


def test_the_bar_is_moved_and_stays_there_for_the_next_map(thickness):
    before, view = bar_of(thickness), camera(thickness)
    drag(thickness, before.center(), QtCore.QPoint(200, -60))
    after = bar_of(thickness)
    assert after.size() == before.size() and camera(thickness) == view
    assert abs(after.left() - before.left() - 200) <= 2 and abs(after.top() - before.top() + 60) <= 2
    assert preference("ColourBarAcross") > 0.0 and preference("ColourBarDown") < 0.5
    document = thickness.Document
    document.removeObject(thickness.Name)
    window.wait_until(lambda: bar_of_document(document).isEmpty())
    again = show_map(document, *document.Objects)
    window.wait_until(lambda: bar_of(again) == after)


def test_the_bar_is_never_dragged_off_the_view(thickness):
    for by in (QtCore.QPoint(5000, 5000), QtCore.QPoint(-5000, -5000), QtCore.QPoint(5000, -5000)):
        drag(thickness, bar_of(thickness).center(), by)
        assert room_of(thickness).contains(bar_of(thickness)), by


def test_a_corner_sizes_the_bar_and_the_opposite_one_stays(thickness):
    drag(thickness, bar_of(thickness).center(), QtCore.QPoint(150, 0))
    before = bar_of(thickness)
    drag(thickness, before.bottomRight(), QtCore.QPoint(-40, -90))
    smaller = bar_of(thickness)
    assert smaller.height() < before.height() and preference("ColourBarSize") < 1.0
    assert (smaller.topLeft() - before.topLeft()).manhattanLength() <= 4
    drag(thickness, smaller.topLeft(), QtCore.QPoint(-60, -80))
    larger = bar_of(thickness)
    assert larger.height() > smaller.height() and room_of(thickness).contains(larger)
    assert (larger.bottomRight() - smaller.bottomRight()).manhattanLength() <= 4
    drag(thickness, larger.bottomRight(), QtCore.QPoint(4000, 4000))
    assert preference("ColourBarSize") <= 2.5 and room_of(thickness).contains(bar_of(thickness))


class Behind(QtCore.QObject):
    """What reaches a view that was there before the bar: Qt asks those that watch it in the reverse order."""

    def __init__(self, view):
        super().__init__()
        self.kinds, self._widget = [], widget_of(view)
        self._widget.installEventFilter(self)

    def eventFilter(self, _widget, event):
        if event.type() in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease, QtCore.QEvent.Wheel):
            self.kinds.append(event.type())
        return False

    def end(self):
        self._widget.removeEventFilter(self)


def test_freecad_gets_the_wheel_over_the_bar_and_all_that_is_beside_it(document):
    block = window.add_ribbed_block(document)
    view = view_of(document)
    behind = Behind(view)
    try:
        thickness = show_map(document, block)
        window.wait_until(lambda: not bar_of(thickness).isEmpty())
        bar = bar_of(thickness)
        click_at(view, bar.center())
        assert not behind.kinds
        wheel(view, bar.center(), 120)
        assert behind.kinds == [QtCore.QEvent.Wheel]
        click_at(view, QtCore.QPoint(bar.right() + 60, bar.center().y()))
        assert behind.kinds[1:] == [QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonRelease]
        assert bar_of(thickness) == bar and preference("ColourBarSize") == 1.0
        behind.kinds.clear()
        # The middle button turns and moves, also from the bar.
        mouse(view, QtCore.QEvent.MouseButtonPress, bar.center(), QtCore.Qt.MiddleButton)
        mouse(view, QtCore.QEvent.MouseButtonRelease, bar.center(), QtCore.Qt.MiddleButton, QtCore.Qt.NoButton)
        assert len(behind.kinds) == 2
    finally:
        behind.end()


def test_its_menu_sizes_hides_and_puts_it_back(thickness):
    first = bar_of(thickness)
    drag(thickness, first.center(), QtCore.QPoint(180, 40))
    menu_action(thickness, "Larger")
    window.wait_until(lambda: bar_of(thickness).height() > first.height())
    menu_action(thickness, "Back to its place")
    window.wait_until(lambda: bar_of(thickness) == first)
    menu_action(thickness, "Smaller")
    window.wait_until(lambda: bar_of(thickness).height() < first.height())
    menu_action(thickness, "Thickness labels")
    assert not preference("MapLabels")
    menu_action(thickness, "Hide colour bar")
    window.wait_until(lambda: bar_of(thickness).isEmpty())
    assert not preference("ColourBarShown")
    set_preference("ColourBarShown", True)
    lifelong.map_events.refresh_soon()
    window.wait_until(lambda: not bar_of(thickness).isEmpty())


def test_the_panel_hides_it_and_shows_that_its_menu_did(document):
    window.add_ribbed_block(document)
    window.show_thickness()
    look_at(document)
    thickness, = thickness_objects(document)
    window.wait_until(lambda: not bar_of(thickness).isEmpty())
    box = window.widget("ThinPart_ColourBarShown")
    box.setChecked(False)
    window.wait_until(lambda: bar_of(thickness).isEmpty())
    box.setChecked(True)
    window.wait_until(lambda: not bar_of(thickness).isEmpty())
    menu_action(thickness, "Hide colour bar")
    window.wait_until(lambda: not box.isChecked())


def test_a_click_on_the_bar_pins_nothing_behind_it(document):
    window.add_ribbed_block(document)
    window.show_thickness()
    view = look_at(document)
    thickness, = thickness_objects(document)
    window.wait_until(lambda: not bar_of(thickness).isEmpty())
    window.click("ThinPart_ProbeButton")
    drag(thickness, bar_of(thickness).center(), room_of(thickness).center() - bar_of(thickness).center())
    click_at(view, bar_of(thickness).center())
    assert not probes_of(thickness)


def test_the_bar_stays_on_a_view_that_is_made_small(thickness):
    drag(thickness, bar_of(thickness).center(), QtCore.QPoint(3000, 3000))
    view = view_of(thickness.Document)
    child = _sub_window(view)
    child.showNormal()
    for size in ((500, 400), (260, 220), (900, 600)):
        child.resize(*size)
        window.settle(200)
        window.wait_until(lambda: room_of(thickness).contains(bar_of(thickness)),
                          lambda: f"{bar_of(thickness)} in {room_of(thickness)}")
    child.showMaximized()
    window.settle(100)


def _sub_window(view):
    widget = view.graphicsView()
    while not isinstance(widget, QtWidgets.QMdiSubWindow):
        widget = widget.parentWidget()
    return widget
