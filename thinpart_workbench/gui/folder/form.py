# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form for a folder and its classification settings."""

from dataclasses import replace

from ...core.file_formats import CHOICES
from ..application.qt import QtCore, QtWidgets, translate
from ..widgets.buttons import push_button
from ..widgets.file_dialogs import choose_folder
from ..widgets.flow_layout import FlowLayout
from ..widgets.folder_field import absolute
from ..widgets.process_field import ProcessField
from ..widgets.profile_combo import ProfileCombo
from .settings import FolderSettings, folder_history


class FolderForm(QtWidgets.QWidget):
    """Edits `FolderSettings`."""

    def __init__(self, parent=None):
        super().__init__(parent)
        self._grid = QtWidgets.QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setColumnStretch(1, 1)
        self._grid.setColumnStretch(3, 1)
        self._add_folder()
        self._add_names()
        self._add_info_location()
        self._add_profile()
        self._add_limits()
        self.show_settings(FolderSettings())
        # In a low window, the table shrinks instead of the form.
        self.setMinimumHeight(self.sizeHint().height())

    def show_settings(self, settings):
        """Show settings in the widgets."""
        self._folder.clear()
        self._folder.addItems(folder_history())
        self._folder.setCurrentText(settings.folder)
        for name, box in self._formats.items():
            box.setChecked(name in settings.formats)
        self._include.setText(settings.include)
        self._exclude.setText(settings.exclude)
        (self._beside if settings.beside else self._in_folder).setChecked(True)
        self._show_preferred(settings.preferred_folder)
        self._info_folder.setText(settings.info_folder)
        self._profile.choose(settings.profile)
        self._jobs.setValue(settings.jobs)
        self._seconds.setValue(settings.seconds)
        self._checks.show_value(settings.checks)
        self._force.setChecked(settings.force)

    def apply_preferences(self, before, after):
        """Apply changed preferences to the fields that the user has not changed in this form.

        `before` and `after` are the FolderSettings of the preferences before and after the change.
        """
        chosen = self.settings()
        changes = {name: getattr(after, name) for name in ("profile", "jobs", "seconds", "checks")
                   if getattr(chosen, name) == getattr(before, name)}
        self.show_settings(replace(chosen, preferred_folder=after.preferred_folder, **changes))

    def settings(self):
        """The chosen FolderSettings, not validated."""
        return FolderSettings(
            folder=absolute(self._folder.currentText()),
            formats=tuple(name for name, box in self._formats.items() if box.isChecked()),
            include=self._include.text().strip(), exclude=self._exclude.text().strip(),
            beside=self._beside.isChecked(), preferred_folder=self._preferred,
            info_folder=absolute(self._info_folder.text()), profile=self._profile.currentData(),
            jobs=self._jobs.value(), seconds=self._seconds.value(), checks=self._checks.value(),
            force=self._force.isChecked(),
        )

    def _add_folder(self):
        self._folder = self._named(QtWidgets.QComboBox(self), "Folder")
        self._folder.setEditable(True)
        self._folder.setInsertPolicy(QtWidgets.QComboBox.NoInsert)
        # A long path must not widen the window.
        self._folder.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._folder.setMinimumContentsLength(20)
        self._folder.lineEdit().setPlaceholderText(
            translate("ThinPart", "The folder with your parts; its subfolders are included"))
        choose = self._button("ChooseFolder", translate("ThinPart", "C&hoose\u2026"), lambda: choose_folder(
            self, self._folder.currentText(), self._folder.setCurrentText))
        self._row(0, translate("ThinPart", "&Folder"), self._folder, choose)

    def _add_names(self):
        container = QtWidgets.QWidget(self)
        flow = FlowLayout(container)
        self._formats = {}
        for name, endings in CHOICES.items():
            title = translate("ThinPart", "Meshes") if name == "Mesh" else name
            box = self._named(QtWidgets.QCheckBox(title, container), f"Format{name}")
            box.setToolTip(", ".join(endings))
            flow.addWidget(box)
            self._formats[name] = box
        self._row(1, translate("ThinPart", "Formats"), container)
        pattern = translate(
            "ThinPart", "Patterns of file names, separated by semicolons; one with a slash is "
            "compared with the path below the folder")
        self._include = self._named(QtWidgets.QLineEdit(self), "Include")
        self._include.setPlaceholderText(translate("ThinPart", "all, or such as: bracket*; *_v2*"))
        self._exclude = self._named(QtWidgets.QLineEdit(self), "Exclude")
        self._exclude.setPlaceholderText(translate("ThinPart", "such as: old/*; *draft*"))
        for field in (self._include, self._exclude):
            field.setToolTip(pattern)
        self._row(2, translate("ThinPart", "&Names"), self._include)
        self._row(2, translate("ThinPart", "E&xcept"), self._exclude, column=2)

    def _add_info_location(self):
        container = QtWidgets.QWidget(self)
        row = QtWidgets.QHBoxLayout(container)
        row.setContentsMargins(0, 0, 0, 0)
        self._beside = self._named(QtWidgets.QRadioButton(container), "InfoBeside")
        self._in_folder = self._named(QtWidgets.QRadioButton(
            translate("ThinPart", "&in the folder"), container), "InfoInFolder")
        self._info_folder = self._named(QtWidgets.QLineEdit(container), "InfoFolder")
        self._info_folder.setMinimumWidth(16 * self.fontMetrics().averageCharWidth())
        row.addWidget(self._beside)
        row.addWidget(self._in_folder)
        row.addWidget(self._info_folder, 1)
        choose = self._button("ChooseInfoFolder", translate("ThinPart", "Choose\u2026"), lambda: choose_folder(
            self, self._info_folder.text(), self._info_folder.setText))
        for widget in (self._info_folder, choose):
            widget.setEnabled(False)
            self._in_folder.toggled.connect(widget.setEnabled)
        self._row(3, translate("ThinPart", "Info files"), container, choose)

    def _show_preferred(self, folder):
        self._preferred = folder
        self._beside.setToolTip(folder)
        self._beside.setText(translate("ThinPart", "in the pre&ferred folder") if folder
                             else translate("ThinPart", "&beside each document"))

    def _add_profile(self):
        self._profile = self._named(ProfileCombo(self), "Profile")
        choose = self._button("ChooseProfile", translate("ThinPart", "From file\u2026"), self._profile.ask_for_file)
        self._row(4, translate("ThinPart", "&Thresholds"), self._profile, choose)

    def _add_limits(self):
        self._jobs = self._named(QtWidgets.QSpinBox(self), "Jobs")
        self._jobs.setRange(0, 1024)
        self._jobs.setSpecialValueText(translate("ThinPart", "one per processor"))
        self._row(5, translate("ThinPart", "Files at &once"), self._jobs)
        self._seconds = self._named(QtWidgets.QSpinBox(self), "Seconds")
        self._seconds.setRange(1, 7 * 24 * 3600)
        self._seconds.setSuffix(translate("ThinPart", " s"))
        self._row(5, translate("ThinPart", "Time &limit per file"), self._seconds, column=2)
        self._force = self._named(QtWidgets.QCheckBox(
            translate("ThinPart", "&Measure unchanged documents again"), self), "Force")
        self._checks = ProcessField("ThinPart_FolderChecks", self)
        self._checks.setToolTip(translate(
            "ThinPart", "Processes whose least and greatest wall the parts are checked against: a column each"))
        self._row(6, translate("ThinPart", "Chec&k for"), self._checks)
        self._grid.addWidget(self._force, 7, 1, 1, 4, QtCore.Qt.AlignLeft)

    def _row(self, row, text, field, button=None, column=0):
        """Add a label and its field; an unpaired field spans the row."""
        label = QtWidgets.QLabel(text, self)
        label.setBuddy(field)
        self._grid.addWidget(label, row, column)
        paired = row in (2, 5)
        columns = 1 if paired and column == 0 else 2 if paired else 3 if button else 4
        self._grid.addWidget(field, row, column + 1, 1, columns)
        if button is not None:
            self._grid.addWidget(button, row, 4)

    def _named(self, widget, name):
        widget.setObjectName(f"ThinPart_Folder{name}" if name != "Folder" else "ThinPart_Folder")
        return widget

    def _button(self, name, text, callback):
        return push_button(self, f"ThinPart_Folder{name}", text, callback, is_for_enter=False)
