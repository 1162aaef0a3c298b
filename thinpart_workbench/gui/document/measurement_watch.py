# SPDX-License-Identifier: LGPL-2.1-or-later
"""Restores the behaviour of wall measurements in opened documents, including those saved without ThinPart."""

import FreeCAD as App

from ...freecad_adapter.objects.wall_measurement import MEASUREMENT, revive_measurements
from ..application.qt import QtCore


class MeasurementWatch:
    """Revives the measurements of documents once they are open."""

    def __init__(self):
        self._opened = set()  # names of documents

    def on_object_restored(self, restored):
        """Schedule the document of an object that was created because the document is being opened."""
        if restored.TypeId == MEASUREMENT:
            self._revive_soon(restored.Document.Name)

    def _revive_soon(self, document_name):
        if not self._opened:
            QtCore.QTimer.singleShot(0, self._revive)
        self._opened.add(document_name)

    def _revive(self):
        names = sorted(self._opened)
        self._opened.clear()
        for name in names:
            document = App.listDocuments().get(name)
            if document is None:
                continue  # closed in the meantime
            if document.Restoring:
                self._revive_soon(name)
            else:
                revive_measurements(document)
