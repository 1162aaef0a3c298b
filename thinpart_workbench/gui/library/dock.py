# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that finds parts in libraries."""

from types import SimpleNamespace

from ...api.window.profiles import profile_for_titles
from ...core.errors import ThinPartError
from ...freecad_adapter.preferences import preference
from ...system.file_paths import is_below
from ..application import lifelong
from ..application.icons import icon
from ..application.length_unit import length_unit
from ..application.qt import QtCore, QtWidgets, grouped, translate
from ..application.sentences import translated
from ..guide.command import help_button
from ..processes.request_queue import LABEL
from ..reclassify.reclassify_page import ReclassifyPage
from ..record.kept_room import keep_room
from ..record.label_button import LabelButton
from ..record.record_view import show_text, text_line
from ..record.thumbnails import Thumbnails
from ..report.library_dialog import show_library_report
from ..widgets.buttons import add_button
from ..widgets.flow_layout import add_flow
from ..widgets.folder_field import contains
from .active_record import active_record, not_classified
from .details import PartDetails, scrolled
from .duplicates_page import DuplicatesPage
from .filters_page import FiltersPage
from .found_rows import FoundRows
from .judged_otherwise_note import JudgedOtherwiseNote
from .libraries_page import LibrariesPage
from .results_view import FoundPartsView
from .search_client import SearchClient

SAME_SIZE = 1.25
"""Maximum ratio of diagonals for parts of similar size."""

_TYPING_DELAY = 250
"""Milliseconds after the last key press before the search starts."""

_SHARES = (0.27, 0.46, 0.27)
"""Initial shares of the splitter: filters, list, details."""

_SHARES_OF_DUPLICATES = (0.66, 0.0, 0.34)
"""The same where duplicates take the place of the list."""

FILTERS, LIBRARIES, RECLASSIFY, DUPLICATES = range(4)


