"""Writing the table of results to a CSV file without keeping the window waiting."""

from ..storage.part_table import csv_text, write_part_table
from .qt import QtCore, translate


class TableExport(QtCore.QThread):
    """Writes rows to a file; ``finished`` is sent when it has, or could not.

    Parameters
    ----------
    path : str
    rows : list of PartRow

    Attributes
    ----------
    error : str
        Why it could not; empty otherwise.
    """

    def __init__(self, path, rows, parent=None):
        super().__init__(parent)
        self.path, self.rows = path, rows
        self.error = ""
        QtCore.QCoreApplication.instance().aboutToQuit.connect(self.wait_for_end)

    def wait_for_end(self):
        """FreeCAD ends, and a thread must not outlive it."""
        self.wait()

    def run(self):
        """Called by Qt in the thread."""
        try:
            # Row by row, so that the window's thread has its turn between them.
            write_part_table(self.path, (csv_text([row]) for row in self.rows))
        except OSError as error:
            self.error = translate(
                "ThinPart", "The table {} could not be written ({}): choose another place for it."
            ).format(self.path, error.strerror)
