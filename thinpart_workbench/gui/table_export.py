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
    sentence : str
        What came of it.
    """

    def __init__(self, path, rows, parent=None):
        super().__init__(parent)
        self._path, self._rows = path, rows
        self.sentence = ""

    def run(self):
        """Called by Qt in the thread."""
        try:
            # Row by row, so that the window's thread has its turn between them.
            write_part_table(self._path, (csv_text([row]) for row in self._rows))
        except OSError as error:
            self.sentence = translate(
                "ThinPart", "The table {} could not be written ({}): choose another place for it."
            ).format(self._path, error.strerror)
            return
        self.sentence = translate("ThinPart", "{} rows, those shown, were written to {}.").format(
            len(self._rows), self._path)
