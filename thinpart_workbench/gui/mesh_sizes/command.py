"""Starts the preparation of a mesh."""

import FreeCAD as App

from ..document.active_task import MESH_SIZES, begin_session, can_open_session, is_task_view_free


def can_prepare_mesh():
    """Whether the command is available; see `can_open_session`."""
    return can_open_session()


def prepare_mesh():
    """Propose element sizes for the selected or active part of the active document."""
    # Imported late: it imports numpy and scipy, which would slow down the start of FreeCAD.
    from .controller import MeshSizesController

    if is_task_view_free(App.ActiveDocument):
        begin_session(MESH_SIZES, MeshSizesController(App.ActiveDocument))
