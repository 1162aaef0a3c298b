# SPDX-License-Identifier: LGPL-2.1-or-later
"""Widgets below each other, each of which can be removed."""

from ..application.qt import QtWidgets


class RemovableList(QtWidgets.QVBoxLayout):
    """Editors of the items of a list.

    Parameters
    ----------
    on_change : callable
        Called when an item has changed, and after one was removed.
    """

    def __init__(self, on_change):
        super().__init__()
        self.editors = []
        self._on_change = on_change

    def append(self, editor):
        """Add a widget with the signals ``changed`` and ``removed``."""
        editor.changed.connect(self._on_change)
        editor.removed.connect(lambda: self._remove(editor))
        self.editors.append(editor)
        self.addWidget(editor)

    def move(self, editor, places):
        """Move a widget by a number of places, down where that is positive."""
        number = self.editors.index(editor) + places
        self.editors.remove(editor)
        self.editors.insert(number, editor)
        self.removeWidget(editor)
        self.insertWidget(number, editor)
        self._on_change()

    def _remove(self, editor):
        self.editors.remove(editor)
        self.removeWidget(editor)
        editor.hide()
        editor.deleteLater()
        self._on_change()
