# SPDX-License-Identifier: LGPL-2.1-or-later
"""Animated camera moves of a 3D view to a wall."""

import numpy as np
from pivy import coin

from ..application.qt import QtCore
from ..document.free_area import free_area

_HEIGHT_FACTOR = 4.0
"""Height of the visible area as a multiple of the wall's thickness, at least."""

_SURROUNDINGS, _LEAST = 0.15, 0.02
"""Shares of the diagonal. The thinner a wall is, the less of its surroundings is shown, from the first on, so that it stays
visible; but never less than the second, by which one recognises the place."""

_MILLISECONDS = 300
_flights = []


def visible_height(thickness, diagonal):
    """Height of the visible area, mm, in which a wall can be seen and its place be recognised.

    Its parameters are the thickness of the wall and the diagonal of the part, mm.
    """
    least = _HEIGHT_FACTOR * thickness
    return max(least, (least * _SURROUNDINGS * diagonal) ** 0.5 if least < _SURROUNDINGS * diagonal else 0.0,
               _LEAST * diagonal)


def fly_to(view, target, direction, height, milliseconds=_MILLISECONDS):
    """Turn and move the camera to a place.

    Parameters
    ----------
    view : View3DInventorPy
    target : array_like of shape (3,), mm
        In document coordinates; comes to the middle of the area that no dock covers.
    direction : ndarray of shape (3,)
        Unit vector from the camera to the target.
    height : float, mm
        Of the visible area.
    milliseconds : int
        Duration; 0 moves the camera at once.
    """
    camera = view.getCameraNode()
    current = camera.orientation.getValue()
    target_orientation = current * coin.SbRotation(
        coin.SbVec3f(*map(float, look_direction(view))), coin.SbVec3f(*map(float, direction)))
    end = _in_free_area(view, target_orientation, np.asarray(target, dtype=float), height)
    start = (current, _focus(camera), _height(camera))
    for earlier in list(_flights):
        earlier.stop()
        _flights.remove(earlier)
    if milliseconds <= 0:
        _set_camera(camera, *end)
        return
    flight = QtCore.QVariantAnimation()
    flight.setStartValue(0.0)
    flight.setEndValue(1.0)
    flight.setDuration(milliseconds)

    def step(fraction):
        orientation = coin.SbRotation.slerp(start[0], end[0], fraction)
        _set_camera(camera, orientation, start[1] + fraction * (end[1] - start[1]),
                    start[2] ** (1.0 - fraction) * end[2] ** fraction)

    flight.valueChanged.connect(step)
    flight.finished.connect(lambda: flight in _flights and _flights.remove(flight))
    _flights.append(flight)
    flight.start()


def look_direction(view):
    """Unit vector in which the camera of a view looks: ndarray of shape (3,)."""
    return np.array(view.getCameraNode().orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())


def _in_free_area(view, orientation, point, size):
    """Orientation, focus and height that centre a point in the area that no dock covers."""
    widget = view.graphicsView().viewport()
    viewport, free = widget.rect(), free_area(widget)
    height = size * viewport.height() / free.height()
    pixel = height / min(viewport.width(), viewport.height())  # Coin measures the shorter side
    middle = free.center() - viewport.center()
    right, up = (np.array(orientation.multVec(coin.SbVec3f(*axis)).getValue()) for axis in ((1, 0, 0), (0, 1, 0)))
    return orientation, point - pixel * (middle.x() * right - middle.y() * up), height


def _focus(camera):
    position = np.array(camera.position.getValue().getValue())
    direction = np.array(camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())
    return position + camera.focalDistance.getValue() * direction


def _height(camera):
    """Height of the visible area at the focal distance, mm."""
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        return max(camera.height.getValue(), 1e-6)
    return max(2.0 * camera.focalDistance.getValue() * np.tan(0.5 * camera.heightAngle.getValue()), 1e-6)


def _set_camera(camera, orientation, focus, height):
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        camera.height = float(height)
        distance = camera.focalDistance.getValue()
    else:
        distance = 0.5 * height / np.tan(0.5 * camera.heightAngle.getValue())
        camera.focalDistance = float(distance)
    direction = np.array(orientation.multVec(coin.SbVec3f(0, 0, -1)).getValue())
    camera.orientation = orientation
    camera.position = tuple(map(float, focus - distance * direction))
