"""A combo box for threshold profiles: the shipped ones, or a file."""

import os

from ...core.errors import ThinPartError
from ...core.judging.criteria import PROFILES, load_profile
from ...storage.user_profiles import user_profiles
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, translate
from ..application.sentences import translated


class ProfileCombo(QtWidgets.QComboBox):
    """Lists the shipped profiles by title, the user's own, and other files that the user has chosen."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(16)
        for path in sorted(PROFILES.glob("*.json")):
            self.addItem(_title(path.stem), path.stem)
        for path in user_profiles():
            self._add(str(path))
        lifelong.profile_signals.saved.connect(self._show_saved)

    def choose(self, name):
        """Choose a profile.

        Parameters
        ----------
        name : str
            Name of a shipped profile, or path of a file.
        """
        if self.findData(name) < 0:
            self._add(name)
        self.setCurrentIndex(self.findData(name))

    def _add(self, name):
        self.addItem(_title(name), name)
        self.setItemData(self.count() - 1, name, QtCore.Qt.ToolTipRole)

    def _show_saved(self, name):
        """Show the title that a profile has after it was saved."""
        place = self.findData(name)
        if place < 0:
            self._add(name)
        else:
            self.setItemText(place, _title(name))

    def ask_for_file(self):
        """Let the user choose a file."""
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with thresholds"), "",
            translate("ThinPart", "Thresholds (*.json)"))
        if file:
            self.choose(file)


def _title(name):
    try:
        return translated(load_profile(name).title)
    except ThinPartError:
        return os.path.basename(name)  # the error is reported when the profile is used
