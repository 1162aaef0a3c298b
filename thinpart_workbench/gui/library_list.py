"""The list of libraries: folders that are searched."""

import os

from ..freecad_adapter.settings import preference_list, set_preference_list
from .flow_layout import FlowLayout
from .push_button import add_button
from .qt import QtCore, QtWidgets, Signal, grouped, translate
from .result_filter import colour_icon
from .result_table import FAILED_COLOUR
from .result_view import show_text, text_line
from .sentences import translated

_PREFERENCE = "Libraries"


class LibraryList(QtWidgets.QWidget):
    """Folders, how many parts each holds, and what is wrong with them.

    Signals
    -------
    changed
        A folder was added or removed.
    refresh_asked, stop_asked
        The button of that name was pressed.
    """

    changed = Signal()
    refresh_asked = Signal()
    stop_asked = Signal()

    def __init__(self, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        self._list = QtWidgets.QListWidget(self)
        self._list.setObjectName("ThinPart_LibraryList")
        self._list.setTextElideMode(QtCore.Qt.ElideMiddle)
        self._list.setMinimumHeight(3 * self.fontMetrics().height())
        self._list.itemSelectionChanged.connect(self._show_buttons)
        column.addWidget(self._list, 1)
        place = QtWidgets.QWidget(self)
        row = FlowLayout(place)
        add_button(row, self, "ThinPart_AddLibrary", translate("ThinPart", "Add\u2026"), self._ask)
        self._remove = add_button(
            row, self, "ThinPart_RemoveLibrary", translate("ThinPart", "Remove"), self.remove_selected)
        self._refresh = add_button(
            row, self, "ThinPart_RefreshLibraries", translate("ThinPart", "Refresh"), self.refresh_asked.emit)
        self._stop = add_button(
            row, self, "ThinPart_StopRefresh", translate("ThinPart", "Stop"), self.stop_asked.emit)
        column.addWidget(place)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_LibraryBar")
        column.addWidget(self._bar)
        self._words = text_line(self, column, "ThinPart_LibraryProgress")
        self._problems = text_line(self, column, "ThinPart_LibraryProblems")
        self.show_libraries([])

    @property
    def roots(self):
        """list of str: the folders."""
        return preference_list(_PREFERENCE)

    def add(self, folder):
        """Add a folder; one that lies in another of the list is found there already.

        Parameters
        ----------
        folder : str
        """
        folder = os.path.abspath(folder)
        holding = [each for each in self.roots if _holds(each, folder)]
        if holding:
            self._say(translate("ThinPart", "{} is in the list already, as a part of {}.").format(
                folder, holding[0]) if holding[0] != folder else translate(
                "ThinPart", "{} is in the list already.").format(folder))
            return
        inner = [each for each in self.roots if _holds(folder, each)]
        set_preference_list(_PREFERENCE, [each for each in self.roots if each not in inner] + [folder])
        if inner:
            self._say(translate("ThinPart", "{} holds {} too, which was taken off the list.").format(
                folder, ", ".join(inner)))
        self.changed.emit()

    def remove_selected(self):
        """Take the selected folder off the list; nothing in it is touched."""
        chosen = {item.data(QtCore.Qt.UserRole) for item in self._list.selectedItems()}
        set_preference_list(_PREFERENCE, [each for each in self.roots if each not in chosen])
        self.changed.emit()

    def show_libraries(self, libraries):
        """Show the list.

        Parameters
        ----------
        libraries : list of dict
            ``root``, ``parts``, ``problems`` and ``busy``.
        """
        chosen = {item.data(QtCore.Qt.UserRole) for item in self._list.selectedItems()}
        self._list.clear()
        for each in libraries:
            count = grouped(each["parts"])
            item = QtWidgets.QListWidgetItem(
                translate("ThinPart", "{} ({} parts)").format(each["root"], count), self._list)
            item.setData(QtCore.Qt.UserRole, each["root"])
            item.setToolTip(each["root"])
            if each["problems"]:
                item.setIcon(colour_icon(FAILED_COLOUR))
            item.setSelected(each["root"] in chosen)
        problems = [sentence for each in libraries for sentence in each["problems"]]
        show_text(self._problems, "\n".join("\u26a0 " + translated(each) for each in problems))
        self._show_busy(any(each["busy"] for each in libraries))
        self._show_buttons()

    def show_progress(self, progress):
        """Show how far a refresh is.

        Parameters
        ----------
        progress : dict
            ``root``, ``done`` and ``total``; while info files are looked for, 0 and those found so far.
        """
        self._show_busy(True)
        name = os.path.basename(progress["root"]) or progress["root"]
        if progress["done"]:
            self._bar.setRange(0, progress["total"])
            self._bar.setValue(progress["done"])
            self._words.setText(translate("ThinPart", "{}: {} of {} info files read").format(
                name, grouped(progress["done"]), grouped(progress["total"])))
        else:
            self._bar.setRange(0, 0)
            self._words.setText(translate("ThinPart", "{}: looking for info files, {} so far").format(
                name, grouped(progress["total"])))

    def show_failed(self, sentence):
        """The process is gone."""
        self._show_busy(False)
        self._say(sentence)

    def _say(self, sentence):
        show_text(self._problems, "\u26a0 " + sentence if sentence else "")

    def _show_busy(self, busy):
        self._bar.setVisible(busy)
        self._words.setVisible(busy)
        self._stop.setEnabled(busy)
        self._refresh.setEnabled(not busy and bool(self.roots))

    def _show_buttons(self):
        self._remove.setEnabled(bool(self._list.selectedItems()))

    def _ask(self):
        folder = QtWidgets.QFileDialog.getExistingDirectory(
            self, translate("ThinPart", "Choose a folder with classified parts"))
        if folder:
            self.add(folder)


def _holds(outer, inner):
    outer, inner = os.path.realpath(outer), os.path.realpath(inner)
    return inner == outer or inner.startswith(os.path.join(outer, ""))
