# SPDX-License-Identifier: LGPL-2.1-or-later
"""The list of libraries: the folders to search."""

import os

from ...freecad_adapter.preferences import preference_list, set_preference_list
from ..application.qt import QtCore, QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..record.category_marks import colour_icon
from ..record.record_view import show_text, show_warning, text_line
from ..tables.row_model import FAILED_COLOUR
from ..widgets.buttons import add_button
from ..widgets.file_dialogs import choose_folder
from ..widgets.flow_layout import add_flow
from ..widgets.folder_field import contains

_PREFERENCE = "Libraries"


class LibrariesPage(QtWidgets.QWidget):
    """The library folders with their number of parts and their problems.

    Signals
    -------
    changed
        A folder was added or removed.
    refresh_requested, stop_requested
        The corresponding button was pressed.
    report_requested(object)
        A report is wanted: list of str, the selected library, or all of them.
    """

    changed = Signal()
    refresh_requested = Signal()
    stop_requested = Signal()
    report_requested = Signal(object)

    def __init__(self, parent=None):
        super().__init__(parent)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        row = add_flow(column, self)
        add_button(row, self, "ThinPart_AddLibrary", translate("ThinPart", "Add\u2026"), self._ask)
        self._remove = add_button(
            row, self, "ThinPart_RemoveLibrary", translate("ThinPart", "Remove"), self.remove_selected)
        self._refresh = add_button(
            row, self, "ThinPart_RefreshLibraries", translate("ThinPart", "Refresh"), self.refresh_requested.emit)
        self._stop = add_button(
            row, self, "ThinPart_StopRefresh", translate("ThinPart", "Stop"), self.stop_requested.emit)
        self._report = add_button(row, self, "ThinPart_LibraryReportButton", translate("ThinPart", "Report\u2026"),
                                  lambda: self.report_requested.emit(self._chosen() or self.roots))
        self._report.setToolTip(translate(
            "ThinPart", "Writes a page about all parts of the libraries, or of the selected one: how many there are of each "
                        "kind, a map, what is there more than once, and a table"))
        self._list = QtWidgets.QListWidget(self)
        self._list.setObjectName("ThinPart_LibraryList")
        self._list.setTextElideMode(QtCore.Qt.ElideMiddle)
        self._list.setMinimumHeight(3 * self.fontMetrics().height())
        self._list.itemSelectionChanged.connect(self._show_buttons)
        column.addWidget(self._list, 1)  # below the buttons: it gets lower where something is to be said
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_LibraryBar")
        column.addWidget(self._bar)
        self._progress_text = text_line(self, column, "ThinPart_LibraryProgress")
        self._problems = text_line(self, column, "ThinPart_LibraryProblems")
        self.show_libraries([])

    @property
    def roots(self):
        """list of str: the library folders."""
        return preference_list(_PREFERENCE)

    def add(self, folder):
        """Add a folder, str, unless another library already contains it."""
        folder = os.path.abspath(folder)
        outer = [root for root in self.roots if contains(root, folder)]
        if outer:
            self._show_problem(translate("ThinPart", "{} is in the list already, as a part of {}.").format(
                folder, outer[0]) if outer[0] != folder else translate(
                "ThinPart", "{} is in the list already.").format(folder))
            return
        inner = [root for root in self.roots if contains(folder, root)]
        set_preference_list(_PREFERENCE, [root for root in self.roots if root not in inner] + [folder])
        if inner:
            self._show_problem(translate("ThinPart", "{} contains {}, which was removed from the list.").format(
                folder, ", ".join(inner)))
        self.changed.emit()

    def remove_selected(self):
        """Remove the selected folder from the list; its files stay unchanged."""
        chosen = self._chosen()
        set_preference_list(_PREFERENCE, [root for root in self.roots if root not in chosen])
        self.changed.emit()

    def show_libraries(self, libraries):
        """Show the list.

        Parameters
        ----------
        libraries : list of dict
            ``root``, ``parts``, ``problems`` and ``busy``.
        """
        chosen = self._chosen()
        self._list.clear()
        for library in libraries:
            count = grouped(library["parts"])
            item = QtWidgets.QListWidgetItem(
                translate("ThinPart", "{} ({} parts)").format(library["root"], count), self._list)
            item.setData(QtCore.Qt.UserRole, library["root"])
            item.setToolTip(library["root"])
            if library["problems"]:
                item.setIcon(colour_icon(FAILED_COLOUR))
            item.setSelected(library["root"] in chosen)
        problems = [problem for library in libraries for problem in library["problems"]]
        show_text(self._problems, "\n".join("\u26a0 " + translated(problem) for problem in problems))
        self._show_busy(any(library["busy"] for library in libraries))
        self._show_buttons()

    def show_progress(self, progress):
        """Show the progress of a refresh.

        Parameters
        ----------
        progress : dict
            ``root``, ``done`` and ``total``; while searching for info files, ``done`` is 0 and ``total`` the number found.
        """
        self._show_busy(True)
        name = os.path.basename(progress["root"]) or progress["root"]
        if progress["done"]:
            self._bar.setRange(0, progress["total"])
            self._bar.setValue(progress["done"])
            self._progress_text.setText(translate("ThinPart", "{}: {} of {} info files read").format(
                name, grouped(progress["done"]), grouped(progress["total"])))
        else:
            self._bar.setRange(0, 0)
            self._progress_text.setText(translate("ThinPart", "{}: looking for info files, {} so far").format(
                name, grouped(progress["total"])))

    def show_failed(self, sentence):
        """Show that the worker process has failed."""
        self._show_busy(False)
        self._show_problem(sentence)

    def _show_problem(self, sentence):
        show_warning(self._problems, sentence)

    def _show_busy(self, busy):
        self._bar.setVisible(busy)
        self._progress_text.setVisible(busy)
        self._stop.setEnabled(busy)
        self._refresh.setEnabled(not busy and bool(self.roots))

    def _show_buttons(self):
        self._remove.setEnabled(bool(self._chosen()))
        self._report.setEnabled(bool(self.roots))

    def _chosen(self):
        """Folders of the selected libraries: list of str."""
        return [item.data(QtCore.Qt.UserRole) for item in self._list.selectedItems()]

    def _ask(self):
        choose_folder(self, "", self.add, translate("ThinPart", "Choose a folder with classified parts"))
