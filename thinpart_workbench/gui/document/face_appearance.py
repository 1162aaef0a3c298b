# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads, paints and exactly restores the face colours of one object in the 3D view."""

from contextlib import contextmanager


def _property(view):
    # FreeCAD 1.0 stores complete materials; its DiffuseColor is derived from them. Meshes have one colour.
    return next(name for name in ("ShapeAppearance", "DiffuseColor", "ShapeColor") if name in view.PropertiesList)


def appearance(view):
    """The object's current appearance, for `set_appearance`."""
    value = getattr(view, _property(view))
    return [value] if _property(view) == "ShapeColor" else list(value)


def colours_of(entries):
    """The colours in what `appearance` returned: set of (red, green, blue) from 0 to 1."""
    return {tuple(getattr(entry, "DiffuseColor", entry)[:3]) for entry in entries}


def set_appearance(view, entries):
    """Restore what `appearance` returned."""
    setattr(view, _property(view), entries[0] if _property(view) == "ShapeColor" else entries)


def fingerprint(view):
    """Hash of an object's face colours."""
    if hasattr(view, "DiffuseColor"):
        return hash(tuple(map(tuple, view.DiffuseColor)))
    return hash(tuple(tuple(getattr(entry, "DiffuseColor", entry)) for entry in appearance(view)))


def paint(view, count, colours):
    """Colour some faces and leave the others unchanged.

    Parameters
    ----------
    count : int
        Number of faces of the object.
    colours : dict
        Red, green and blue from 0 to 1, by the index of the face.
    """
    entries = appearance(view)
    if len(entries) != count:
        # A single entry applies to all faces, and FreeCAD treats a list of the wrong length in the same way.
        entries = [_common_entry(view) for _ in range(count)]
    for index, rgb in colours.items():
        if hasattr(entries[index], "DiffuseColor"):
            entries[index].DiffuseColor = tuple(rgb) + tuple(entries[index].DiffuseColor[3:])
        else:
            entries[index] = tuple(rgb) + tuple(entries[index][3:])
    set_appearance(view, entries)


def _common_entry(view):
    """The entry that applies to all faces."""
    entries = appearance(view)
    if entries:
        return entries[0]
    # A document saved without the GUI has no entry and looks like FreeCAD's default.
    return tuple(view.ShapeColor[:3]) + (view.Transparency / 100.0,)


@contextmanager
def unrecorded(view):
    """Context in which changes of colour neither enter Undo nor mark the document as modified."""
    view.setPropertyStatus(_property(view), ["NoModify"])
    try:
        yield
    finally:
        view.setPropertyStatus(_property(view), ["-NoModify"])
