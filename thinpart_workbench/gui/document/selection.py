# SPDX-License-Identifier: LGPL-2.1-or-later
"""The selection and the active body in FreeCAD, as paths within a document."""

import FreeCADGui as Gui

from ...freecad_adapter.occurrences.occurrences import face_paths

MAX_FACES = 2000
"""Maximum number of faces selected at once: FreeCAD draws each one and becomes slow beyond that."""


def selected_paths(document):
    """list of ``(name of the top object, sub-object path)``: the selection in a document."""
    paths = []
    # Do not resolve: the path through links and containers identifies the occurrence of a part.
    for selected in Gui.Selection.getSelectionEx(document.Name, 0):
        paths += [(selected.ObjectName, path) for path in selected.SubElementNames or ("",)]
    return paths


def active_path(document):
    """``(name of the top object, sub-object path)`` of the active body, or None."""
    view = Gui.getDocument(document.Name).ActiveView
    if not hasattr(view, "getActiveObject"):
        return None  # the active view is a drawing page or a spreadsheet
    active = view.getActiveObject("pdbody", False)
    if not active or active[0] is None:
        return None
    body, parent, path = active
    if parent is None or parent.Document != document:
        return (body.Name, "") if body.Document == document else None
    return (parent.Name, path)


def select_part(document, part):
    """Replace the selection in a document by all occurrences of a part, so that the view shows where it is."""
    Gui.Selection.clearSelection(document.Name)
    for occurrence in part.occurrences[:MAX_FACES]:
        top = occurrence.top(document)
        if top is not None:
            Gui.Selection.addSelection(top, occurrence.path)


def select_faces(document, part, faces):
    """Replace the selection in a document by faces of a part, at its first occurrence.

    Parameters
    ----------
    document : FreeCAD.Document
    part : SolidPart or MeshedPart
        A mesh has no faces to select.
    faces : iterable of int
        From 0.
    """
    Gui.Selection.clearSelection(document.Name)
    root, paths = face_paths(document, part, sorted(faces))
    if paths:
        Gui.Selection.addSelection(document.getObject(root), paths[:MAX_FACES])
