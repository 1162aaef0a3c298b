# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of faces of one mapped part."""

from ..application.length_unit import MILLIMETRE
from ..application.qt import QtWidgets, Signal, translate
from ..record.record_view import show_text, text_line
from .face_menu import FaceMenu
from .face_table import FaceTable


class FaceBox(QtWidgets.QWidget):
    """The table of faces, or a hint why it is empty.

    Signals
    -------
    face_chosen(int)
        The user selected a row: face number, from 0.
    visited(object)
        The user wants to see where a face is thinnest: thickness, mm, and FaceSummary.
    limited(str, object)
        The user gives a face limits of its own: its name, and a dict, see `FaceMenu`.
    """

    face_chosen = Signal(int)
    visited = Signal(object)
    limited = Signal(str, object)

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_FaceBox")
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        self._hint = text_line(self, column, "ThinPart_FaceWords")
        self.table = FaceTable(self)
        self.table.row_chosen.connect(lambda row: self.face_chosen.emit(row.summary.face))
        self.table.visited.connect(self.visited)
        self.table.row_menu = self._menu
        column.addWidget(self.table)
        self._own = text_line(self, column, "ThinPart_FaceLimits")
        self._limits, self._refusal, self._unit = {}, "", MILLIMETRE
        self.show_limits((), "")
        self.show_no_part()

    def show_faces(self, summaries, features, unit, record, file):
        """See `FaceTable.show_faces`."""
        show_text(self._hint, "")
        self._unit = unit
        self.table.show()
        self.table.show_faces(summaries, features, unit, record, file)

    def show_limits(self, limits, refusal, problem=""):
        """Show the limits of single faces.

        Parameters
        ----------
        limits : list of dict
            ``face_limits`` of the part.
        refusal : str
            Why none can be kept; empty if they can.
        problem : str, optional
            What went wrong when some were kept.
        """
        self._limits = {limit["face"]: {key: limit[key] for key in ("min_mm", "max_mm", "reason") if key in limit}
                        for limit in limits}
        self._refusal = refusal
        lines = [translate("ThinPart", "{}: walls {} ({})").format(
            face, " \u2013 ".join(self._unit.text(limit[key]) if key in limit else "\u2026" for key in ("min_mm", "max_mm")),
            limit["reason"]) for face, limit in self._limits.items()]
        show_text(self._own, "\n".join([*([problem] if problem else []), *lines]))

    def _menu(self, row):
        if row is None:
            return QtWidgets.QMenu(self)
        return FaceMenu(row, self._limits.get(row.name, {}), self._unit, self._refusal,
                        lambda limits: self.limited.emit(row.name, limits), self)

    def show_no_part(self):
        """Hide the table, because several parts are shown."""
        show_text(self._hint, translate("ThinPart", "Choose a part in the list to see its faces."))
        self.table.model().set_rows([])
        self.table.hide()
