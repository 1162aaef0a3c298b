# SPDX-License-Identifier: LGPL-2.1-or-later
"""Dialog that asks which part to use."""

from ..application.qt import QtCore, QtWidgets, execute, translate
from ..widgets.controls import prepare_controls


class PartChooser(QtWidgets.QDialog):
    """A list of parts, one of which can be chosen."""

    def __init__(self, parts, parent=None):
        super().__init__(parent)
        self.setObjectName("ThinPart_PartDialog")
        self.setWindowTitle(translate("ThinPart", "Classify part"))
        column = QtWidgets.QVBoxLayout(self)
        column.addWidget(QtWidgets.QLabel(translate("ThinPart", "Which part do you mean?"), self))
        self._list = QtWidgets.QListWidget(self)
        self._list.setObjectName("ThinPart_PartList")
        for index, part in enumerate(parts):
            text = part.label
            if part.instances > 1:
                text = translate("ThinPart", "{} ({} times)").format(text, part.instances)
            item = QtWidgets.QListWidgetItem(text, self._list)
            item.setData(QtCore.Qt.UserRole, index)
        self._list.setCurrentRow(0)
        self._list.itemDoubleClicked.connect(lambda _item: self.accept())
        column.addWidget(self._list)
        buttons = QtWidgets.QDialogButtonBox(
            QtWidgets.QDialogButtonBox.Ok | QtWidgets.QDialogButtonBox.Cancel, self)
        buttons.setObjectName("ThinPart_PartDialogButtons")
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        column.addWidget(buttons)
        prepare_controls(self)

    @property
    def index(self):
        """Index of the chosen part."""
        return self._list.currentItem().data(QtCore.Qt.UserRole)


def ask_for_part(parts, parent):
    """The part that the user picks from a list of those with ``label`` and ``instances``, or None."""
    dialog = PartChooser(parts, parent)
    try:
        return parts[dialog.index] if execute(dialog) else None
    finally:
        dialog.deleteLater()
