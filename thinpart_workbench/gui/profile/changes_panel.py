"""What the edited profile would change in a library, counted while the user types."""

import os

from ...core.categories import MEASURE_AGAIN, UNKNOWN
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference_list
from ..application.qt import QtCore, QtWidgets, Signal, grouped, translate
from ..application.sentences import translated
from ..document.open_part import open_part
from ..record.category_marks import colour_icon
from ..record.record_view import show_text, text_line
from ..record.verdict_text import category_colour, category_title
from ..widgets.flow_layout import FlowLayout
from ..widgets.folder_field import contains
from ..widgets.push_button import add_button
from ..widgets.row_table import show_whole_rows
from .changes_client import ChangesClient
from .small_button import small_button

_CHANGE = QtCore.Qt.UserRole


class ChangesPanel(QtWidgets.QWidget):
    """The choice of a library, the counts of changes, and the parts of the selected change.

    Signals
    -------
    find_requested(str, str)
        The user wants to see a part in the panel that finds parts: its info file and name.
    """

    find_requested = Signal(str, str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._profile, self._selected, self._other_folders = None, None, []
        self._client = ChangesClient(self)
        self._client.counted.connect(self._show_counts)
        self._client.parts_received.connect(self._show_parts)
        self._client.failed.connect(self._show_failed)
        column = QtWidgets.QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 4)
        label = QtWidgets.QLabel(translate("ThinPart", "What would change in"), self)
        column.addWidget(label)
        self._library = QtWidgets.QComboBox(self)
        self._library.setObjectName("ThinPart_ProfileLibrary")
        self._library.setSizeAdjustPolicy(QtWidgets.QComboBox.AdjustToMinimumContentsLengthWithIcon)
        self._library.setMinimumContentsLength(16)
        label.setBuddy(self._library)
        row = QtWidgets.QHBoxLayout()
        row.addWidget(self._library, 1)
        row.addWidget(small_button(self, "ThinPart_ProfileReadAgain", "\u21bb", translate(
            "ThinPart", "Read the info files again, which may have changed"), self._on_library_chosen))
        column.addLayout(row)
        self._headline = text_line(self, column, "ThinPart_ProfileChanges")
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ProfileBar")
        column.addWidget(self._bar)
        self._table = self._new_table()
        column.addWidget(self._table, 20)
        self._parts_title = text_line(self, column, "ThinPart_ProfilePartsTitle")
        self._parts = QtWidgets.QListWidget(self)
        self._parts.setObjectName("ThinPart_ProfileParts")
        self._parts.setTextElideMode(QtCore.Qt.ElideMiddle)
        self._parts.itemSelectionChanged.connect(self._show_buttons)
        self._parts.itemDoubleClicked.connect(lambda _: self.open_current())
        column.addWidget(self._parts, 30)
        container = QtWidgets.QWidget(self)
        row = FlowLayout(container)
        self._open = add_button(row, self, "ThinPart_ProfileOpenPart", translate("ThinPart", "Open part"), self.open_current)
        self._find = add_button(
            row, self, "ThinPart_ProfileFindPart", translate("ThinPart", "Show in Find parts"), self._find_current)
        for button in (self._open, self._find):
            button.setAutoDefault(False)
        column.addWidget(container)
        self._message = text_line(self, column, "ThinPart_ProfileCountMessage")
        self._actions = container
        column.addStretch(1)
        self._fill_libraries()
        self._library.currentIndexChanged.connect(lambda _: self._on_library_chosen())
        self._clear()

    @property
    def is_waiting(self):
        """Whether counts are not complete yet."""
        return self._client.is_waiting

    def begin(self, behind_modal=False):
        """Count in the libraries that there are now.

        Parameters
        ----------
        behind_modal : bool
            Whether a modal dialog keeps the user from the main window, where parts are opened and found.
        """
        for button in (self._open, self._find):
            button.setHidden(behind_modal)
        self._fill_libraries()
        self._on_library_chosen()

    def show_profile(self, profile, problem=""):
        """Count what a profile changes.

        Parameters
        ----------
        profile : Profile or None
            None where the edited one cannot be used.
        problem : str
            Why it cannot.
        """
        self._profile = profile
        if profile is None:
            self._clear()
            show_text(self._headline, translate("ThinPart", "Not counted: {}").format(problem))
        self._client.judge(None if profile is None else profile.content)

    def open_current(self):
        """Open the document of the selected part."""
        part = self._current_part()
        if part is None:
            return
        QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
        try:
            open_part(part["file"], part["name"])
            sentence = ""
        except ThinPartError as error:
            sentence = translated(error)
        finally:
            QtWidgets.QApplication.restoreOverrideCursor()
        show_text(self._message, sentence)

    def choose_folder(self, folder):
        """Count in a folder that need not be a library."""
        folder = os.path.abspath(folder)
        if folder not in self._other_folders:
            self._other_folders.append(folder)
        self._fill_libraries(folder)
        self._on_library_chosen()

    def end(self):
        """Stop counting."""
        self._client.end()

    @property
    def _roots(self):
        return self._library.currentData() or []

    def _fill_libraries(self, chosen=None):
        """List the libraries of the panel that finds parts, and the folders chosen here."""
        libraries = preference_list("Libraries")
        before = [chosen] if chosen else self._roots
        blocked = self._library.blockSignals(True)
        self._library.clear()
        if len(libraries) > 1:
            self._library.addItem(translate("ThinPart", "all {} libraries").format(len(libraries)), libraries)
        for folder in [*libraries, *(each for each in self._other_folders if each not in libraries)]:
            self._library.addItem(folder, [folder])
            self._library.setItemData(self._library.count() - 1, folder, QtCore.Qt.ToolTipRole)
        if not self._library.count():
            self._library.addItem(translate("ThinPart", "no library yet"), [])
        self._library.addItem(translate("ThinPart", "Another folder\u2026"), None)
        places = [place for place in range(self._library.count() - 1) if self._library.itemData(place) == before]
        self._library.setCurrentIndex(places[0] if places else 0)
        self._library.blockSignals(blocked)

    def _on_library_chosen(self):
        if self._library.currentData() is None:
            folder = QtWidgets.QFileDialog.getExistingDirectory(
                self, translate("ThinPart", "Choose a folder with classified parts"))
            if folder:
                self.choose_folder(folder)
            else:
                self._library.setCurrentIndex(0)
            return
        self._library.setToolTip("\n".join(self._roots))
        self._clear()
        show_text(self._headline, translate("ThinPart", "Counting\u2026") if self._roots else translate(
            "ThinPart", "Choose a folder with classified parts, or add one under 'Libraries' in the panel 'Find parts'."))
        self._client.open(self._roots)

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
            self._client.request_parts(*self._selected)

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

    def _new_table(self):
        table = QtWidgets.QTableWidget(0, 3, self)
        table.setObjectName("ThinPart_ProfileChangesTable")
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
