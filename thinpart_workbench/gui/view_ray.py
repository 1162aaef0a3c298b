"""Lines of sight of a 3D view of FreeCAD."""

import numpy as np


def line_of_sight(view, place):
    """The line that is seen as one point of a view.

    Parameters
    ----------
    view : View3DInventorPy
    place : QPoint
        In the view's widget.

    Returns
    -------
    near, direction : ndarray of shape (3,), mm
        Where the line enters what is seen, and from there to where it leaves it.
    """
    widget = view.graphicsView().viewport()
    ratio = widget.devicePixelRatioF()
    height = round(widget.height() * ratio)
    x, y = round(place.x() * ratio), height - 1 - round(place.y() * ratio)
    near, far = (np.array(tuple(each)) for each in view.projectPointToLine(x, y))
    return near, far - near
