# SPDX-License-Identifier: LGPL-2.1-or-later
"""An input field for a folder, with a button to choose one.

Notes
-----
FreeCAD's ``Gui::FileChooser`` is no alternative: once a folder is entered, it asks the file system for it in the
window's thread, which a server that does not answer would hold up.
"""

import os

from ..application.qt import QtWidgets, Signal, translate
from .buttons import add_button
from .file_dialogs import choose_folder


class FolderField(QtWidgets.QWidget):
    """A line edit for a folder, which may stay empty, and a button.

    Parameters
    ----------
    name : str
        Object name of the line edit; ``Choose`` is appended for the button.
    when_empty : str
        Placeholder: what an empty field means.

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
        row.addWidget(self._line, 1)
        add_button(row, self, f"{name}Choose", translate("ThinPart", "Choose\u2026"), self._choose, is_for_enter=False)

    def value(self):
        """The absolute path, or an empty string."""
        return absolute(self._line.text())

    def show_value(self, folder):
        """Set the folder."""
        self._line.setText(folder)

    def _choose(self):
        choose_folder(self, self._line.text(), self.show_value)


def absolute(text):
    """The absolute path of what the user has entered, with ``~`` expanded; empty for an empty text."""
    return os.path.abspath(os.path.expanduser(text.strip())) if text.strip() else ""


def contains(outer, inner):
    """Whether a folder is another one or contains it, or a file, through links too."""
    outer, inner = os.path.realpath(outer), os.path.realpath(inner)
    return inner == outer or inner.startswith(os.path.join(outer, ""))
