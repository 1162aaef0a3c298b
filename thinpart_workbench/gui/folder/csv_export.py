"""Exports the table of results to a CSV file in a thread."""

from ...core.foreign_text import csv_text
from ...storage.part_table import check_cells, check_titles, write_part_table
from ..application.qt import QtCore, translate


class CsvExport(QtCore.QThread):
    """Writes rows to a file; emits ``finished`` on success and on failure.

    Parameters
    ----------
    path : str
    rows : list of PartRow
    checks : list of str
        Names of the processes that the rows were checked against.

    Attributes
    ----------
    error : str
        Reason of a failure; empty on success.
    """

    def __init__(self, path, rows, checks=(), parent=None):
        super().__init__(parent)
        self.path, self.rows, self._checks = path, rows, checks
        self.error = ""
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.wait_for_end)

    def wait_for_end(self):
        """Wait for the thread when FreeCAD quits, because a thread must not outlive the application."""
        self.wait()

    def run(self):
        """Write the file; Qt calls this in the thread."""
        try:
            # Row by row, so that the GUI thread gets the interpreter lock in between.
            blocks = (csv_text([(*row, *check_cells(getattr(row, "checks", ())))]) for row in self.rows)
            write_part_table(self.path, blocks, check_titles(self._checks))
        except OSError as error:
            self.error = translate(
                "ThinPart", "The table {} could not be written ({}): choose another place for it."
            ).format(self.path, error.strerror)
