# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colour bar of one 3D view; saved images show it too."""

from contextlib import contextmanager

from pivy import coin

from ..application.qt import QtCore, QtGui
from ..scene.coin_nodes import add_children, flat_colours, skipped_by_fit_all, unpickable
from ..scene.view_pixels import free_pixels, is_size_of, pixels_drawn, place_on_screen, set_image
from .bar_handle import BarHandle
from .bar_place import BarPlace
from .colour_bar import bar_image


class ColourBarNode:
    """A colour bar in a view, drawn over the scene; "fit all" and picking ignore it. The mouse moves it and sizes it.

    Parameters
    ----------
    view : View3DInventorPy

    Attributes
    ----------
    rect : QRect
        Where it was drawn last, in pixels of the window or of the picture.
    window_rect : QRect
        Where it is in the window, in device pixels.
    place : BarPlace

    Notes
    -----
    A separate camera would be simpler, but Coin would then pick along its line of sight in every node that
    follows in the scene.
    """

    def __init__(self, view):
        self._root = root = view.getSceneGraph()
        self._widget = view.graphicsView().viewport()
        self._content, self._drawn_for, self._is_left_out = None, None, False
        self._image_size = 1, 1
        self.place, self.rect, self.window_rect = BarPlace.kept(), QtCore.QRect(), QtCore.QRect()
        self.node, annotation = skipped_by_fit_all(), coin.SoAnnotation()
        fit = coin.SoCallback()
        self._fit = self._fit_to_view  # pivy does not hold a reference to it
        fit.setCallback(self._fit)
        self._translation, self._image = coin.SoTranslation(), coin.SoImage()
        self._translation.enableNotify(False)  # set during rendering, which must not trigger another rendering
        self._image.vertAlignment = coin.SoImage.BOTTOM
        self._image.horAlignment = coin.SoImage.LEFT
        # All inside the annotation, so that none of it affects the nodes after the bar.
        add_children(annotation, unpickable(), fit, flat_colours(), self._translation, self._image)
        self.node.addChild(annotation)
        root.insertChild(self.node, 0)  # before FreeCAD's clipping plane, which cuts all that follows
        self._handle = BarHandle(self._widget, self)

    def is_in(self, root):
        """Whether the bar belongs to the view with this scene graph."""
        return root.findChild(self.node) >= 0

    def show(self, content):
        """Show a BarContent where the user has put the bar."""
        place = self.place if self._handle.is_dragging else BarPlace.kept()
        if content != self._content or place != self.place:
            self._content, self.place, self._drawn_for = content, place, None
            self.node.touch()

    def put(self, place):
        """Show the bar at a BarPlace."""
        self.place = place
        self.node.touch()

    def remove(self):
        """Take the bar out of the view."""
        self._handle.end()
        self._root.removeChild(self.node)

    def picture(self, most):
        """QImage of the bar for a picture beside which it stands: no larger than a QSize."""
        return self._drawn(QtCore.QRect(QtCore.QPoint(0, 0), most), self.place)

    @contextmanager
    def left_out(self):
        """Have the view drawn without the bar in a ``with`` block."""
        # It stays in the scene graph: FreeCAD draws into the picture from there.
        self._is_left_out, self._drawn_for = True, None
        try:
            yield
        finally:
            self._is_left_out, self._drawn_for = False, None
            self.node.touch()

    def layout(self, place):
        """Where the bar would stand in the window: the free QRect, the size of the bar and its margin, in device pixels."""
        ratio = self._widget.devicePixelRatioF()
        width, height = round(self._widget.width() * ratio), round(self._widget.height() * ratio)
        free = free_pixels(self._widget, width, height)
        image = self._drawn(free, place)
        return free, (image.width(), image.height()), _margin(height)

    def _fit_to_view(self, _data, action):
        """Draw at the resolution being rendered: a saved image has another size than the window."""
        size = pixels_drawn(action) if self._content is not None else None
        if size is None:
            return
        width, height = size
        if self._is_left_out:
            nothing = QtGui.QImage(1, 1, QtGui.QImage.Format_RGBA8888)
            nothing.fill(QtCore.Qt.transparent)
            set_image(self._image, nothing)
            return
        free = free_pixels(self._widget, width, height)
        drawn_for = free.width(), free.height(), self.place.size
        if drawn_for != self._drawn_for:
            self._drawn_for = drawn_for
            image = self._drawn(free, self.place)
            self._image_size = image.width(), image.height()
            set_image(self._image, image)
        corner = self.place.corner(free, *self._image_size, _margin(height))
        self.rect = QtCore.QRect(corner, QtCore.QSize(*self._image_size))
        if is_size_of(self._widget, width, height):
            self.window_rect = self.rect
            self._handle.cover()
        self._translation.translation = place_on_screen(
            coin.SoViewVolumeElement.get(action.getState()), corner.x() + 0.5,
            height - corner.y() - self._image_size[1] + 0.5, width, height)

    def _drawn(self, free, place):
        """QImage of the bar, no larger than the room there is."""
        # A narrow image limits the size of the bar.
        image = bar_image(self._content, round(place.size * min(free.height(), round(1.2 * free.width()))))
        if image.width() > free.width() or image.height() > free.height():
            image = image.scaled(free.size(), QtCore.Qt.KeepAspectRatio, QtCore.Qt.SmoothTransformation)
        return image


def _margin(height):
    return max(4, round(0.012 * height))
