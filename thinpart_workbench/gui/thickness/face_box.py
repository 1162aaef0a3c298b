# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of faces of one mapped part."""

from ..application.qt import QtWidgets, Signal, translate
from ..record.record_view import show_text, text_line
from .face_table import FaceTable


class FaceBox(QtWidgets.QWidget):
    """The table of faces, or a hint why it is empty.

    Signals
    -------
    face_chosen(int)
        The user selected a row: face number, from 0.
    visited(object)
        The user wants to see where a face is thinnest: thickness, mm, and FaceSummary.
    """

    face_chosen = Signal(int)
    visited = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_FaceBox")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._hint = text_line(self, column, "ThinPart_FaceWords")
        self.table = FaceTable(self)
        self.table.row_chosen.connect(lambda row: self.face_chosen.emit(row.summary.face))
        self.table.visited.connect(self.visited)
        column.addWidget(self.table)
        self.show_no_part()

    def show_faces(self, summaries, features, unit, record, file):
        """See `FaceTable.show_faces`."""
        show_text(self._hint, "")
        self.table.show()
        self.table.show_faces(summaries, features, unit, record, file)

    def show_no_part(self):
        """Hide the table, because several parts are shown."""
        show_text(self._hint, translate("ThinPart", "Choose a part in the list to see its faces."))
        self.table.model().set_rows([])
        self.table.hide()
