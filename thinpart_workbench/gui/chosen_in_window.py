"""What is selected or active in FreeCAD's window, as places in a document."""

import FreeCADGui as Gui


def selected_places(document):
    """list of ``(name of the top object, sub-object path)`` of what is selected in a document."""
    places = []
    # Without resolving: the path through links and containers is what tells where a part stands.
    for selected in Gui.Selection.getSelectionEx(document.Name, 0):
        places += [(selected.ObjectName, path) for path in selected.SubElementNames or ("",)]
    return places


def active_place(document):
    """The place of the active body, or None."""
    view = Gui.getDocument(document.Name).ActiveView
    if not hasattr(view, "getActiveObject"):
        return None  # a drawing page or a spreadsheet is in front
    active = view.getActiveObject("pdbody", False)
    if not active or active[0] is None:
        return None
    body, parent, path = active
    if parent is None or parent.Document != document:
        return (body.Name, "") if body.Document == document else None
    return (parent.Name, path)
