# SPDX-License-Identifier: LGPL-2.1-or-later
"""The view of a table: how it looks, which columns are shown, and what can be done with its rows."""

from ...core.errors import ThinPartError
from ...core.kinds.file_marks import TABLE
from ...storage.part_table import SUBJECT, TableForm, write_table
from ..application.qt import QtCore, QtGui, QtWidgets, Signal, translate
from ..application.sentences import translated
from ..application.thread_work import work_in_thread
from ..widgets.confirmation import may_overwrite
from ..widgets.file_dialogs import chosen_output
from ..widgets.row_table import show_whole_rows


class TableView(QtWidgets.QTableView):
    """Shows a `RowModel`.

    Parameters
    ----------
    has_brief_headings : bool
        Whether headings leave out their unit, which is in their tool tip, where the columns have no room for it.

    Attributes
    ----------
    csv_form : TableForm or None
        What a file of the rows contains; by default the values of all columns.
    subject : tuple of str
        File, name and label of the part that the rows are about; empty where they are about none.
    csv_file : str
        The path that is proposed for a file of the rows; by default that of the part.
    row_menu : callable
        Maps a row, or None, to a QMenu with what can be done with it.

    Signals
    -------
    message, failed : str
        Outcome of an action, or the reason of its failure.
    saving_changed
        A file of the rows is being written, or no longer.
    """

    message = Signal(str)
    failed = Signal(str)
    saving_changed = Signal()

    def __init__(self, name, model, parent=None, has_brief_headings=False):
        super().__init__(parent)
        self.setObjectName(name)
        self.setModel(model)
        self.csv_form, self.subject, self.csv_file, self.csv_dialog = None, (), "", f"{name}_CsvDialog"
        self.row_menu = lambda row: QtWidgets.QMenu(self)
        self._chosen_columns = {}  # whether the user wants to see a column, by its key
        self._is_fitting = self._user_has_resized = self._is_writing = False
        self._has_brief_headings = has_brief_headings
        show_whole_rows(self)
        self.setContextMenuPolicy(QtCore.Qt.CustomContextMenu)
        self.customContextMenuRequested.connect(
            lambda place: self._pop_up(self.menu(self._row_at(place)), self.viewport(), place))
        # Fixed row height: with individual heights, Qt would have to measure 100,000 rows.
        self.verticalHeader().setSectionResizeMode(QtWidgets.QHeaderView.Fixed)
        header = self.horizontalHeader()
        header.setResizeContentsPrecision(50)
        header.setTextElideMode(QtCore.Qt.ElideRight)
        header.setSortIndicator(-1, QtCore.Qt.AscendingOrder)
        header.setContextMenuPolicy(QtCore.Qt.CustomContextMenu)
        header.customContextMenuRequested.connect(lambda place: self._pop_up(self.column_menu(), header, place))
        header.sectionResized.connect(self._on_section_resized)
        self.setSortingEnabled(True)
        self._paths = PathDelegate(self)
        model.modelReset.connect(self._show_columns)
        self._show_columns()

    @property
    def current_row(self):
        """The row that is current and selected, or None."""
        selected = {index.row() for index in self.selectionModel().selectedRows()}
        number = self.currentIndex().row()
        return self.model().row_at(number if number in selected else min(selected)) if selected else None

    @property
    def selected_rows(self):
        """list: the selected rows that are known, in their order."""
        numbers = sorted({index.row() for index in self.selectionModel().selectedRows()})
        return [row for row in map(self.model().row_at, numbers) if row is not None]

    def set_row_height(self, lines):
        """Set the height of rows, in lines of text."""
        self.verticalHeader().setMinimumSectionSize(1)
        self.verticalHeader().setDefaultSectionSize(round(lines * self.fontMetrics().height()))

    def show_columns(self, shown):
        """Show or hide columns: dict of bool by key."""
        self._chosen_columns.update(shown)
        self._show_columns()

    def fit_columns(self):
        """Fit the columns to their visible content and to the width, unless the user has resized one."""
        columns = self.model().columns
        shown = [number for number in range(len(columns)) if not self.isColumnHidden(number)]
        if self._user_has_resized or not shown:
            return
        letter, header, icon = self.fontMetrics().averageCharWidth(), self.horizontalHeader(), self.iconSize().width()
        headings = {number: self._heading_widths(number) for number in shown}
        widths, contents = {}, {}
        for number in shown:
            most = columns[number].most * letter + (max(0, icon - 16) if columns[number].picture else 0)
            contents[number] = min(max(self.sizeHintForColumn(number) + 4, 3 * letter, header.minimumSectionSize()), most)
            widths[number] = min(max(contents[number], headings[number][0] + 4), most)

        def excess():
            return sum(widths.values()) - self.viewport().width()

        def cut_headings(form):
            for number in sorted(shown, key=lambda number: contents[number] - widths[number]):
                least = max(contents[number], 0 if form is None else headings[number][form])
                widths[number] -= max(0, min(widths[number] - least, excess()))

        # Headings give way before what stands below them: they have tool tips.
        cut_headings(1)
        cut_headings(2)
        # The one with most to give gives way first, so that a long message does not push the numbers out of view.
        spare = {number: widths[number] - columns[number].least * letter for number in shown if columns[number].least}
        for number in sorted(spare, key=spare.__getitem__, reverse=True):
            widths[number] -= max(0, min(spare[number], excess()))
        cut_headings(None)
        for number in shown:
            if columns[number].stretches:
                widths[number] += max(0, -excess())
        if self._has_brief_headings:
            self.model().show_brief({columns[number].key for number in shown if widths[number] < headings[number][1]})
        self._is_fitting = True
        for number, width in widths.items():
            self.setColumnWidth(number, width)
        self._is_fitting = False

    def resizeEvent(self, event):
        """Fit the columns to the width: that of the window, or what a scroll bar leaves of it."""
        super().resizeEvent(event)
        self.fit_columns()

    def _heading_widths(self, number):
        """What a heading takes: with room for the arrow of sorting; without; and without its unit: tuple of int."""
        column, header, unit = self.model().columns[number], self.horizontalHeader(), self.model().unit
        margins = 2 * self.style().pixelMetric(QtWidgets.QStyle.PM_HeaderMargin, None, header) + 4

        def taken(title):
            return header.fontMetrics().boundingRect(title).width() + margins

        whole = taken(column.heading(unit))
        brief = taken(column.brief(unit)) if self._has_brief_headings else whole
        arrow = header.sectionSizeHint(number) - taken(self.model().headerData(number, QtCore.Qt.Horizontal))
        is_sorted = number == header.sortIndicatorSection()
        return whole + arrow, whole + arrow * is_sorted, brief + arrow * is_sorted

    def menu(self, row=None):
        """QMenu with what can be done with a row, by default the current one, and with all rows."""
        menu = self.row_menu(self.current_row if row is None else row)
        if menu.actions():
            menu.addSeparator()
        action = menu.addAction(translate("ThinPart", "&Export CSV\u2026"))
        action.setObjectName("ThinPart_TableCsv")
        action.setEnabled(self.can_save)
        action.triggered.connect(lambda *_: self.save_csv())
        return menu

    def copy(self):
        """Put the selected rows on the clipboard, as their cells are shown, with tabs between them."""
        numbers = sorted({index.row() for index in self.selectionModel().selectedRows()})
        rows = [self.model().row_at(number) for number in numbers]
        if None in rows:
            self.model().collect(lambda every: self._copy([every[number] for number in numbers]))
        else:
            self._copy(rows)

    @property
    def can_save(self):
        """Whether there are rows of which a file can be written, and none is being written."""
        return not self._is_writing and self.model().rowCount() > 0

    def save_csv(self):
        """Ask for a file and write the shown rows to it."""
        proposed = self.csv_file or "".join(self.subject[:1])
        chosen = chosen_output(self, self.csv_dialog, translate("ThinPart", "Export the rows that are shown"),
                               f"{proposed}.csv", translate("ThinPart", "Tables (*.csv)"))
        if chosen:
            self.write_csv(chosen)

    def write_csv(self, path):
        """Write the shown rows to a file; one that ThinPart did not write is replaced only where the user says so."""
        if not path.lower().endswith(".csv"):
            self.failed.emit(translate(
                "ThinPart", "The table was not written to {}: choose a file name that ends with .csv.").format(path))
            return
        try:
            overwrite = may_overwrite(self, path, TABLE)
        except ThinPartError as error:
            self.failed.emit(translated(error))
        except OSError as error:
            self.failed.emit(_not_written(path, error))
        else:
            if overwrite is not None:
                form = self.csv_form or self._form_of_values()
                self.model().collect(lambda rows: self._write(path, form, rows, overwrite))

    def event(self, event):
        """Keep the keys of copying from FreeCAD, which would copy objects."""
        if event.type() == QtCore.QEvent.ShortcutOverride and event.matches(QtGui.QKeySequence.Copy):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event):
        """Copy the selected rows."""
        if event.matches(QtGui.QKeySequence.Copy):
            self.copy()
        else:
            super().keyPressEvent(event)

    def _copy(self, rows):
        model, header = self.model(), self.horizontalHeader()
        numbers = [header.logicalIndex(place) for place in range(len(model.columns))]
        shown = [model.columns[number] for number in numbers if not self.isColumnHidden(number)]
        lines = ("\t".join(" ".join(column.shown(row, model.unit).split()) for column in shown) for row in rows if row)
        QtWidgets.QApplication.clipboard().setText("\n".join(lines))

    def _form_of_values(self):
        columns, subject = self.model().columns, self.subject
        return TableForm((*SUBJECT[:len(subject)], *(column.key for column in columns)),
                         lambda row: (*subject, *(column.value(row) for column in columns)))

    def _write(self, path, form, rows, overwrite):
        def end(error):
            self._is_writing = False
            if error is None:
                self.message.emit(translate("ThinPart", "The {} rows that are shown were written to {}.").format(
                    len(known), path))
            else:
                self.failed.emit(_not_written(path, error))
            self.saving_changed.emit()

        known = [row for row in rows if row is not None]
        # Row by row, so that the thread of the window gets the interpreter lock in between.
        blocks = (form.text([row]) for row in known)
        self._is_writing = True
        self.saving_changed.emit()
        work_in_thread(lambda: write_table(path, form, blocks, overwrite), end)

    def _row_at(self, place):
        index = self.indexAt(place)
        return self.model().row_at(index.row()) if index.isValid() else None

    def _pop_up(self, menu, widget, place):
        menu.setAttribute(QtCore.Qt.WA_DeleteOnClose)
        menu.popup(widget.mapToGlobal(place))

    def column_menu(self):
        """QMenu with a check mark for each column."""
        menu = QtWidgets.QMenu(self)
        menu.setObjectName("ThinPart_TableColumns")
        model = self.model()
        for number, column in enumerate(model.columns):
            action = menu.addAction(column.heading(model.unit))
            action.setObjectName(f"ThinPart_Column_{column.key}")
            action.setToolTip(column.meaning)
            action.setCheckable(True)
            action.setChecked(not self.isColumnHidden(number))
            action.toggled.connect(lambda is_on, column=column: self._choose_column(column.key, is_on))
        menu.setToolTipsVisible(True)
        return menu

    def _choose_column(self, key, is_shown):
        self.show_columns({key: is_shown})
        self.fit_columns()

    def _on_section_resized(self, *_):
        self._user_has_resized = self._user_has_resized or not self._is_fitting

    def _show_columns(self):
        self._is_fitting = True
        for number, column in enumerate(self.model().columns):
            self.setColumnHidden(number, not self._chosen_columns.get(column.key, not column.is_hidden))
            self.setItemDelegateForColumn(number, self._paths if column.is_path else None)
        self._is_fitting = False


class PathDelegate(QtWidgets.QStyledItemDelegate):
    """Elides long paths in the middle, because both ends are the most informative."""

    def initStyleOption(self, option, index):
        """Called by Qt for each cell."""
        super().initStyleOption(option, index)
        option.textElideMode = QtCore.Qt.ElideMiddle


def _not_written(path, error):
    if isinstance(error, OSError):
        return translate("ThinPart", "The table {} could not be written ({}): choose another place for it.").format(
            path, error.strerror)
    return translated(error)
