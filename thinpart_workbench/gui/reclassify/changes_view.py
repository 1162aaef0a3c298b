# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a profile would change in libraries: the counts of changes, and the parts of the selected change."""

import os

from ...core.categories import MEASURE_AGAIN, UNKNOWN
from ...freecad_adapter.preferences import preference_list
from ..application.qt import QtCore, QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..document.open_part import open_part, told_by
from ..record.category_marks import colour_icon
from ..record.kept_room import keep_room
from ..record.record_view import show_text, text_line
from ..record.verdict_text import category_colour, category_title
from ..widgets.buttons import add_button
from ..widgets.flow_layout import add_flow
from ..widgets.folder_field import contains
from ..widgets.row_table import show_whole_rows
from .judging_client import JudgingClient

_CHANGE = QtCore.Qt.UserRole


class ChangesView(QtWidgets.QWidget):
    """The counts, and the parts of the selected change, which can be opened and found.

    Parameters
    ----------
    name : str
        In the object names of its widgets: ``ThinPart_NAMEChanges``, ...
    parent : QWidget

    Attributes
    ----------
    client : JudgingClient

    Signals
    -------
    find_requested(str, str)
        The user wants to see a part in the panel that finds parts: its info file and name.
    """

    find_requested = Signal(str, str)

    def __init__(self, name, parent):
        super().__init__(parent)
        self._profile, self._selected = None, None
        self.client = JudgingClient(self)
        self.client.counted.connect(self._show_counts)
        self.client.parts_received.connect(self._show_parts)
        self.client.failed.connect(self._show_failed)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self._headline = text_line(self, column, f"ThinPart_{name}Changes")
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName(f"ThinPart_{name}Bar")
        column.addWidget(self._bar)
        keep_room(self._bar)
        self._table = self._new_table(f"ThinPart_{name}ChangesTable")
        column.addWidget(self._table, 20)
        self._parts_title = text_line(self, column, f"ThinPart_{name}PartsTitle")
        self._parts = QtWidgets.QListWidget(self)
        self._parts.setObjectName(f"ThinPart_{name}Parts")
        self._parts.setTextElideMode(QtCore.Qt.ElideMiddle)
        self._parts.itemSelectionChanged.connect(self._show_buttons)
        self._parts.itemDoubleClicked.connect(lambda _: self.open_current())
        column.addWidget(self._parts, 30)
        row = add_flow(column, self)
        self._actions = row.parentWidget()
        self._open = add_button(row, self, f"ThinPart_{name}OpenPart", translate("ThinPart", "Open part"), self.open_current,
                                is_for_enter=False)
        self._find = add_button(row, self, f"ThinPart_{name}FindPart", translate("ThinPart", "Show in Find parts"),
                                self._find_current, is_for_enter=False)
        self._message = text_line(self, column, f"ThinPart_{name}CountMessage")
        column.addStretch(1)
        self._clear()

    def open(self, roots, without="", behind_modal=False):
        """Count in folders, list of str; what was read before is read again.

        Parameters
        ----------
        roots : list of str
        without : str
            What to say where there are none.
        behind_modal : bool
            Whether a modal dialog keeps the user from the main window, where parts are opened and found.
        """
        for button in (self._open, self._find):
            button.setHidden(behind_modal)
        self._clear()
        show_text(self._headline, translate("ThinPart", "Counting\u2026") if roots else without)
        self.client.open(roots)

    def show_profile(self, profile, problem=""):
        """Count what a profile changes.

        Parameters
        ----------
        profile : Profile or None
            None where it cannot be used.
        problem : str
            Why it cannot.
        """
        self._profile = profile
        if profile is None:
            self._clear()
            show_text(self._headline, translate("ThinPart", "Not counted: {}").format(problem))
        self.client.judge(None if profile is None else profile.content)

    def open_current(self):
        """Open the document of the selected part."""
        part = self._current_part()
        if part is not None:
            show_text(self._message, told_by(lambda: open_part(part["file"], part["name"])))

    def _show_counts(self, counts):
        changed = sum(count for _, after, count in counts["changes"] if after != MEASURE_AGAIN)
        again = sum(count for _, after, count in counts["changes"] if after == MEASURE_AGAIN)
        is_complete = counts["read"] == counts["total"]
        sentences = [translate("ThinPart", "{} of {} parts change their category.").format(
            grouped(changed), grouped(counts["parts"]))]
        if is_complete and not counts["parts"]:
            sentences = [translate("ThinPart", "There are no classified parts.")]
        if again:
            sentences.append(translate(
                "ThinPart", "To be measured again, because an earlier version did not measure what decides: {}.").format(
                grouped(again)))
        show_text(self._headline, " ".join(sentences))
        self._bar.setVisible(not is_complete)
        self._bar.setRange(0, max(1, counts["total"]))
        self._bar.setValue(counts["read"])
        problems = list(map(translated, counts["problems"][:3]))
        if counts["failed"] > len(problems):
            problems.append(translate("ThinPart", "{} info files cannot be read.").format(grouped(counts["failed"])))
        show_text(self._message, "\n".join("\u26a0 " + sentence for sentence in problems))
        self._show_changes(counts["changes"])

    def _show_changes(self, changes):
        self._table.blockSignals(True)
        self._table.setRowCount(len(changes))
        for row, (before, after, count) in enumerate(changes):
            for column, name in enumerate((before, after)):
                cell = QtWidgets.QTableWidgetItem(colour_icon(category_colour(UNKNOWN if name == MEASURE_AGAIN else name)),
                                                  self._title(name))
                cell.setToolTip(cell.text())
                cell.setData(_CHANGE, [before, after])
                self._table.setItem(row, column, cell)
            cell = QtWidgets.QTableWidgetItem(grouped(count))
            cell.setTextAlignment(QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter)
            self._table.setItem(row, 2, cell)
        known = [(before, after) for before, after, _ in changes]
        if self._selected in known:
            self._table.selectRow(known.index(self._selected))
        else:
            self._table.clearSelection()
            self._selected = None
        self._table.setVisible(bool(changes))
        self._table.blockSignals(False)
        self._request_parts()

    def _on_change_selected(self):
        items = self._table.selectedItems()
        self._selected = tuple(items[0].data(_CHANGE)) if items else None
        self._request_parts()

    def _request_parts(self):
        if self._selected is None:
            self._parts.clear()
            self._show_parts_box(False)
        else:
            self.client.request_parts(*self._selected)

    def _show_parts(self, answer):
        if (answer["before"], answer["after"]) != self._selected:
            return
        part = self._current_part()
        self._parts.clear()
        for row in answer["rows"]:
            item = QtWidgets.QListWidgetItem(f"{row['label']}  \u2013  {os.path.basename(row['file'])}", self._parts)
            item.setToolTip(row["file"])
            item.setData(_CHANGE, row)
            if part is not None and (row["info_file"], row["name"]) == (part["info_file"], part["name"]):
                self._parts.setCurrentItem(item)
        self._parts_title.setText(f"{self._title(self._selected[0])} \u2192 {self._title(self._selected[1])}")
        self._show_parts_box(True)

    def _show_parts_box(self, shown):
        for widget in (self._parts_title, self._parts, self._actions):
            widget.setVisible(shown)
        self._show_buttons()

    def _show_buttons(self):
        part = self._current_part()
        self._open.setEnabled(part is not None)
        is_in_library = part is not None and any(
            contains(root, part["info_file"]) for root in preference_list("Libraries"))
        self._find.setEnabled(is_in_library)

    def _current_part(self):
        item = self._parts.currentItem()
        return item.data(_CHANGE) if item is not None else None

    def _find_current(self):
        part = self._current_part()
        if part is not None:
            self.find_requested.emit(part["info_file"], part["name"])

    def _show_failed(self, sentence):
        self._bar.hide()
        show_text(self._message, sentence)

    def _clear(self):
        self._bar.hide()
        self._table.setRowCount(0)
        self._table.hide()
        self._selected = None
        self._parts.clear()
        self._show_parts_box(False)
        show_text(self._headline, "")
        show_text(self._message, "")

    def _title(self, name):
        if name == MEASURE_AGAIN:
            return translate("ThinPart", "to be measured again")
        return category_title(name, self._profile)

    def _new_table(self, name):
        table = QtWidgets.QTableWidget(0, 3, self)
        table.setObjectName(name)
        table.setHorizontalHeaderLabels([
            translate("ThinPart", "Before"), translate("ThinPart", "After"), translate("ThinPart", "Parts")])
        show_whole_rows(table)
        table.verticalHeader().hide()
        table.setEditTriggers(QtWidgets.QAbstractItemView.NoEditTriggers)
        header = table.horizontalHeader()
        header.setHighlightSections(False)
        header.setSectionResizeMode(QtWidgets.QHeaderView.Stretch)
        header.setSectionResizeMode(2, QtWidgets.QHeaderView.ResizeToContents)
        table.itemSelectionChanged.connect(self._on_change_selected)
        return table
