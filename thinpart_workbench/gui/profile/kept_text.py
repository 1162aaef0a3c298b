# SPDX-License-Identifier: LGPL-2.1-or-later
"""A line edit for a text of a profile that is shown in the user's language."""

from ..application.qt import QtWidgets, Signal
from ..application.sentences import translated


class KeptText(QtWidgets.QLineEdit):
    """Shows a title translated, and gives it back as it was written unless the user has changed it.

    Signals
    -------
    changed
        The user has changed the text.
    """

    changed = Signal()

    def __init__(self, name, text, parent):
        super().__init__(parent)
        self.setObjectName(name)
        self.show_written(text)
        self.textEdited.connect(lambda _: self.changed.emit())

    def show_written(self, text):
        """Show a text, str, as a profile has it."""
        self._written, self._shown = text, translated(text)
        self.setText(self._shown)
        self.setCursorPosition(0)

    def written(self):
        """str: the text as the profile shall have it."""
        return self._written if self.text() == self._shown else self.text().strip()
