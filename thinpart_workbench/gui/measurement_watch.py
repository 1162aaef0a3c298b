"""Measurements of walls in documents that are opened: those that were saved without ThinPart work again."""

import FreeCAD as App

from ..freecad_adapter.wall_measurement import revive_measurements
from .qt import QtCore

_opened = set()  # names of documents


def revive_soon(document_name):
    """Look at the measurements of a document once it is open."""
    if not _opened:
        QtCore.QTimer.singleShot(0, _revive)
    _opened.add(document_name)


def _revive():
    names = sorted(_opened)
    _opened.clear()
    for name in names:
        document = App.listDocuments().get(name)
        if document is None:
            continue  # it is closed again
        if document.Restoring:
            revive_soon(name)
        else:
            revive_measurements(document)
