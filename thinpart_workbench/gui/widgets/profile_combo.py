# SPDX-License-Identifier: LGPL-2.1-or-later
"""A combo box for threshold profiles: the shipped ones, or a file."""

from ...api.window.profiles import profile_choice, profile_choices, shipped_file
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, translate
from ..application.sentences import translated


class ProfileCombo(QtWidgets.QComboBox):
    """Lists the shipped profiles by title, the user's own, and other files that the user has chosen."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(16)
        for choice in profile_choices():
            self._add(choice)
        lifelong.profile_signals.saved.connect(self._show_saved)

    def choose(self, name):
        """Choose a profile: the name of a shipped one, or the path of a file."""
        if self.findData(name) < 0:
            self._add(profile_choice(name))
        self.setCurrentIndex(self.findData(name))

    def _add(self, choice):
        self.addItem(translated(choice.title), choice.name)
        if not shipped_file(choice.name):
            self.setItemData(self.count() - 1, choice.name, QtCore.Qt.ToolTipRole)

    def _show_saved(self, name):
        """Show the title that a profile has after it was saved."""
        place = self.findData(name)
        if place < 0:
            self._add(profile_choice(name))
        else:
            self.setItemText(place, translated(profile_choice(name).title))

    def ask_for_file(self):
        """Let the user choose a file."""
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with thresholds"), "",
            translate("ThinPart", "Thresholds (*.json)"))
        if file:
            self.choose(file)
