# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the controllers of task panels that measure a document have in common."""

from ..application.qt import QtCore


class TaskController(QtCore.QObject):
    """Controls a task panel about a document that is measured.

    Subclasses have ``measured``, such as a `DocumentMeasurement`, and ``panel``, a `TaskDialog`.
    """

    @property
    def document_name(self):
        """Name of the document, or None."""
        return self.measured.name

    @property
    def is_running(self):
        """Whether a measurement is running."""
        return self.measured.is_running

    def follow(self, _document):
        """Go on in another document, which is in front now; returns whether there is anything to show of it."""
        return False

    def close(self):
        """End the session and close the panel."""
        self._leave()
        self.panel.hide()
