# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog that edits profiles and limits of the wall."""

import os
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.judging.criteria import PROFILES, load_profile, usable_profile
from ...core.kinds.file_marks import PROFILE
from ...freecad_adapter.preferences import set_preference
from ...storage.user_profiles import user_profiles_folder, write_profile
from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtCore, QtGui, QtWidgets, execute, translate
from ..application.sentences import translated
from ..guide.command import help_button
from ..library.command import show_find_parts
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.confirmation import may_overwrite
from ..widgets.file_dialogs import chosen_output
from ..widgets.profile_combo import ProfileCombo
from .changes_panel import ChangesPanel
from .edited_profile import named_content
from .limits_page import LimitsPage
from .thresholds_page import ThresholdsPage


class ProfileDialog(QtWidgets.QDialog):
    """The choice of a profile, its criteria beside what they would change, and the limits of the wall."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_ProfileDialog")
        self.setWindowTitle(translate("ThinPart", "Edit profile"))
        self.setWindowIcon(icon("ThinPart_EditProfile"))
        self._name, self._start, self._problem, self._behind_modal = "", None, "", False
        column = QtWidgets.QVBoxLayout(self)
        self._tabs = QtWidgets.QTabWidget(self)
        self._tabs.setObjectName("ThinPart_ProfileTabs")
        self._thresholds = ThresholdsPage(self)
        self._thresholds.changed.connect(self._on_changed)
        self._changes = ChangesPanel(self)
        self._changes.view.find_requested.connect(self._find_part)
        splitter = QtWidgets.QSplitter(QtCore.Qt.Horizontal, self)
        splitter.addWidget(self._thresholds)
        splitter.addWidget(self._changes)
        splitter.setStretchFactor(0, 3)
        splitter.setStretchFactor(1, 2)
        splitter.setSizes([640, 380])
        for position in range(2):
            splitter.setCollapsible(position, False)
        page = QtWidgets.QWidget(self)
        below = QtWidgets.QVBoxLayout(page)
        below.setContentsMargins(6, 6, 6, 6)
        self._add_choice(below)
        below.addWidget(splitter, 1)
        self._message = text_line(page, below, "ThinPart_ProfileMessage")
        self._add_buttons(page, below)
        self._limits = LimitsPage(self)
        self._tabs.addTab(page, translate("ThinPart", "Thresholds"))
        self._tabs.addTab(self._limits, translate("ThinPart", "Limits of the wall"))
        column.addWidget(self._tabs, 1)
        row = QtWidgets.QHBoxLayout()
        row.addStretch(1)
        row.addWidget(help_button(self, "ThinPart_EditProfile"))
        add_button(row, self, "ThinPart_ProfileClose", translate("ThinPart", "Close"), self.close,
                   is_for_enter=False)
        column.addLayout(row)
        self._check_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._check_timer.timeout.connect(self._check)
        self.resize(1080, 720)

    @property
    def is_waiting(self):
        """Whether the counts of changes are not complete yet."""
        return self._check_timer.isActive() or self._changes.view.client.is_waiting

    @property
    def is_changed(self):
        """Whether the profile differs from the file."""
        return self._start is not None and self._thresholds.content() != self._start

    def begin(self, name, behind_modal=False):
        """Start editing.

        Parameters
        ----------
        name : str
            Name of a shipped profile, or path of a file.
        behind_modal : bool
            See `ChangesView.open`.
        """
        self._behind_modal = behind_modal
        self._limits.load()
        self._changes.begin(behind_modal)
        if not self._load(name) and self._start is None:
            sentence = self._message.text()
            self._load(load_profile().name)
            self._show_message(sentence)

    def choose(self, name):
        """Edit another profile, once the user has said what to do with unsaved changes."""
        if name != self._name and self._may_leave():
            self._load(name)

    def open_file(self, file):
        """Edit the profile in a file, str, such as a colleague's."""
        self.choose(os.path.abspath(file))

    def save(self):
        """Write the profile to its file, a shipped one to another; returns whether it was written."""
        return self._ask_where() if self._is_shipped else self.save_as(self._name)

    def save_as(self, file, overwrite=False):
        """Write the profile to a file, also to one that is no profile where `overwrite`; returns whether it was written."""
        self._check()
        if self._problem:
            self._show_message(self._problem)
            return False
        file = os.path.abspath(file)
        content = named_content(self._thresholds.content(), self._start, Path(file).stem)
        try:
            usable_profile(content, file)
            write_profile(content, file, overwrite)
        except ThinPartError as error:
            self._show_message(translated(error))
            return False
        sentence = translate("ThinPart", "Saved in {}.").format(file)
        if "probability" in self._start and "probability" not in content:
            sentence = translate(
                "ThinPart", "Saved in {}, without the probabilities, which belong to other thresholds.").format(file)
        self._load(file)
        lifelong.profile_signals.saved.emit(file)
        self._show_message(sentence)
        return True

    def use(self):
        """Judge by the profile from now on; changes are saved first."""
        if self.is_changed and not self.save():
            return
        set_preference("Profile", self._name)
        lifelong.profile_signals.used.emit(self._name)
        self._show_message(translate(
            "ThinPart", "Parts are judged by '{}' from now on. Parts that were classified before keep their verdicts until "
            "you reclassify them.").format(self._profile_combo.currentText()))
        self._reclassify.setVisible(not self._behind_modal)

    def reset(self):
        """Take all changes back."""
        self._thresholds.show_content(self._start)
        self._on_changed()

    def show_folder(self):
        """Show the folder of the profile in the desktop's file manager."""
        folder = os.path.dirname(self._file)
        if not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(folder)):
            self._show_message(translate(
                "ThinPart", "No file manager was found: open the folder {} yourself.").format(folder))

    def copy_path(self):
        """Put the path of the profile on the clipboard."""
        QtWidgets.QApplication.clipboard().setText(self._file)
        self._show_message(translate("ThinPart", "Copied: {}").format(self._file))

    def end(self):
        """Stop counting and delete the dialog, without asking."""
        self._start = None
        self._changes.view.client.end()
        self.hide()
        self.deleteLater()

    def reject(self):
        """Close, unless the user wants to keep unsaved changes; Qt calls this for Escape and the window's button too."""
        if self._may_leave() and self._may_leave_limits():
            self._changes.view.client.end()
            self._start = None
            super().reject()

    @property
    def _is_shipped(self):
        return (PROFILES / f"{self._name}.json").is_file()

    @property
    def _file(self):
        return str(PROFILES / f"{self._name}.json") if self._is_shipped else self._name

    def _load(self, name):
        """Read a profile and show it; returns whether that was possible."""
        try:
            content = load_profile(name).content
        except ThinPartError as error:
            self._show_choice()
            self._show_message(translated(error))
            return False
        self._name, self._start = name, content
        self._show_choice()
        self._thresholds.show_content(content)
        self._on_changed()
        return True

    def _show_choice(self):
        blocked = self._profile_combo.blockSignals(True)
        if self._name:
            self._profile_combo.choose(self._name)
        self._profile_combo.blockSignals(blocked)
        self._profile_combo.setToolTip(self._file if self._name else "")

    def _on_changed(self):
        self._show_message("")
        self._check_timer.start()

    def _check(self):
        """Check the profile as it is now, and count what it changes if it can be used."""
        self._check_timer.stop()
        if self._start is None:
            return
        self._problem, profile = self._thresholds.problem(), None
        if not self._problem:
            try:
                profile = usable_profile(self._thresholds.content())
            except ThinPartError as error:
                self._problem = translated(error)
        self._changes.view.show_profile(profile, self._problem)
        self._show_state()

    def _show_state(self):
        changed = self.is_changed
        name = Path(self._file).stem
        self.setWindowTitle(translate("ThinPart", "Edit profile: {}").format(f"{name} *" if changed else name))
        self._reset.setEnabled(changed)
        self._save.setEnabled(changed and not self._problem and not self._is_shipped)
        self._save_as.setEnabled(not self._problem)
        self._use.setEnabled(not self._problem)
        self._save.setToolTip(translate(
            "ThinPart", "A profile that comes with ThinPart stays as it is: save under another name") if self._is_shipped
            else self._file)

    def _show_message(self, sentence):
        show_text(self._message, sentence)
        self._reclassify.hide()

    def _may_leave(self):
        """Whether unsaved changes of the profile were saved, or may be lost."""
        return not self.is_changed or self._saved_or_discarded(
            translate("ThinPart", "The profile has unsaved changes."), self.save)

    def _may_leave_limits(self):
        return not self._limits.is_changed or self._saved_or_discarded(
            translate("ThinPart", "The limits of the wall have unsaved changes."), self._limits.save)

    def _saved_or_discarded(self, sentence, save):
        """Ask whether to save; returns whether that was done, or is not wanted."""
        buttons = QtWidgets.QMessageBox.Save | QtWidgets.QMessageBox.Discard | QtWidgets.QMessageBox.Cancel
        box = QtWidgets.QMessageBox(QtWidgets.QMessageBox.Question, "", sentence, buttons, self)
        box.setObjectName("ThinPart_ProfileQuestion")
        box.setInformativeText(translate("ThinPart", "Save them?"))
        box.setDefaultButton(QtWidgets.QMessageBox.Save)
        answer = execute(box)
        box.deleteLater()
        return save() if answer == QtWidgets.QMessageBox.Save else answer == QtWidgets.QMessageBox.Discard

    def _find_part(self, info_file, name):
        show_find_parts().show_part(info_file, name)

    def _show_reclassify(self):
        show_find_parts().show_reclassify(self._name)

    def _on_profile_chosen(self):
        name = self._profile_combo.currentData()
        if name == self._name:
            return
        if not self._may_leave() or not self._load(name):
            self._show_choice()

    def _ask_for_file(self):
        file, _ = QtWidgets.QFileDialog.getOpenFileName(
            self, translate("ThinPart", "Choose a file with thresholds"), str(user_profiles_folder()),
            translate("ThinPart", "Thresholds (*.json)"))
        if file:
            self.open_file(file)

    def _ask_where(self):
        """Let the user choose a file and write it; returns whether it was written."""
        folder = user_profiles_folder() if self._is_shipped else Path(self._file).parent
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError:
            folder = Path.home()  # the user may choose any other
        chosen = chosen_output(self, "ThinPart_ProfileSaveDialog", translate("ThinPart", "Save the profile as"),
                               str(folder / f"my_{Path(self._file).stem}.json"),
                               translate("ThinPart", "Thresholds (*.json)"))
        return bool(chosen) and self._save_chosen(chosen)

    def _save_chosen(self, file):
        """Write to a file that the user chose, and ask first where it is no profile; returns whether it was written."""
        try:
            overwrite = may_overwrite(self, file, PROFILE)
        except ThinPartError as error:
            self._show_message(translated(error))
            return False
        except OSError:
            overwrite = False  # the attempt says what is wrong
        return overwrite is not None and self.save_as(file, overwrite)

    def _add_choice(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "&Profile:"), self)
        self._profile_combo = ProfileCombo(self)
        self._profile_combo.setObjectName("ThinPart_ProfileChoice")
        self._profile_combo.currentIndexChanged.connect(lambda _: self._on_profile_chosen())
        label.setBuddy(self._profile_combo)
        row.addWidget(label)
        row.addWidget(self._profile_combo, 1)
        button = add_button(row, self, "ThinPart_ProfileOpen", translate("ThinPart", "&Open\u2026"), self._ask_for_file,
                            is_for_enter=False)
        button.setToolTip(translate("ThinPart", "Opens a profile that somebody has given you"))
        column.addLayout(row)

    def _add_buttons(self, page, column):
        row = QtWidgets.QHBoxLayout()

        def add(name, text, callback, meaning=""):
            button = add_button(row, page, f"ThinPart_Profile{name}", text, callback, is_for_enter=False)
            button.setToolTip(meaning)
            return button

        self._reclassify = add("Reclassify", translate("ThinPart", "Reclassify libraries\u2026"), self._show_reclassify)
        row.addStretch(1)
        self._reset = add("Reset", translate("ThinPart", "&Reset to saved"), self.reset)
        self._save = add("Save", translate("ThinPart", "&Save"), self.save)
        self._save_as = add("SaveAs", translate("ThinPart", "Save &as\u2026"), self._ask_where)
        self._use = add("Use", translate("ThinPart", "&Use it"), self.use, translate(
            "ThinPart", "Saves the profile and judges parts by it from now on"))
        self._share = add("Share", translate("ThinPart", "S&hare"), lambda: None)
        menu = QtWidgets.QMenu(self._share)
        for name, text, callback in (
                ("Folder", translate("ThinPart", "Show in file manager"), self.show_folder),
                ("CopyPath", translate("ThinPart", "Copy path"), self.copy_path)):
            action = menu.addAction(text)
            action.setObjectName(f"ThinPart_ProfileShare{name}")
            action.triggered.connect(lambda *_, callback=callback: callback())
        self._share.setMenu(menu)
        column.addLayout(row)
