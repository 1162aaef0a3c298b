# SPDX-License-Identifier: LGPL-2.1-or-later
"""An input field for processes whose limits of the wall are checked, with a menu of those that are known."""

from ...api.window.limits import offered_limits
from ...core.errors import ThinPartError
from ...storage.user_limits import new_user_limits, user_limits_file
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated


class ProcessField(QtWidgets.QWidget):
    """A line edit for names of processes with commas between them, which may stay empty, and a button.

    Parameters
    ----------
    name : str
        Object name of the line edit; ``Choose`` is appended for the button.

    Signals
    -------
    changed
        The text has changed.
    """

    changed = Signal()

    def __init__(self, name, parent=None):
        super().__init__(parent)
        row = QtWidgets.QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self._line = QtWidgets.QLineEdit(self)
        self._line.setObjectName(name)
        self._line.setPlaceholderText(translate("ThinPart", "none, or such as: FDM, die_casting:zinc"))
        self._line.setClearButtonEnabled(True)
        self._line.textChanged.connect(lambda _: self.changed.emit())
        self.setFocusProxy(self._line)
        button = QtWidgets.QPushButton(translate("ThinPart", "Choose\u2026"), self)
        button.setObjectName(f"{name}Choose")
        button.setAutoDefault(False)
        self._menu = QtWidgets.QMenu(button)
        self._menu.aboutToShow.connect(self._fill_menu)
        button.setMenu(self._menu)
        row.addWidget(self._line, 1)
        row.addWidget(button)

    def value(self):
        """The names as typed, without spaces around them: str."""
        return ", ".join(self._names())

    def show_value(self, names):
        """Set the names."""
        self._line.setText(names)

    def _names(self):
        return [name.strip() for name in self._line.text().split(",") if name.strip()]

    def _fill_menu(self):
        """A line for each process, with its materials below it."""
        self._menu.clear()
        chosen, submenu = {name.casefold() for name in self._names()}, self._menu
        known, unit = offered_limits(), length_unit()
        for name, limits in known.items():
            has_materials = any(each.startswith(f"{name}:") for each in known)
            if ":" not in name:
                submenu = self._menu.addMenu(translated(limits.full_title)) if has_materials else self._menu
                submenu.setToolTipsVisible(True)
            title = translate("ThinPart", "any material") if has_materials else (
                translated(limits.material) if limits.material else translated(limits.full_title))
            action = submenu.addAction(f"{title}, {_range_text(limits, unit)}")
            action.setCheckable(True)
            action.setChecked(name.casefold() in chosen)
            action.setToolTip("\n".join(filter(None, (translated(limits.note), limits.source))))
            action.toggled.connect(lambda on, name=name: self._choose(name, on))
        self._menu.addSeparator()
        action = self._menu.addAction(translate("ThinPart", "Edit your own limits\u2026"))
        action.setToolTip(str(user_limits_file()))
        action.triggered.connect(lambda *_: self._edit_own())

    def _edit_own(self):
        """Open the user's own limits in the desktop's editor; first they are a copy of the shipped ones."""
        try:
            file = new_user_limits()
        except ThinPartError as error:
            QtWidgets.QMessageBox.warning(self, translate("ThinPart", "Own limits"), translated(error))
            return
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(str(file)))

    def _choose(self, name, is_on):
        names = [each for each in self._names() if each.casefold() != name.casefold()]
        self.show_value(", ".join([*names, name] if is_on else names))


def _range_text(limits, unit):
    """The walls that a process can make, in a unit."""
    if limits.max_mm is None:
        return translate("ThinPart", "from {} on").format(unit.text(limits.min_mm))
    if limits.min_mm is None:
        return translate("ThinPart", "up to {}").format(unit.text(limits.max_mm))
    return translate("ThinPart", "{} to {}").format(unit.number(limits.min_mm), unit.text(limits.max_mm))
