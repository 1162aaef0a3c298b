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
    near, far = (np.array(tuple(each)) for each in view.projectPointToLine(*_pixel(view, place)))
    return near, far - near


def seen_first(view, place):
    """What FreeCAD finds first at a point of a view.

    Parameters
    ----------
    view : View3DInventorPy
    place : QPoint

    Returns
    -------
    names : tuple of str
        Of document and object; None where there is nothing.
    point : ndarray of shape (3,), mm
    """
    found = view.getObjectInfo(_pixel(view, place))
    if not found:
        return None, None
    return (found["Document"], found["Object"]), np.array([found[axis] for axis in "xyz"])


def _pixel(view, place):
    """As FreeCAD counts them: of the screen, and upwards."""
    widget = view.graphicsView().viewport()
    ratio = widget.devicePixelRatioF()
    height = round(widget.height() * ratio)
    return round(place.x() * ratio), height - 1 - round(place.y() * ratio)