class FindDock(QtWidgets.QDockWidget):
    """Libraries and filters, the found parts, and the details of one part.

    The three are stacked in a narrow dock, and side by side in a wide one.
    """

    def __init__(self, parent):
        super().__init__(translate("ThinPart", "Find parts"), parent)
        self.setObjectName("ThinPart_FindParts")
        self.setWindowIcon(icon("ThinPart_FindParts"))
        self._profile = profile_for_titles()
        self._reference, self._orientation = None, None
        self._pending_like = self._pending_active = None  # of which the record is to come
        self._search = SearchClient(self)
        self._pictures = Thumbnails(self)
        form = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(4, 4, 4, 4)
        self._add_words(column)
        self._splitter = QtWidgets.QSplitter(QtCore.Qt.Vertical, form)
        column.addWidget(self._splitter, 1)
        # Below all that is pressed, and with a line kept free for it: what is said moves nothing.
        self._message = text_line(form, column, "ThinPart_FindMessage")
        keep_room(self._message)
        self._judged_otherwise = JudgedOtherwiseNote(form)
        column.addWidget(self._judged_otherwise)
        self._add_choices()
        self._add_results()
        self._details = PartDetails(self._pictures, self)
        self._splitter.addWidget(self._details)
        for index, stretch in enumerate((1, 2, 1)):
            self._splitter.setStretchFactor(index, stretch)
        self._splitter.setCollapsible(1, False)
        self.setWidget(form)
        self._connect()
        # Before the worker processes end with FreeCAD; they still complete pending requests.
        QtWidgets.QApplication.instance().aboutToQuit.connect(self._details.notes.save)
        self._show_message("")

    @property
    def is_waiting(self):
        """Whether a request is pending."""
        return self._typing_timer.isActive() or self._label_timer.isActive() or self._search.is_waiting

    @property
    def is_refreshing(self):
        """Whether libraries are being refreshed."""
        return self._search.is_refreshing

    def begin(self):
        """Open the libraries for searching."""
        self._open()
        self._choices.setCurrentIndex(FILTERS if self._libraries.roots else LIBRARIES)

    def find_like_active(self):
        """Find the parts most similar to the active part."""
        self._show_message("")
        try:
            active = active_record()
        except ThinPartError as error:
            self._show_message(translated(error))
            return
        if active is None:
            return
        if active.info_file is None:
            self._find_like(active.label, active.shown, None)
        else:
            self._pending_active = active
            self._search.request_record(active)

    def show_part(self, info_file, name):
        """Clear the filters and select a part of one of the libraries, by its info file and name."""
        self._clear_filters()
        if self._reference is not None:
            self._end_like()
        self._choices.setCurrentIndex(FILTERS)
        root = next((root for root in self._libraries.roots if contains(root, info_file)), "")
        self._search.find_again(SimpleNamespace(root=root, info_file=info_file, name=name))

    def search_in(self, folder):
        """Make a folder, str, one of the libraries, unless it is in one, and show all parts of the libraries."""
        self._libraries.add(folder)
        self._clear_filters()
        if self._reference is not None:
            self._end_like()
        self._choices.setCurrentIndex(FILTERS)

    def show_reclassify(self, profile_name):
        """Show the page that reclassifies the libraries, with a profile chosen."""
        self._choices.setCurrentIndex(RECLASSIFY)
        self._reclassify.choose(profile_name)

    def end(self):
        """Stop all work, after saving the notes."""
        self._details.notes.save()
        self._typing_timer.stop()
        self._label_timer.stop()
        self._reclassify.end()
        self._duplicates.end()
        self._search.end()
        self._show_job("libraries", False)

    def closeEvent(self, event):
        """Stop all work when the dock is closed."""
        self.end()
        super().closeEvent(event)

    def showEvent(self, event):
        """Open the libraries when the dock is shown."""
        super().showEvent(event)
        self._show_unit()
        if not self._search.is_open:
            self.begin()

    def resizeEvent(self, event):
        """Choose the orientation of the splitter by the shape of the dock."""
        super().resizeEvent(event)
        wide = event.size().width() > 1.3 * event.size().height()
        orientation = QtCore.Qt.Horizontal if wide else QtCore.Qt.Vertical
        if orientation != self._orientation:
            self._orientation = orientation
            self._splitter.setOrientation(orientation)
            self._splitter.setSizes(self._shares([event.size().width() if wide else event.size().height()]))

    def _shares(self, sizes):
        """Sizes of the splitter's widgets, pixels, that have the same sum as some."""
        shares = _SHARES_OF_DUPLICATES if self._results.isHidden() else _SHARES
        return [round(share * sum(sizes)) for share in shares]

    def _add_words(self, column):
        row = QtWidgets.QHBoxLayout()
        self._words = QtWidgets.QLineEdit(self)
        self._words.setObjectName("ThinPart_FindWords")
        self._words.setPlaceholderText(translate("ThinPart", "Words in names, paths, notes, links"))
        self._words.setClearButtonEnabled(True)
        row.addWidget(self._words, 1)
        add_button(row, self, "ThinPart_ClearFilters", translate("ThinPart", "Clear filters"), self._clear_filters)
        column.addLayout(row)
        row = add_flow(column, self)
        add_button(row, self, "ThinPart_LikeActive", translate("ThinPart", "Parts like the active one"),
                   self.find_like_active)
        self._same_size = QtWidgets.QCheckBox(translate("ThinPart", "Similar size"), self)
        self._same_size.setObjectName("ThinPart_SameSize")
        row.addWidget(self._same_size)
        self._all = add_button(
            row, self, "ThinPart_EndLike", translate("ThinPart", "All parts"), self._end_like)
        row.addWidget(help_button(self, "ThinPart_FindParts"))
        self._typing_timer = QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)

    def _add_choices(self):
        self._choices = QtWidgets.QTabWidget(self)
        self._choices.setObjectName("ThinPart_FindChoices")
        self._filters = FiltersPage(self._profile, self)
        self._libraries = LibrariesPage(self)
        self._reclassify = ReclassifyPage(preference("Profile"), self)
        self._duplicates = DuplicatesPage(self._pictures, self)
        for page, title in ((self._filters, translate("ThinPart", "Filters")),
                            (self._libraries, translate("ThinPart", "Libraries")),
                            (self._reclassify, translate("ThinPart", "Reclassify")),
                            (self._duplicates, translate("ThinPart", "Duplicates"))):
            self._choices.addTab(scrolled(page), title)
        self._splitter.addWidget(self._choices)

    def _add_results(self):
        container = self._results = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(container)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._table = FoundRows(self._profile, self._pictures, self)
        self._view = FoundPartsView(self._table, self)
        column.addWidget(self._view, 1)
        row = QtWidgets.QHBoxLayout()
        self._status = text_line(container, row, "ThinPart_FindStatus")
        row.setStretch(0, 1)
        self._label_button = LabelButton(container)
        self._label_button.setObjectName("ThinPart_FoundLabel")
        self._label_button.label_chosen.connect(self._label_selected)
        row.addWidget(self._label_button)
        column.addLayout(row)
        self._labelled, self._label_timer = set(), QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)
        self._label_timer.timeout.connect(self._refresh_labelled)
        self._view.selectionModel().selectionChanged.connect(lambda *_: self._show_label_button())
        self._show_label_button()
        self._splitter.addWidget(container)

    def _connect(self):
        search, view = self._search, self._view
        search.found.connect(self._show_result)
        search.rows_received.connect(self._table.set_rows)
        search.libraries_changed.connect(self._show_libraries)
        search.progressed.connect(self._libraries.show_progress)
        search.progressed.connect(lambda _: self._show_job("libraries", True))
        search.libraries_changed.connect(lambda _: self._show_job("libraries", search.is_refreshing))
        search.failed.connect(lambda _: self._show_job("libraries", False))
        search.record_received.connect(self._on_record_received)
        search.annotation_saved.connect(self._details.notes.show_save_result)
        search.failed.connect(self._show_failed)
        self._words.textChanged.connect(lambda _: self._typing_timer.start())
        self._typing_timer.timeout.connect(self._search_anew)
        self._filters.changed.connect(self._search_anew)
        self._same_size.toggled.connect(lambda _: self._search_anew())
        self._libraries.changed.connect(self._open)
        self._judged_otherwise.reclassify_requested.connect(self.show_reclassify)
        self._libraries.refresh_requested.connect(self._refresh)
        self._libraries.stop_requested.connect(search.stop_refreshing)
        self._libraries.report_requested.connect(show_library_report)
        self._reclassify.written.connect(self._refresh)
        self._reclassify.writing_changed.connect(lambda is_writing: self._show_job("reclassify", is_writing))
        self._reclassify.view.find_requested.connect(self.show_part)
        self._table.rows_requested.connect(search.request_rows)
        self._table.sort_requested.connect(lambda key, descending: search.update_query(sort=key, descending=descending))
        view.current_changed.connect(self._show_part)
        view.message.connect(self._show_message)
        view.failed.connect(self._show_message)
        view.notes_requested.connect(lambda _: self._details.edit_notes())
        view.similar_requested.connect(self._find_like_part)
        self._details.notes.save_requested.connect(search.save_annotation)
        self._details.notes.message.connect(self._show_message)
        self._details.labelled.connect(self._label)
        lifelong.requests.answered.connect(self._on_label_kept)
        lifelong.measurement_signals.begun.connect(self._forget_message)
        lifelong.units.changed.connect(self._show_unit)
        self._duplicates.running_changed.connect(lambda is_running: self._show_job("duplicates", is_running))
        self._duplicates.view.current_changed.connect(self._show_duplicate)
        self._choices.currentChanged.connect(self._on_page_chosen)
        self._show_like()

    def _open(self):
        roots = self._libraries.roots
        self._search.open(roots)
        self._reclassify.set_roots(roots)
        self._duplicates.set_roots(roots)

    def _show_job(self, name, is_running):
        """Name what runs in the background in FreeCAD's status bar, with a click to this panel."""
        if not is_running:
            lifelong.running_jobs.end(name)
            return
        text, page = {
            "libraries": (translate("ThinPart", "Refreshing the libraries"), LIBRARIES),
            "reclassify": (translate("ThinPart", "Classifying again by another profile"), RECLASSIFY),
            "duplicates": (translate("ThinPart", "Searching for duplicates"), DUPLICATES)}[name]
        lifelong.running_jobs.show(name, text, self, lambda: self._choices.setCurrentIndex(page))

    def _on_page_chosen(self, page):
        """Leave the place of the found parts to the table of duplicates, and the details to what is selected."""
        is_duplicates = page == DUPLICATES
        if is_duplicates != self._results.isHidden():
            self._results.setHidden(is_duplicates)
            self._splitter.setSizes(self._shares(self._splitter.sizes()))
        part = (self._duplicates.view if is_duplicates else self._view).current_part
        if part is not None:
            self._show_details(part)

    def _refresh(self):
        self._show_message("")
        self._pictures.clear()
        self._search.refresh()

    def _search_anew(self):
        """Search by other words or filters: what was said before is not about what is found now."""
        self._show_message("")
        self._start_search()

    def _forget_message(self, _document):
        """What has not been classified is now."""
        self._show_message("")

    def _start_search(self):
        query = self._filters.query()
        if self._words.text().strip():
            query["words"] = self._words.text().strip()
        like = None
        if self._reference is not None:
            like = {**self._reference["like"], "same_size": SAME_SIZE if self._same_size.isChecked() else None}
        self._search.update_query(query=query, like=like)

    def _clear_filters(self):
        self._words.clear()
        self._typing_timer.stop()
        self._filters.clear()

    def _find_like_part(self, part):
        self._pending_like = part.info_file, part.name
        self._search.request_record(part)

    def _find_like(self, name, record, info_file):
        self._show_message("")
        self._reference = {"name": name, "record": record, "like": {
            "record": record, "excluding": [info_file, record["name"]] if info_file else None}}
        self._details.compare_with(name, record)
        self._show_like()
        self._search.update_query(sort="score", descending=False)
        self._view.show_sorted_by("score", False)
        self._start_search()

    def _end_like(self):
        self._reference = None
        self._details.compare_with("", None)
        self._show_like()
        self._search.update_query(sort="file", descending=False)
        self._view.show_sorted_by("file", False)
        self._start_search()

    def _show_unit(self):
        """Show lengths in the unit of the active document; parts of a library have no unit of their own."""
        unit = length_unit()
        self._filters.show_unit(unit)
        self._table.show_unit(unit)
        self._details.show_unit()
        self._duplicates.show_unit(unit)

    def _show_like(self):
        self._same_size.setVisible(self._reference is not None)
        self._all.setVisible(self._reference is not None)

    def _show_result(self, result):
        self._filters.show_result(result)
        self._view.show_result(result, self._search.like is not None)
        if self._reference is not None:
            text = translate("ThinPart", "The {} parts most like {}, among {} of {}").format(
                grouped(result["count"]), self._reference["name"], grouped(result["matching"]),
                grouped(result["total"]))
        else:
            text = translate("ThinPart", "{} of {} parts").format(
                grouped(result["count"]), grouped(result["total"]))
        if not self._libraries.roots:
            text = translate("ThinPart", "Add a folder with classified parts under 'Libraries'.")
        show_text(self._status, text)

    def _show_part(self, part):
        self._search.set_current_part(part)
        self._show_details(part)

    def _show_duplicate(self, part):
        if part is not None:
            self._show_details(part)

    def _show_details(self, part):
        shown = self._details.part
        if part is not None and shown is not None and (
                (part.info_file, part.name) == (shown.info_file, shown.name)):
            return  # the list has changed, but not the selected part
        self._details.show_part(part)
        if part is not None and not part.error_kind:
            self._search.request_record(part)

    def _on_record_received(self, response):
        key = response["info_file"], response["name"]
        if self._pending_like == key:
            self._pending_like = None
            if "record" in response:
                self._find_like(response["record"]["label"], response["record"], response["info_file"])
            else:
                self._show_message(translated(response["sentence"]))
        active = self._pending_active
        if active is not None and key == (active.info_file, active.name):
            self._pending_active = None
            self._on_active_record(active, response)
        self._details.show_record(response)

    def _on_active_record(self, active, response):
        self._show_message("")
        if "record" in response:
            self._find_like(active.label, response["record"], active.info_file)
        elif active.shown is not None:
            self._find_like(active.label, active.shown, None)  # the record is not stored
        else:
            self._show_message(not_classified(active))

    def _label(self, part, category, is_sure):
        lifelong.requests.keep(LABEL, path=part.info_file, part=part.name, category=category, is_sure=is_sure)

    def _on_label_kept(self, request):
        if request.function == LABEL:
            self._details.show_kept_label(request)
            if request.sentence:
                self._show_message("\u26a0 " + request.sentence)
            else:
                self._labelled.add(request.arguments["path"])
                self._label_timer.start()  # once for all parts that got a label together

    def _refresh_labelled(self):
        """Read again the libraries in which parts got labels."""
        labelled, self._labelled = self._labelled, set()
        roots = [root for root in self._libraries.roots if any(is_below(path, root) for path in labelled)]
        if self._search.is_open and roots:
            self._search.refresh(roots)

    def _labelled_parts(self):
        """The selected parts, without failures."""
        return [part for part in self._view.selected_rows if not part.error_kind]

    def _show_label_button(self):
        count = len(self._labelled_parts())
        self._label_button.setEnabled(count > 0)
        self._label_button.show_labels((), self._profile, count)

    def _label_selected(self, category, is_sure):
        for part in self._labelled_parts():
            self._label(part, category, is_sure)

    def _show_libraries(self, libraries):
        self._libraries.show_libraries(libraries)
        sizes = self._splitter.sizes()
        self._judged_otherwise.show_libraries(libraries)
        QtCore.QTimer.singleShot(0, lambda: self._keep_sizes(sizes))
        self._choices.setTabText(LIBRARIES, translate("ThinPart", "Libraries") + (
            " \u26a0" if any(library["problems"] for library in libraries) else ""))
        problems = [problem for library in libraries for problem in library["problems"]]
        if problems and self._choices.currentIndex() != LIBRARIES:
            self._show_message(translated(problems[0]))

    def _keep_sizes(self, sizes):
        """Have only the details give way to the note below them; what is pressed above stays where it is."""
        room = sum(self._splitter.sizes())
        if room != sum(sizes) and room > sum(sizes[:2]):
            self._splitter.setSizes([*sizes[:2], room - sum(sizes[:2])])

    def _show_failed(self, sentence):
        self._libraries.show_failed(sentence)
        self._show_message(sentence)

    def _show_message(self, sentence):
        show_text(self._message, sentence)
