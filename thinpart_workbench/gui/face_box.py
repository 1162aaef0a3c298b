"""The faces of one mapped part."""

from .face_table import FaceTable
from .qt import QtWidgets, Signal, translate
from .result_view import show_text, text_line


class FaceBox(QtWidgets.QWidget):
    """The table of faces, or why there is none.

    Signals
    -------
    face_chosen(int)
        A row was selected; number of the face, from 0.
    """

    face_chosen = Signal(int)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_FaceBox")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._words = text_line(self, column, "ThinPart_FaceWords")
        self.table = FaceTable(self)
        self.table.row_chosen.connect(lambda row: self.face_chosen.emit(row.summary.face))
        column.addWidget(self.table)
        self.show_no_part()

    def show_faces(self, summaries, features, unit):
        """See `FaceTable.show_faces`."""
        show_text(self._words, "")
        self.table.show()
        self.table.show_faces(summaries, features, unit)

    def show_no_part(self):
        """Several parts are shown."""
        show_text(self._words, translate("ThinPart", "Choose a part in the list to see its faces."))
        self.table.set_rows([])
        self.table.hide()
