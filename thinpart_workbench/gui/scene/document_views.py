# SPDX-License-Identifier: LGPL-2.1-or-later
"""The 3D views of a document."""

import FreeCADGui as Gui


def views_of(name):
    """All 3D views of a document, by its name: list of View3DInventorPy; empty while it is closed, and afterwards."""
    try:
        return Gui.getDocument(name).mdiViewsOfType("Gui::View3DInventor")
    except NameError:
        return []


def view_of(document):
    """The active 3D view of a document, or else its first; None if it has none."""
    active = Gui.getDocument(document.Name).ActiveView
    return active if hasattr(active, "getCameraNode") else next(iter(views_of(document.Name)), None)
