# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a preference page."""

import os

from ...core.errors import ThinPartError
from ...core.judging.criteria import load_profile
from ...freecad_adapter.preferences import PREFERENCES, preference, set_preference
from ...storage.user_limits import limits_named
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, translate, translated_mark
from ..application.sentences import translated
from ..application.thread_work import PATIENCE, check_path_in_thread
from ..guide.command import lead_to_guide
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.controls import prepare_controls
from .fields import new_field

_CHECK_DELAY = 300
"""Milliseconds after the last key press before what a text refers to is checked."""


class PreferencesForm(QtWidgets.QWidget):
    """Edits the preferences of one of `PAGES`; changes are stored only by `save`.

    Attributes
    ----------
    fields : dict
        Each `Field` by the name of its preference.
    """

    def __init__(self, page):
        super().__init__()
        self.setObjectName(f"ThinPart_Preferences{page}")
        self.setWindowTitle(translated_mark(page))
        self.fields, self._stored, self._problems = {}, {}, {}
        self._declared = [declared for declared in PREFERENCES.values() if declared.page == page]
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        # A small screen cannot show the whole page.
        area = QtWidgets.QScrollArea(self)
        area.setWidgetResizable(True)
        area.setFrameShape(QtWidgets.QFrame.NoFrame)
        area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        content = QtWidgets.QWidget(area)
        self._add_groups(content)
        self._add_defaults(page, content)
        area.setWidget(content)
        for widget in (area.viewport(), content):
            widget.setAutoFillBackground(False)
        area.setMinimumWidth(content.minimumSizeHint().width()
                             + area.verticalScrollBar().sizeHint().width())
        column.addWidget(area, 1)
        self._check_timer = QtCore.QTimer(self, singleShot=True, interval=_CHECK_DELAY)
        self._check_timer.timeout.connect(self._check)
        for name, field in self.fields.items():
            field.changed.connect(lambda *_, name=name: self._on_changed(name))
        prepare_controls(self)
        lead_to_guide(self, "ThinPart_Preferences")
        self.load()

    def load(self):
        """Show the stored preferences."""
        for name, field in self.fields.items():
            field.show_value(preference(name))
            self._stored[name] = field.value()
        for name in self.fields:
            self._on_changed(name)
            self._show_problem(name, "")

    def show_defaults(self):
        """Show the defaults."""
        for name, field in self.fields.items():
            field.show_value(PREFERENCES[name].default)

    def save(self):
        """Store changed preferences, and warn about invalid ones."""
        for name, field in self.fields.items():
            value = field.value()
            if value == self._stored[name]:
                continue
            if PREFERENCES[name].names == "folder" and value:
                _store_folder(name, value)
                continue
            problem = _problem(name, value)
            self._show_problem(name, problem)
            if problem:
                lifelong.notifications.warn(problem)  # the page may be about to close
            else:
                set_preference(name, value)
                self._stored[name] = value

    def _add_groups(self, content):
        column = QtWidgets.QVBoxLayout(content)
        grids = {}
        for declared in self._declared:
            if declared.group not in grids:
                box = QtWidgets.QGroupBox(translated_mark(declared.group), content)
                grids[declared.group] = QtWidgets.QGridLayout(box)
                grids[declared.group].setColumnStretch(2, 1)
                column.addWidget(box)
            self._add_row(grids[declared.group], declared)
        labels = content.findChildren(QtWidgets.QLabel)
        width = max((label.sizeHint().width() for label in labels), default=0)
        for grid in grids.values():
            grid.setColumnMinimumWidth(0, width)

    def _add_defaults(self, page, content):
        column = content.layout()
        self._message = text_line(content, column, f"ThinPart_PreferencesMessage{page}")
        row = QtWidgets.QHBoxLayout()
        row.addStretch(1)
        button = add_button(row, content, f"ThinPart_PreferencesDefaults{page}", translate(
            "ThinPart", "Restore defaults"), self.show_defaults, is_for_enter=False)
        button.setToolTip(translate(
            "ThinPart", "Shows the defaults of this page; OK or Apply saves them"))
        column.addLayout(row)
        column.addStretch(1)

    def _add_row(self, grid, declared):
        row, parent = grid.rowCount(), grid.parentWidget()
        field = self.fields[declared.name] = new_field(declared, parent)
        if isinstance(declared.default, bool):
            grid.addWidget(field.widget, row, 0, 1, 3)
        else:
            label = QtWidgets.QLabel(translated_mark(declared.title), parent)
            label.setToolTip(field.widget.toolTip())
            label.setBuddy(field.widget)
            grid.addWidget(label, row, 0)
            grid.addWidget(field.widget, row, 1, 1, 2 if declared.names else 1)

    def _on_changed(self, name):
        for declared in self._declared:
            if declared.needs and declared.needs[0] == name:
                self.fields[declared.name].widget.setEnabled(
                    self.fields[name].value() == declared.needs[1])
        if PREFERENCES[name].names:
            self._check_timer.start()

    def _check(self):
        """Check what a changed text refers to before it is saved."""
        for name, field in self.fields.items():
            value = field.value()
            if PREFERENCES[name].names in ("profile", "processes"):
                self._show_problem(name, "" if value == self._stored[name] else _problem(name, value))
            elif PREFERENCES[name].names == "folder" and (not value or value == self._stored[name]):
                self._show_problem(name, "")
            elif PREFERENCES[name].names == "folder":
                check_path_in_thread(
                    lambda folder=value: _folder_problem(folder),
                    lambda answer, name=name, folder=value: self._on_folder_checked(name, folder, answer), self)

    def _on_folder_checked(self, name, folder, answer):
        if self.fields[name].value() == folder:
            self._show_problem(name, _timeout_message(folder) if answer is None else answer)

    def _show_problem(self, name, problem):
        self._problems[name] = problem
        show_text(self._message, "\n".join("\u26a0 " + problem for problem in self._problems.values() if problem))


def _problem(name, value):
    """Message why a value is invalid; empty if it is valid."""
    try:
        if PREFERENCES[name].names == "profile":
            load_profile(value)
        elif PREFERENCES[name].names == "processes":
            limits_named(value.split(","))
    except ThinPartError as error:
        return translated(error)
    return ""


def _store_folder(name, folder):
    """Check a folder in the background and store it if it is valid."""
    def on_answer(answer):
        problem = _timeout_message(folder) if answer is None else answer
        if problem:
            lifelong.notifications.warn(problem)
        else:
            set_preference(name, folder)

    # Without a parent, because the page may be deleted by then.
    check_path_in_thread(lambda: _folder_problem(folder), on_answer)


def _folder_problem(folder):
    """Message why info files cannot be written into a folder; empty if they can."""
    if not os.path.isdir(folder):
        return translate("ThinPart", "There is no folder {}: create it first, or choose another one for the info "
                                     "files.").format(folder)
    if not os.access(folder, os.W_OK | os.X_OK):
        return translate("ThinPart", "The folder {} is not writable: choose another folder for the info "
                                     "files.").format(folder)
    return ""


def _timeout_message(folder):
    return translate("ThinPart", "The folder {} has not answered for {} s: connect it, or choose another "
                     "one for the info files.").format(folder, f"{PATIENCE:g}")
