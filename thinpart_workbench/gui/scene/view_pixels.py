# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pixels of a 3D view, as they are while it is drawn, in the window or into a picture."""

import numpy as np
from pivy import coin

from ..application.qt import QtCore, flipped_vertically
from ..document.free_area import free_area

_ROUNDING = 2.0
"""Pixels by which what is drawn may differ from the size of the widget where the ratio of pixels is not a whole number."""


def pixels_drawn(action):
    """Width and height of what is being drawn, in pixels; None where nothing is drawn."""
    if not action.isOfType(coin.SoGLRenderAction.getClassTypeId()):
        return None
    # By index: getValue() returns a bare pointer in newer versions of pivy.
    size = coin.SoViewportRegionElement.get(action.getState()).getViewportSizePixels()
    return (size[0], size[1]) if size[0] and size[1] else None


def is_size_of(widget, width, height):
    """Whether pixels are those of the widget of a view; otherwise a picture of another size is drawn."""
    try:
        ratio = widget.devicePixelRatioF()
        return max(abs(widget.width() * ratio - width), abs(widget.height() * ratio - height)) < _ROUNDING
    except RuntimeError:
        return False  # the view is being closed


def free_pixels(widget, width, height):
    """QRect of the pixels that no dock covers; all pixels when a picture is saved."""
    if not is_size_of(widget, width, height):
        return QtCore.QRect(0, 0, width, height)
    ratio, free = widget.devicePixelRatioF(), free_area(widget)
    return QtCore.QRect(*(round(ratio * length) for length in (
        free.left(), free.top(), free.width(), free.height())))


def place_on_screen(volume, left, bottom, width, height):
    """SbVec3f of a pixel, from the left and from the bottom, where nothing of the scene is cut off.

    The volume is an SbViewVolume, width and height those of the view, in pixels.
    """
    depth = volume.getNearDist() + 0.5 * volume.getDepth()
    return volume.getPlanePoint(depth, coin.SbVec2f(left / width, bottom / height))


def set_image(node, image):
    """Show a QImage of 4 bytes per pixel, RGBA, in an SoImage."""
    flipped = flipped_vertically(image)  # its memory is freed with it
    node.image.setValue(coin.SbVec2s(image.width(), image.height()), 4, bytes(flipped.constBits()))


def projected(volume, points, width, height):
    """Where points are seen.

    Parameters
    ----------
    volume : pivy.coin.SbViewVolume
    points : ndarray of shape (n, 3), mm
    width, height : int

    Returns
    -------
    ndarray of shape (n, 2), pixels, downwards
        nan behind the eye.
    """
    rows = np.array(volume.getMatrix().getValue(), dtype=float)  # for row vectors
    flat = np.concatenate([points, np.ones((len(points), 1))], axis=1) @ rows
    with np.errstate(divide="ignore", invalid="ignore"):
        flat = flat[:, :2] / np.where(flat[:, 3:] > 0.0, flat[:, 3:], np.nan)
    return np.stack([0.5 * (flat[:, 0] + 1.0) * width, 0.5 * (1.0 - flat[:, 1]) * height], axis=1)
