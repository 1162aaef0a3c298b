# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the controllers of task panels have in common."""

from ..application.qt import QtCore


class TaskController(QtCore.QObject):
    """Controls a task panel about a document.

    Subclasses have ``panel``, a `TaskDialog`, and ``start``, which opens it.
    """

    document_name = None
    """Name of the document, or None."""

    is_running = False
    """Whether a measurement is running."""

    is_up_to_date = False
    """Whether the whole document is measured as it is now."""

    def follow(self, _document):
        """Go on in another document, which is in front now; returns whether there is anything to show of it."""
        return False

    def write_info_file(self):
        """Write the info file of a document that was just saved, where ``is_up_to_date``."""

    def close(self):
        """End the session and close the panel."""
        self._leave()
        self.panel.hide()

    def _leave(self):
        """End what goes on beside the panel."""


class MeasuringController(TaskController):
    """Controls a task panel about a document that is measured: ``measured``, such as a `DocumentMeasurement`."""

    @property
    def document_name(self):
        """See `TaskController`."""
        return self.measured.name

    @property
    def is_running(self):
        """See `TaskController`."""
        return self.measured.is_running

    @property
    def is_up_to_date(self):
        """See `TaskController`."""
        return self.measured.is_up_to_date

    def write_info_file(self):
        """See `TaskController`."""
        self.measured.write_info_file_if_measured()
