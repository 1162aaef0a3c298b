# SPDX-License-Identifier: LGPL-2.1-or-later
"""Moves and sizes the colour bar of a view with the mouse, and shows its menu."""

from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.preferences import preference, set_preference
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, mouse_position, translate
from .bar_place import BarPlace

_CORNER = 12
"""Pixels from a corner within which it is taken hold of."""

_STEP = 1.2
"""Factor between sizes of the menu."""

_COVERED = "ThinPart_ColourBar"
"""Dynamic property of a view's widget: the QRect that the bar covers."""


def is_on_bar(widget, position):
    """Whether a colour bar covers a QPoint of the widget of a view."""
    rect = widget.property(_COVERED)
    return rect is not None and rect.contains(position)


@guarded_methods(eventFilter=False)
class BarHandle(QtCore.QObject):
    """Watches the mouse over a view. What is not done to the bar is left to FreeCAD.

    Parameters
    ----------
    widget : QWidget
        Of the view, which gets the mouse.
    bar : ColourBarNode
    """

    def __init__(self, widget, bar):
        super().__init__()
        self._widget, self._bar = widget, bar
        self._grip = None  # (where in the bar it was taken, opposite corner that stays or None, place, QRect then)
        self._right_pressed = False
        self._cursor = None  # of the view, while the mouse is over the bar
        widget.installEventFilter(self)

    @property
    def is_dragging(self):
        """Whether the bar follows the mouse."""
        return self._grip is not None

    def cover(self):
        """Tell those who watch the same view what the bar covers."""
        self._widget.setProperty(_COVERED, self._rect)

    def end(self):
        """Stop watching."""
        try:
            self._show_cursor(None)
            self._widget.setProperty(_COVERED, None)
            self._widget.removeEventFilter(self)
        except RuntimeError:
            return  # the view was closed

    def eventFilter(self, widget, event):
        """Take what is done to the bar."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseMove:
            return self._on_move(mouse_position(event), event.buttons())
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return self._on_press(event)
        if kind == QtCore.QEvent.MouseButtonRelease:
            return self._on_release(event)
        if kind == QtCore.QEvent.ContextMenu:
            return self._rect.contains(event.pos())
        if kind == QtCore.QEvent.Leave:
            self._show_cursor(None)
        return False

    @property
    def _ratio(self):
        return self._widget.devicePixelRatioF()

    @property
    def _rect(self):
        """QRect of the bar in the widget's pixels."""
        rect, ratio = self._bar.window_rect, self._ratio
        return QtCore.QRect(*(round(length / ratio) for length in rect.getRect()))

    def _corner_at(self, position):
        """Which corner is taken hold of, as (is right, is lower); None for none."""
        rect = self._rect
        for is_right in (True, False):
            for is_lower in (True, False):
                corner = QtCore.QPoint(rect.right() if is_right else rect.left(), rect.bottom() if is_lower else rect.top())
                if max(abs(position.x() - corner.x()), abs(position.y() - corner.y())) <= _CORNER:
                    return is_right, is_lower
        return None

    def _on_press(self, event):
        position = mouse_position(event)
        if not self._rect.contains(position) or event.modifiers() != QtCore.Qt.NoModifier:
            return False
        if event.button() == QtCore.Qt.RightButton and event.buttons() == QtCore.Qt.RightButton:
            self._right_pressed = True
            return True
        if event.button() != QtCore.Qt.LeftButton or event.buttons() != QtCore.Qt.LeftButton:
            return False
        self._grip = position, self._corner_at(position), self._bar.place, QtCore.QRect(self._bar.window_rect)
        self._show_cursor(position)
        return True

    def _on_move(self, position, buttons):
        if self._grip is None:
            self._show_cursor(position if buttons == QtCore.Qt.NoButton and self._rect.contains(position) else None)
            return False
        if not buttons & QtCore.Qt.LeftButton:
            self._drop()  # it was let go where nobody saw it
            return False
        start, corner, place, rect = self._grip
        moved = QtCore.QPointF(position - start) * self._ratio
        self._bar.put(self._moved(place, rect, moved) if corner is None else self._sized(place, rect, moved, *corner))
        return True

    def _on_release(self, event):
        if event.button() == QtCore.Qt.RightButton and self._right_pressed:
            self._right_pressed = False
            self._show_menu(self._widget.mapToGlobal(mouse_position(event)))
            return True
        if event.button() != QtCore.Qt.LeftButton or self._grip is None:
            return False
        self._drop()
        return True

    def _drop(self):
        before, self._grip = self._grip[2], None
        if self._bar.place != before:
            self._keep(self._bar.place)

    def _moved(self, place, rect, moved):
        free, size, margin = self._bar.layout(place)
        return place.with_corner((QtCore.QPointF(rect.topLeft()) + moved).toPoint(), free, *size, margin)

    def _sized(self, place, rect, moved, is_right, is_lower):
        """The place of a bar of which one corner follows the mouse and the opposite one stays."""
        across = moved.x() if is_right else -moved.x()
        down = moved.y() if is_lower else -moved.y()
        grown = max((rect.width() + across) / rect.width(), (rect.height() + down) / rect.height())
        larger = place.of_size(place.size * grown)
        free, (width, height), margin = self._bar.layout(larger)
        corner = QtCore.QPoint(rect.left() if is_right else rect.left() + rect.width() - width,
                               rect.top() if is_lower else rect.top() + rect.height() - height)
        return larger.with_corner(corner, free, width, height, margin)

    def _keep(self, place):
        place.keep()
        self._bar.put(place)
        lifelong.map_events.refresh_soon()  # the bars of other views

    def _show_menu(self, position):
        menu = QtWidgets.QMenu(self._widget)
        menu.setObjectName("ThinPart_ColourBarMenu")
        menu.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        place = self._bar.place

        def add(text, act):
            action = menu.addAction(text)
            action.triggered.connect(lambda _=False: act())
            return action

        add(translate("ThinPart", "Larger"), lambda: self._keep(place.of_size(place.size * _STEP)))
        add(translate("ThinPart", "Smaller"), lambda: self._keep(place.of_size(place.size / _STEP)))
        add(translate("ThinPart", "Back to its place"), lambda: self._keep(BarPlace.at_first()))
        menu.addSeparator()
        labels = add(translate("ThinPart", "Thickness labels"), lambda: switch("MapLabels", not preference("MapLabels")))
        labels.setCheckable(True)
        labels.setChecked(preference("MapLabels"))
        add(translate("ThinPart", "Hide colour bar"), lambda: switch("ColourBarShown", False))
        menu.popup(position)

    def _show_cursor(self, position):
        """Show what the mouse does at a position of the bar; None beside it."""
        if position is None:
            if self._cursor is not None:
                self._widget.setCursor(self._cursor)
                self._cursor = None
            return
        if self._cursor is None:
            self._cursor = self._widget.cursor()
        corner = self._corner_at(position) if self._grip is None else self._grip[1]
        if corner is None:
            self._widget.setCursor(QtCore.Qt.OpenHandCursor if self._grip is None else QtCore.Qt.ClosedHandCursor)
        else:
            self._widget.setCursor(QtCore.Qt.SizeFDiagCursor if corner[0] == corner[1] else QtCore.Qt.SizeBDiagCursor)


def switch(name, is_on):
    """Set what is shown in views of maps, ``ColourBarShown`` or ``MapLabels``, and show it."""
    set_preference(name, is_on)
    lifelong.map_events.refresh_soon()
