# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of sight of a 3D view of FreeCAD."""

import numpy as np


def line_of_sight(view, position):
    """The line of sight through a QPoint of a view's widget.

    Returns
    -------
    near, direction : ndarray of shape (3,), mm
        Where the line enters the view volume, and the vector from there to where it leaves it.
    """
    near, far = (np.array(tuple(point)) for point in view.projectPointToLine(*_pixel(view, position)))
    return near, far - near


def first_object(view, position):
    """The front object at a QPoint of a view's widget.

    Returns
    -------
    names : tuple of str
        Names of the document and the object; None if there is no object.
    point : ndarray of shape (3,), mm
    """
    info = view.getObjectInfo(_pixel(view, position))
    if not info:
        return None, None
    return (info["Document"], info["Object"]), np.array([info[axis] for axis in "xyz"])


def _pixel(view, position):
    """Position in FreeCAD's convention: device pixels, counted upwards."""
    widget = view.graphicsView().viewport()
    ratio = widget.devicePixelRatioF()
    height = round(widget.height() * ratio)
    return round(position.x() * ratio), height - 1 - round(position.y() * ratio)
