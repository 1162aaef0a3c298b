# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is learned from: a library, its labels, and the profile to start with."""

from ...freecad_adapter.preferences import preference, preference_list
from ..application.qt import QtCore, QtWidgets, translate
from ..widgets.buttons import add_button
from ..widgets.file_dialogs import choose_folder
from ..widgets.folder_field import absolute
from ..widgets.profile_combo import ProfileCombo


class LearnForm(QtWidgets.QWidget):
    """The fields of the dialog."""

    def __init__(self, parent=None):
        super().__init__(parent)
        grid = QtWidgets.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        self._add_folder(grid)
        self._add_labels(grid)
        self._add_start(grid)
        grid.setColumnStretch(1, 1)
        self.show_preferences()

    def show_preferences(self):
        """Offer the libraries that are searched, and begin with the preferred profile."""
        chosen = self._folder.currentText()
        self._folder.clear()
        self._folder.addItems(preference_list("Libraries"))
        if chosen:
            self._folder.setCurrentText(chosen)
        if self._profile.currentData() is None or not self._is_profile_chosen:
            self._profile.choose(preference("Profile"))
            self._is_profile_chosen = False

    def arguments(self):
        """dict: arguments of `learn`."""
        return {"library": absolute(self._folder.currentText()), "labels": self._label_files(),
                "kept_labels": self._kept.isChecked(), "profile": self._profile.currentData()}

    def add_label_file(self, file):
        """Take a CSV file of labels too."""
        if file not in self._label_files():
            self._files.addItem(file)

    _is_profile_chosen = False

    def _label_files(self):
        return [self._files.item(row).text() for row in range(self._files.count())]

    def _add_folder(self, grid):
        self._folder = QtWidgets.QComboBox(self)
        self._folder.setObjectName("ThinPart_LearnFolder")
        self._folder.setEditable(True)
        self._folder.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._folder.setMinimumContentsLength(30)
        self._folder.lineEdit().setPlaceholderText(translate("ThinPart", "a folder with classified parts"))
        self._row(grid, 0, translate("ThinPart", "&Library"), self._folder)
        add_button(grid, self, "ThinPart_LearnChooseFolder", translate("ThinPart", "Choose\u2026"), self._choose_folder,
                   0, 2, is_for_enter=False)

    def _add_labels(self, grid):
        self._kept = QtWidgets.QCheckBox(translate("ThinPart", "those that people keep in its info files"), self)
        self._kept.setObjectName("ThinPart_LearnKept")
        self._kept.setChecked(True)
        self._row(grid, 1, translate("ThinPart", "L&abels"), self._kept)
        self._files = QtWidgets.QListWidget(self)
        self._files.setObjectName("ThinPart_LearnFiles")
        self._files.setTextElideMode(QtCore.Qt.ElideMiddle)
        self._files.setSelectionMode(QtWidgets.QAbstractItemView.ExtendedSelection)
        self._files.setFixedHeight(5 * self.fontMetrics().height())
        self._files.itemSelectionChanged.connect(self._show_buttons)
        self._row(grid, 2, translate("ThinPart", "&Tables"), self._files)
        column = QtWidgets.QVBoxLayout()
        add_button(column, self, "ThinPart_LearnAddFile", translate("ThinPart", "Add\u2026"), self._choose_files)
        self._remove = add_button(
            column, self, "ThinPart_LearnRemoveFile", translate("ThinPart", "Remove"), self._remove_files)
        column.addStretch(1)
        grid.addLayout(column, 2, 2)
        self._show_buttons()

    def _add_start(self, grid):
        self._profile = ProfileCombo(self)
        self._profile.setObjectName("ThinPart_LearnProfile")
        self._profile.activated.connect(lambda *_: setattr(self, "_is_profile_chosen", True))
        self._row(grid, 3, translate("ThinPart", "Start &with"), self._profile)
        add_button(grid, self, "ThinPart_LearnChooseProfile", translate("ThinPart", "From file\u2026"), self._choose_profile,
                   3, 2, is_for_enter=False)

    def _row(self, grid, row, title, field):
        label = QtWidgets.QLabel(title, self)
        label.setBuddy(field)
        grid.addWidget(label, row, 0, QtCore.Qt.AlignTop if row == 2 else QtCore.Qt.AlignVCenter)
        grid.addWidget(field, row, 1)

    def _choose_folder(self):
        choose_folder(self, self._folder.currentText(), self._folder.setCurrentText)

    def _choose_files(self):
        files, _ = QtWidgets.QFileDialog.getOpenFileNames(
            self, translate("ThinPart", "Choose tables of labels"), self._folder.currentText(),
            translate("ThinPart", "Tables (*.csv)"))
        for file in files:
            self.add_label_file(file)

    def _remove_files(self):
        for item in self._files.selectedItems():
            self._files.takeItem(self._files.row(item))

    def _choose_profile(self):
        self._profile.ask_for_file()
        self._is_profile_chosen = True

    def _show_buttons(self):
        self._remove.setEnabled(bool(self._files.selectedItems()))
