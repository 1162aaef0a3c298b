"""The widgets of a page of preferences."""

import os

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.settings import PREFERENCES, preference, set_preference
from .notices import NOTICES
from .path_question import PATIENCE, ask_about_path
from .preference_fields import new_field
from .push_button import add_button
from .qt import QtCore, QtWidgets, translate, translated_mark
from .result_view import show_text, text_line
from .sentences import translated
from .wheel import keep_from_wheel

_TYPING = 300
"""Milliseconds after the last key until a folder is looked at."""


class PreferencesForm(QtWidgets.QWidget):
    """Shows the preferences of a page and keeps what is changed; nothing is kept before `save`.

    Parameters
    ----------
    page : str
        One of `PAGES`.
    """

    def __init__(self, page):
        super().__init__()
        self.setObjectName(f"ThinPart_Preferences{page}")
        self.setWindowTitle(translated_mark(page))
        self._fields, self._kept, self._problems = {}, {}, {}
        self._declared = [each for each in PREFERENCES.values() if each.page == page]
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        # On a small screen the page is lower than what is on it.
        area = QtWidgets.QScrollArea(self)
        area.setWidgetResizable(True)
        area.setFrameShape(QtWidgets.QFrame.NoFrame)
        area.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarAlwaysOff)
        content = QtWidgets.QWidget(area)
        self._add_groups(content)
        self._add_defaults(page, content)
        area.setWidget(content)
        for each in (area.viewport(), content):
            each.setAutoFillBackground(False)
        area.setMinimumWidth(content.minimumSizeHint().width()
                             + area.verticalScrollBar().sizeHint().width())
        column.addWidget(area, 1)
        self._typed = QtCore.QTimer(self, singleShot=True, interval=_TYPING)
        self._typed.timeout.connect(self._check)
        for name, field in self._fields.items():
            field.changed.connect(lambda name=name: self._note(name))
        self.load()

    def load(self):
        """Show what is kept."""
        for name, field in self._fields.items():
            field.show_value(preference(name))
            self._kept[name] = field.value()
        for name in self._fields:
            self._note(name)
            self._show_problem(name, "")

    def show_defaults(self):
        """Show the defaults."""
        for name, field in self._fields.items():
            field.show_value(PREFERENCES[name].default)

    def save(self):
        """Keep what was changed, and say what cannot be kept."""
        for name, field in self._fields.items():
            value = field.value()
            if value == self._kept[name]:
                continue
            if PREFERENCES[name].names == "folder" and value:
                _keep_folder(name, value)
                continue
            problem = _problem(name, value)
            self._show_problem(name, problem)
            if problem:
                NOTICES.warn(problem)  # the page may be about to close
            else:
                set_preference(name, value)
                self._kept[name] = value

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
            "ThinPart", "Restore defaults"), self.show_defaults)
        button.setToolTip(translate(
            "ThinPart", "Shows the defaults of this page; they are kept with OK or Apply"))
        button.setAutoDefault(False)
        column.addLayout(row)
        column.addStretch(1)

    def _add_row(self, grid, declared):
        row, parent = grid.rowCount(), grid.parentWidget()
        field = self._fields[declared.name] = new_field(declared, parent)
        if isinstance(declared.default, bool):
            grid.addWidget(field, row, 0, 1, 3)
        else:
            label = QtWidgets.QLabel(translated_mark(declared.title), parent)
            label.setToolTip(field.toolTip())
            label.setBuddy(field)
            grid.addWidget(label, row, 0)
            grid.addWidget(field, row, 1, 1, 2 if declared.names else 1)
        for each in [field, *field.findChildren(QtWidgets.QWidget)]:
            if isinstance(each, (QtWidgets.QAbstractSpinBox, QtWidgets.QComboBox)):
                keep_from_wheel(each)

    def _note(self, name):
        for declared in self._declared:
            if declared.needs and declared.needs[0] == name:
                self._fields[declared.name].setEnabled(
                    self._fields[name].value() == declared.needs[1])
        if PREFERENCES[name].names:
            self._typed.start()

    def _check(self):
        """Say at once what is wrong with a profile or a folder."""
        for name, field in self._fields.items():
            value = field.value()
            if PREFERENCES[name].names == "profile":
                self._show_problem(name, "" if value == self._kept[name] else _problem(name, value))
            elif PREFERENCES[name].names == "folder" and (not value or value == self._kept[name]):
                self._show_problem(name, "")
            elif PREFERENCES[name].names == "folder":
                ask_about_path(
                    lambda folder=value: _folder_problem(folder),
                    lambda answer, name=name, folder=value: self._say(name, folder, answer), self)

    def _say(self, name, folder, answer):
        if self._fields[name].value() == folder:
            self._show_problem(name, _unanswered(folder) if answer is None else answer)

    def _show_problem(self, name, problem):
        self._problems[name] = problem
        show_text(self._message, "\n".join("\u26a0 " + each for each in self._problems.values() if each))


def _problem(name, value):
    """Why a value cannot be kept; empty where it can."""
    try:
        if PREFERENCES[name].names == "profile":
            load_profile(value)
    except ThinPartError as error:
        return translated(error)
    return ""


def _keep_folder(name, folder):
    """Keep a folder once it is known to be one, which nobody waits for."""
    def take(answer):
        problem = _unanswered(folder) if answer is None else answer
        if problem:
            NOTICES.warn(problem)
        else:
            set_preference(name, folder)

    # The page may be gone by then.
    ask_about_path(lambda: _folder_problem(folder), take, QtWidgets.QApplication.instance())


def _folder_problem(folder):
    """Why info files cannot go into a folder; empty where they can."""
    if not os.path.isdir(folder):
        return translate("ThinPart", "There is no folder {}: make it first, or choose another one for "
                         "the info files.").format(folder)
    if not os.access(folder, os.W_OK | os.X_OK):
        return translate("ThinPart", "Nothing can be written into {}: choose another folder for the "
                         "info files.").format(folder)
    return ""


def _unanswered(folder):
    return translate("ThinPart", "The folder {} has not answered for {} s: connect it, or choose another "
                     "one for the info files.").format(folder, f"{PATIENCE:g}")
