"""Flights of the camera of a 3D view to a wall."""

import numpy as np
from pivy import coin

from .free_area import free_area
from .qt import QtCore

_SHARE = 4.0
"""So many times the wall's thickness is seen."""

_TILT = np.radians(50.0)
"""Between the line of sight and the wall: its outer side is seen, and most of the line through it."""

_MILLISECONDS = 300
_flights = []


def fly_to(view, point, opposite, smallest=0.0, milliseconds=_MILLISECONDS):
    """Turn and move the camera to a wall so that both of its ends are seen.

    Parameters
    ----------
    view : View3DInventorPy
    point, opposite : array_like of shape (3,), mm
        In the coordinates of the document; `point` is the end that is looked at.
    smallest : float, mm
        At least so much of the surroundings is seen.
    milliseconds : int
        0 to be there at once.
    """
    camera = view.getCameraNode()
    point, opposite = np.asarray(point, dtype=float), np.asarray(opposite, dtype=float)
    inward = opposite - point
    thickness = float(np.linalg.norm(inward)) or 1.0
    now = camera.orientation.getValue()
    target = _orientation(now, inward / thickness)
    size = max(_SHARE * thickness, smallest)
    end = _in_free_area(view, target, 0.5 * (point + opposite), size)
    start = (now, _focus(camera), _height(camera))
    if milliseconds <= 0:
        _place(camera, *end)
        return
    flight = QtCore.QVariantAnimation()
    flight.setStartValue(0.0)
    flight.setEndValue(1.0)
    flight.setDuration(milliseconds)

    def step(share):
        turned = coin.SbRotation.slerp(start[0], end[0], share)
        _place(camera, turned, start[1] + share * (end[1] - start[1]),
               start[2] ** (1.0 - share) * end[2] ** share)

    flight.valueChanged.connect(step)
    flight.finished.connect(lambda: _flights.remove(flight))
    for earlier in list(_flights):
        earlier.stop()
    _flights.append(flight)
    flight.start()


def _orientation(now, inward):
    """The nearest one that looks at the wall from outside, tilted."""
    looks = np.array(now.multVec(coin.SbVec3f(0, 0, -1)).getValue())
    side = looks - (looks @ inward) * inward
    if np.linalg.norm(side) < 1e-3:
        side = np.array(now.multVec(coin.SbVec3f(0, 1, 0)).getValue())
        side -= (side @ inward) * inward
    side /= np.linalg.norm(side)
    wanted = np.cos(_TILT) * inward + np.sin(_TILT) * side
    return now * coin.SbRotation(coin.SbVec3f(*map(float, looks)), coin.SbVec3f(*map(float, wanted)))


def _in_free_area(view, orientation, point, size):
    """Where to look so that a point is in the middle of what no dock covers: orientation, focus and height."""
    widget = view.graphicsView().viewport()
    whole, free = widget.rect(), free_area(widget)
    height = size * whole.height() / free.height()
    pixel = height / min(whole.width(), whole.height())  # Coin's heights are those of the shorter side
    middle = free.center() - whole.center()
    right, up = (np.array(orientation.multVec(coin.SbVec3f(*axis)).getValue()) for axis in ((1, 0, 0), (0, 1, 0)))
    return orientation, point - pixel * (middle.x() * right - middle.y() * up), height


def _focus(camera):
    position = np.array(camera.position.getValue().getValue())
    looks = np.array(camera.orientation.getValue().multVec(coin.SbVec3f(0, 0, -1)).getValue())
    return position + camera.focalDistance.getValue() * looks


def _height(camera):
    """How much of the scene is seen from top to bottom at the distance that is looked at, mm."""
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        return max(camera.height.getValue(), 1e-6)
    return max(2.0 * camera.focalDistance.getValue() * np.tan(0.5 * camera.heightAngle.getValue()), 1e-6)


def _place(camera, orientation, focus, height):
    if camera.isOfType(coin.SoOrthographicCamera.getClassTypeId()):
        camera.height = float(height)
        distance = camera.focalDistance.getValue()
    else:
        distance = 0.5 * height / np.tan(0.5 * camera.heightAngle.getValue())
        camera.focalDistance = float(distance)
    looks = np.array(orientation.multVec(coin.SbVec3f(0, 0, -1)).getValue())
    camera.orientation = orientation
    camera.position = tuple(float(each) for each in focus - distance * looks)
