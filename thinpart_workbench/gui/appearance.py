"""The colours of the faces of one object in the 3D view: read, painted and put back exactly."""

from contextlib import contextmanager


def _property(view):
    # FreeCAD 1.0 keeps whole materials; its DiffuseColor is a reading of them.
    return "ShapeAppearance" if "ShapeAppearance" in view.PropertiesList else "DiffuseColor"


def appearance(view):
    """Everything that `set_appearance` needs to make an object look as it does now."""
    return list(getattr(view, _property(view)))


def set_appearance(view, kept):
    """Put back what `appearance` returned."""
    setattr(view, _property(view), kept)


def fingerprint(view):
    """Number that tells one set of face colours of an object from another."""
    return hash(tuple(map(tuple, view.DiffuseColor)))


def paint(view, count, colours):
    """Colour some faces and leave all others as they are.

    Parameters
    ----------
    view : Gui.ViewProviderDocumentObject
    count : int
        Number of faces of the object.
    colours : dict
        Red, green and blue from 0 to 1, by the index of the face.
    """
    kept = appearance(view)
    if len(kept) != count:
        # One entry stands for all faces; FreeCAD shows a list of a wrong length in the same way.
        kept = [_whole(view) for _ in range(count)]
    for index, rgb in colours.items():
        if hasattr(kept[index], "DiffuseColor"):
            kept[index].DiffuseColor = tuple(rgb) + tuple(kept[index].DiffuseColor[3:])
        else:
            kept[index] = tuple(rgb) + tuple(kept[index][3:])
    set_appearance(view, kept)


def _whole(view):
    """The entry that stands for all faces."""
    entries = appearance(view)
    if entries:
        return entries[0]
    # A document that was saved without a window has none; it looks like FreeCAD's default.
    return tuple(view.ShapeColor[:3]) + (view.Transparency / 100.0,)


@contextmanager
def unrecorded(view):
    """Changes of colour that neither enter Undo nor mark the document as modified."""
    view.setPropertyStatus(_property(view), ["NoModify"])
    try:
        yield
    finally:
        view.setPropertyStatus(_property(view), ["-NoModify"])
