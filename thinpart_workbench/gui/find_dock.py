"""The panel that finds parts in libraries."""

from pathlib import Path

from ..core.criteria import load_profile
from ..core.errors import ThinPartError
from ..freecad_adapter.settings import preference
from .active_record import active_record, not_classified
from .flow_layout import FlowLayout
from .found_table import FILE, SCORE, FoundTable
from .found_view import FoundView
from .length_unit import length_unit
from .library_list import LibraryList
from .part_details import PartDetails
from .part_filters import PartFilters
from .part_pictures import PartPictures
from .part_search import PartSearch
from .push_button import add_button
from .qt import QtCore, QtGui, QtWidgets, grouped, translate
from .reclassify_panel import ReclassifyPanel
from .result_view import show_text, text_line
from .sentences import translated
from .unit_watch import UNITS

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_FindParts.svg"

SAME_SIZE = 1.25
"""Factor by which diagonals may differ where only parts of a similar size are wanted."""

_TYPING = 250
"""Milliseconds after the last key until words are looked for."""

_SHARES = (0.27, 0.46, 0.27)
"""Of the room for choices, list and details, until the user divides it otherwise."""

FILTERS, LIBRARIES, RECLASSIFY = range(3)


class FindDock(QtWidgets.QDockWidget):
    """Libraries and filters, what was found, and the details of one part.

    The three lie over each other where the panel is narrow, and beside each other where it is wide.
    """

    def __init__(self, parent):
        super().__init__(translate("ThinPart", "Find parts"), parent)
        self.setObjectName("ThinPart_FindParts")
        self.setWindowIcon(QtGui.QIcon(str(ICON)))
        self._profile = _profile()
        self._wanted, self._arranged = None, None
        self._search = PartSearch(self)
        self._pictures = PartPictures(self)
        form = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(form)
        column.setContentsMargins(4, 4, 4, 4)
        self._add_words(column)
        self._message = text_line(form, column, "ThinPart_FindMessage")
        self._splitter = QtWidgets.QSplitter(QtCore.Qt.Vertical, form)
        column.addWidget(self._splitter, 1)
        self._add_choices()
        self._add_results()
        self._details = PartDetails(self._pictures, self)
        self._splitter.addWidget(self._details)
        for place, stretch in enumerate((1, 2, 1)):
            self._splitter.setStretchFactor(place, stretch)
        self._splitter.setCollapsible(1, False)
        self.setWidget(form)
        self._connect()
        # Before the processes end with FreeCAD, which they do after what they were asked for.
        QtWidgets.QApplication.instance().aboutToQuit.connect(self._details.kept.save)
        self._tell("")

    @property
    def is_waiting(self):
        """Whether a question was asked that is not answered yet."""
        return self._typed.isActive() or self._search.is_waiting

    @property
    def is_refreshing(self):
        """Whether libraries are being read."""
        return self._search.is_refreshing

    def begin(self):
        """Search the libraries, where that does not go on already."""
        self._open()
        self._choices.setCurrentIndex(FILTERS if self._libraries.roots else LIBRARIES)

    def find_like_active(self):
        """Find the parts that are most like the one that is active in the window."""
        try:
            active = active_record()
        except ThinPartError as error:
            self._tell(translated(error))
            return
        if active is None:
            return
        if active.info_file is None:
            self._find_like(active.label, active.shown, None)
        else:
            self._active_when_there = active
            self._search.want_record(active)

    def end(self):
        """Stop everything that goes on, without losing what was written."""
        self._details.kept.save()
        self._typed.stop()
        self._reclassify.end()
        self._search.end()

    def closeEvent(self, event):
        """The panel is hidden: nothing goes on behind it."""
        self.end()
        super().closeEvent(event)

    def showEvent(self, event):
        """The panel is there again."""
        super().showEvent(event)
        self._show_unit()
        if not self._search.is_open:
            self.begin()

    def resizeEvent(self, event):
        """Over or beside each other."""
        super().resizeEvent(event)
        wide = event.size().width() > 1.3 * event.size().height()
        orientation = QtCore.Qt.Horizontal if wide else QtCore.Qt.Vertical
        if orientation != self._arranged:
            self._arranged = orientation
            self._splitter.setOrientation(orientation)
            length = event.size().width() if wide else event.size().height()
            self._splitter.setSizes([round(share * length) for share in _SHARES])

    def _add_words(self, column):
        row = QtWidgets.QHBoxLayout()
        self._words = QtWidgets.QLineEdit(self)
        self._words.setObjectName("ThinPart_FindWords")
        self._words.setPlaceholderText(translate("ThinPart", "Words in names, paths, notes, links"))
        self._words.setClearButtonEnabled(True)
        row.addWidget(self._words, 1)
        self._clear = add_button(
            row, self, "ThinPart_ClearFilters", translate("ThinPart", "Clear filters"), self._clear_filters)
        column.addLayout(row)
        place = QtWidgets.QWidget(self)
        row = FlowLayout(place)
        add_button(
            row, self, "ThinPart_LikeActive", translate("ThinPart", "Parts like the active one"),
            self.find_like_active)
        self._same_size = QtWidgets.QCheckBox(translate("ThinPart", "Similar size"), self)
        self._same_size.setObjectName("ThinPart_SameSize")
        row.addWidget(self._same_size)
        self._all = add_button(
            row, self, "ThinPart_EndLike", translate("ThinPart", "All parts"), self._end_like)
        column.addWidget(place)
        self._typed = QtCore.QTimer(self, singleShot=True, interval=_TYPING)

    def _add_choices(self):
        self._choices = QtWidgets.QTabWidget(self)
        self._choices.setObjectName("ThinPart_FindChoices")
        self._filters = PartFilters(self._profile, self)
        self._libraries = LibraryList(self)
        self._reclassify = ReclassifyPanel(preference("Profile"), self)
        for page, title in ((self._filters, translate("ThinPart", "Filters")),
                            (self._libraries, translate("ThinPart", "Libraries")),
                            (self._reclassify, translate("ThinPart", "Reclassify"))):
            area = QtWidgets.QScrollArea(self)
            area.setWidgetResizable(True)
            area.setFrameShape(QtWidgets.QFrame.NoFrame)
            area.setWidget(page)
            self._choices.addTab(area, title)
        self._splitter.addWidget(self._choices)

    def _add_results(self):
        place = QtWidgets.QWidget(self)
        column = QtWidgets.QVBoxLayout(place)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2)
        self._table = FoundTable(self._profile, self._pictures, self)
        self._view = FoundView(self._table, self)
        column.addWidget(self._view, 1)
        self._status = text_line(place, column, "ThinPart_FindStatus")
        self._splitter.addWidget(place)

    def _connect(self):
        search, view = self._search, self._view
        search.found.connect(self._show_found)
        search.rows_came.connect(self._table.take_rows)
        search.libraries_changed.connect(self._show_libraries)
        search.progressed.connect(self._libraries.show_progress)
        search.record_came.connect(self._take_record)
        search.kept.connect(self._take_kept)
        search.failed.connect(self._show_failed)
        self._words.textChanged.connect(lambda _: self._typed.start())
        self._typed.timeout.connect(self._ask)
        self._filters.changed.connect(self._ask)
        self._same_size.toggled.connect(lambda _: self._ask())
        self._libraries.changed.connect(self._open)
        self._libraries.refresh_asked.connect(self._refresh)
        self._libraries.stop_asked.connect(search.stop_refreshing)
        self._reclassify.written.connect(self._refresh)
        self._table.rows_wanted.connect(search.want_rows)
        self._table.sort_asked.connect(lambda key, descending: search.ask(sort=key, descending=descending))
        view.current_changed.connect(self._show_part)
        view.told.connect(self._tell)
        view.notes_asked.connect(lambda _: self._details.edit_notes())
        view.similar_asked.connect(self._find_like_part)
        self._details.kept.keep_asked.connect(search.keep)
        self._details.kept.told.connect(self._tell)
        UNITS.changed.connect(self._show_unit)
        self._show_like()

    def _open(self):
        roots = self._libraries.roots
        self._search.open(roots)
        self._reclassify.set_roots(roots)

    def _refresh(self):
        self._tell("")
        self._pictures.forget()
        self._search.refresh()

    def _ask(self):
        query = self._filters.query()
        if self._words.text().strip():
            query["words"] = self._words.text().strip()
        like = None
        if self._wanted is not None:
            like = {**self._wanted["like"], "same_size": SAME_SIZE if self._same_size.isChecked() else None}
        self._search.ask(query=query, like=like)

    def _clear_filters(self):
        self._words.clear()
        self._typed.stop()
        self._filters.clear()

    def _find_like_part(self, part):
        self._like_when_there = part.info_file, part.name
        self._search.want_record(part)

    _like_when_there = None
    _active_when_there = None

    def _find_like(self, name, record, info_file):
        self._wanted = {"name": name, "record": record, "like": {
            "record": record, "excluding": [info_file, record["name"]] if info_file else None}}
        self._details.compare_with(name, record)
        self._show_like()
        self._search.ask(sort="score", descending=False)
        self._view.show_sorted_by(SCORE, False)
        self._ask()

    def _end_like(self):
        self._wanted = None
        self._details.compare_with("", None)
        self._show_like()
        self._search.ask(sort="file", descending=False)
        self._view.show_sorted_by(FILE, False)
        self._ask()

    def _show_unit(self):
        """Lengths are written in the unit of the active document: parts of a library have none of their own."""
        unit = length_unit()
        self._filters.show_unit(unit)
        self._table.show_unit(unit)
        self._details.show_unit()

    def _show_like(self):
        self._same_size.setVisible(self._wanted is not None)
        self._all.setVisible(self._wanted is not None)

    def _show_found(self, found):
        self._filters.show_found(found)
        self._view.show_found(found, self._search.like is not None)
        if self._wanted is not None:
            text = translate("ThinPart", "The {} parts most like {}, among {} of {}").format(
                grouped(found["count"]), self._wanted["name"], grouped(found["matching"]),
                grouped(found["total"]))
        else:
            text = translate("ThinPart", "{} of {} parts").format(
                grouped(found["count"]), grouped(found["total"]))
        if not self._libraries.roots:
            text = translate("ThinPart", "Add a folder with classified parts under 'Libraries'.")
        show_text(self._status, text)

    def _show_part(self, part):
        shown = self._details.part
        self._search.stay_with(part)
        if part is not None and shown is not None and (
                (part.info_file, part.name) == (shown.info_file, shown.name)):
            return  # the list has changed around it
        self._details.show_part(part)
        if part is not None and not part.error_kind:
            self._search.want_record(part)

    def _take_record(self, told):
        key = told["info_file"], told["name"]
        if self._like_when_there == key:
            self._like_when_there = None
            if "record" in told:
                self._find_like(told["record"]["label"], told["record"], told["info_file"])
            else:
                self._tell(translated(told["sentence"]))
        active = self._active_when_there
        if active is not None and key == (active.info_file, active.name):
            self._active_when_there = None
            self._take_active(active, told)
        self._details.show_record(told)

    def _take_active(self, active, told):
        self._tell("")
        if "record" in told:
            self._find_like(active.label, told["record"], active.info_file)
        elif active.shown is not None:
            self._find_like(active.label, active.shown, None)  # not stored
        else:
            self._tell(not_classified(active))

    def _take_kept(self, kept):
        self._details.kept.show_kept(kept)

    def _show_libraries(self, libraries):
        self._libraries.show_libraries(libraries)
        self._choices.setTabText(LIBRARIES, translate("ThinPart", "Libraries") + (
            " \u26a0" if any(each["problems"] for each in libraries) else ""))
        problems = [sentence for each in libraries for sentence in each["problems"]]
        if problems and self._choices.currentIndex() != LIBRARIES:
            self._tell(translated(problems[0]))

    def _show_failed(self, sentence):
        self._libraries.show_failed(sentence)
        self._tell(sentence)

    def _tell(self, sentence):
        show_text(self._message, sentence)


def _profile():
    try:
        return load_profile(preference("Profile"))
    except ThinPartError:
        return load_profile("paper")  # what is wrong with it is said when it is to be used
