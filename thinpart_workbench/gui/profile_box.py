"""Choosing thresholds: a shipped profile or a file."""

import os

from ..core.criteria import PROFILES, load_profile
from ..core.errors import ThinPartError
from .qt import QtWidgets, translate
from .sentences import translated
from .wheel import keep_from_wheel


class ProfileBox(QtWidgets.QComboBox):
    """The shipped profiles by their titles, and the files that were chosen."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(16)
        keep_from_wheel(self)
        for path in sorted(PROFILES.glob("*.json")):
            self.addItem(_title(path.stem), path.stem)

    def choose(self, name):
        """Choose a profile.

        Parameters
        ----------
        name : str
            A shipped one's name, or a file.
        """
        if self.findData(name) < 0:
            self.addItem(_title(name), name)
        self.setCurrentIndex(self.findData(name))

    def ask_for_file(self):
        """Have the user choose a file."""
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with thresholds"), "",
            translate("ThinPart", "Thresholds (*.json)"))
        if file:
            self.choose(file)


def _title(name):
    try:
        return translated(load_profile(name).title)
    except ThinPartError:
        return os.path.basename(name)  # what is wrong with it is said when it is to be used
