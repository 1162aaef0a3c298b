"""A field for a folder, with a button to choose it."""

import os

from .qt import QtWidgets, Signal, translate


class FolderField(QtWidgets.QWidget):
    """A line for a folder that may be left empty.

    Parameters
    ----------
    name : str
        The line's object name; the button's has ``Choose`` at its end.
    when_empty : str
        What an empty line stands for.

    Signals
    -------
    changed
        The text has changed.
    """

    changed = Signal()

    def __init__(self, name, when_empty, parent=None):
        super().__init__(parent)
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self._line = QtWidgets.QLineEdit(self)
        self._line.setObjectName(name)
        self._line.setPlaceholderText(when_empty)
        self._line.setClearButtonEnabled(True)
        self._line.textChanged.connect(lambda _: self.changed.emit())
        self.setFocusProxy(self._line)
        button = QtWidgets.QPushButton(translate("ThinPart", "Choose\u2026"), self)
        button.setObjectName(f"{name}Choose")
        button.setAutoDefault(False)
        button.clicked.connect(lambda *_: self._ask())
        row.addWidget(self._line, 1)
        row.addWidget(button)

    def value(self):
        """Absolute path, or empty."""
        return absolute(self._line.text())

    def show_value(self, folder):
        """Show a folder."""
        self._line.setText(folder)

    def _ask(self):
        folder = QtWidgets.QFileDialog.getExistingDirectory(
            self, translate("ThinPart", "Choose a folder"), self._line.text())
        if folder:
            self._line.setText(folder)


def absolute(text):
    """The absolute path that a person means; empty for nothing."""
    return os.path.abspath(os.path.expanduser(text.strip())) if text.strip() else ""
