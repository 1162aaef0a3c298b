"""Exports the table of results to a CSV file in a thread."""

from ...core.errors import ThinPartError
from ...core.foreign_text import csv_text
from ...storage.part_table import check_cells, check_titles, write_part_table
from ..application.qt import QtCore, translate
from ..application.sentences import translated


class CsvExport(QtCore.QThread):
    """Writes rows to a file; emits ``finished`` on success and on failure.

    Parameters
    ----------
    path : str
    rows : list of PartRow
    checks : list of str
        Names of the processes that the rows were checked against.
    overwrite : bool
        See `write_part_table`.

    Attributes
    ----------
    error : str
        Reason of a failure; empty on success.
    """

    def __init__(self, path, rows, checks=(), overwrite=False, parent=None):
        super().__init__(parent)
        self.path, self.rows, self._checks, self._overwrite = path, rows, checks, overwrite
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
            write_part_table(self.path, blocks, check_titles(self._checks), self._overwrite)
        except ThinPartError as error:
            self.error = translated(error)
        except OSError as error:
            self.error = not_written(self.path, error)


def not_written(path, error):
    """The sentence for an OSError: str."""
    return translate("ThinPart", "The table {} could not be written ({}): choose another place for it.").format(
        path, error.strerror)
