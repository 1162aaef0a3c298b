"""Table model of the found parts; fetches only the rows that the view displays."""

import os
from collections import OrderedDict
from dataclasses import dataclass

from ...core.errors import KINDS
from ...core.length_unit import MILLIMETRE
from ..application.qt import QtCore, QtGui, Signal, colour, flags_as_int, translate
from ..application.sentences import translated, translated_list
from ..record.category_marks import FAILED_COLOUR, colour_square
from ..record.verdict_text import category_colour, category_title
from .thumbnails import neutral_picture

PAGE = 100
"""Number of rows per request."""

MAX_PAGES = 40
WAITING = "\u2026"


@dataclass(frozen=True)
class FoundColumn:
    """A column of the table.

    Attributes
    ----------
    title : str
    sort : str or None
        Sort key of the search; None if it cannot sort by this column.
    text : callable
        Returns the text of a part.
    is_number : bool
        Whether it is right-aligned.
    """

    title: str
    sort: object
    text: object
    is_number: bool = False


SCORE, PART, CATEGORY, REASONS, THINNEST, SIZE, FILE = range(7)


class FoundPartsModel(QtCore.QAbstractTableModel):
    """Table model of the found parts.

    Parameters
    ----------
    profile : Profile
        Provides the titles of the categories.
    pictures : Thumbnails

    Signals
    -------
    rows_requested(int, int)
        The view needs the rows from the first number up to, excluding, the second.
    sort_requested(str, bool)
        Sort key, and whether the order is descending.
    """

    rows_requested = Signal(int, int)
    sort_requested = Signal(str, bool)

    def __init__(self, profile, pictures, parent=None):
        super().__init__(parent)
        self._profile, self._pictures, self._unit = profile, pictures, MILLIMETRE
        self._count, self._pages, self._requested = 0, OrderedDict(), set()
        self._neutral = {}
        self.picture_size, self.screen_ratio = QtCore.QSize(48, 36), 1.0
        self._columns = self._new_columns()
        pictures.loaded.connect(self._show_pictures)

    def show_unit(self, unit):
        """Show lengths in a LengthUnit."""
        if unit != self._unit:
            self._unit = unit
            self._columns = self._new_columns()
            self.headerDataChanged.emit(QtCore.Qt.Horizontal, 0, len(self._columns) - 1)
            if self._count:
                self.dataChanged.emit(self.index(0, 0), self.index(self._count - 1, len(self._columns) - 1))

    def _new_columns(self):
        return (
            FoundColumn(translate("ThinPart", "Like"), "score", _score, True),
            FoundColumn(translate("ThinPart", "Part"), "label", _part),
            FoundColumn(translate("ThinPart", "Category"), "category", self._category_text),
            FoundColumn(translate("ThinPart", "Why"), None,
                        lambda part: translated_list(getattr(part, "reasons", ""))),
            FoundColumn(translate("ThinPart", "Thinnest, {}").format(self._unit.symbol), "thinnest_mm",
                        lambda part: self._length(part, part.thinnest_mm), True),
            FoundColumn(translate("ThinPart", "Longest, {}").format(self._unit.symbol), "d1_mm",
                        lambda part: self._length(part, part.d1_mm), True),
            FoundColumn(translate("ThinPart", "File"), "file", lambda part: part.place),
        )

    def show_result(self, count, rows):
        """Replace the content by a search result.

        Parameters
        ----------
        count : int
        rows : list
            The first rows; None for deleted parts.
        """
        self.beginResetModel()
        self._count = count
        self._pages.clear()
        self._requested.clear()
        self.endResetModel()
        self.set_rows(0, rows)

    def set_rows(self, start, rows):
        """Store requested rows, beginning with row number `start`."""
        for offset in range(0, len(rows), PAGE):
            page = (start + offset) // PAGE
            self._pages[page] = rows[offset:offset + PAGE]
            self._requested.discard(page)
        while len(self._pages) > MAX_PAGES:
            self._pages.popitem(last=False)
        if rows:
            self.dataChanged.emit(self.index(start, 0),
                                  self.index(start + len(rows) - 1, len(self._columns) - 1))

    def part_at(self, row):
        """The part in a row; None if not fetched, or deleted."""
        page = self._pages.get(row // PAGE)
        if page is None:
            return None
        self._pages.move_to_end(row // PAGE)
        return page[row % PAGE] if row % PAGE < len(page) else None

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of found parts."""
        return 0 if parent.isValid() else self._count

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self._columns)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        """Titles of the columns, aligned like their cells."""
        if orientation != QtCore.Qt.Horizontal:
            return None
        if role == QtCore.Qt.DisplayRole:
            return self._columns[section].title
        return _alignment(self._columns[section]) if role == QtCore.Qt.TextAlignmentRole else None

    def flags(self, index):
        """Allow dragging of rows."""
        return super().flags(index) | QtCore.Qt.ItemIsDragEnabled

    def mimeTypes(self):
        """MIME type of files, as used by file managers."""
        return ["text/uri-list"]

    def mimeData(self, indexes):
        """URLs of the documents of the dragged parts, without duplicates."""
        parts = [self.part_at(row) for row in sorted({index.row() for index in indexes})]
        files = dict.fromkeys(part.file for part in parts if part is not None)
        data = QtCore.QMimeData()
        data.setUrls([QtCore.QUrl.fromLocalFile(file) for file in files])
        return data

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Request sorting by a column."""
        key = self._columns[column].sort if column >= 0 else "file"
        if key is not None:
            self.sort_requested.emit(key, order == QtCore.Qt.DescendingOrder)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """Data of a cell for a role; requests the row if it is not fetched."""
        if not index.isValid():
            return None
        column = self._columns[index.column()]
        if role == QtCore.Qt.TextAlignmentRole:
            return _alignment(column)
        if role not in (QtCore.Qt.DisplayRole, QtCore.Qt.DecorationRole, QtCore.Qt.ForegroundRole,
                        QtCore.Qt.ToolTipRole):
            return None
        part = self.part_at(index.row())
        if part is None:
            return self._missing(index, role)
        if role == QtCore.Qt.DisplayRole:
            return column.text(part)
        if role == QtCore.Qt.DecorationRole:
            return self._decoration(index.column(), part)
        if role == QtCore.Qt.ForegroundRole:
            return QtGui.QBrush(colour(FAILED_COLOUR)) if part.error_kind else None
        if index.column() == REASONS:
            return column.text(part)
        return translated(part.error_message or "") or "\n".join(filter(None, (part.file, part.notes)))

    def _missing(self, index, role):
        page = index.row() // PAGE
        if page not in self._pages and page not in self._requested:
            self._requested.add(page)
            self.rows_requested.emit(page * PAGE, min((page + 1) * PAGE, self._count))
        return WAITING if role == QtCore.Qt.DisplayRole and index.column() == PART else None

    def _decoration(self, column, part):
        if column == CATEGORY and not part.error_kind:
            # Qt would draw a plain colour as large as the thumbnails.
            return colour_square(category_colour(part.category))
        if column != PART:
            return None
        picture = self._pictures.picture(part)
        if picture is not None:
            return self._scaled(picture)
        key = part.category, bool(part.error_kind), self.screen_ratio, self.picture_size.height()
        if key not in self._neutral:
            self._neutral[key] = neutral_picture(part, self.picture_size, self.screen_ratio)
        return self._neutral[key]

    def _scaled(self, picture):
        scaled = picture.scaled(self.picture_size * self.screen_ratio, QtCore.Qt.KeepAspectRatio,
                                QtCore.Qt.SmoothTransformation)
        scaled.setDevicePixelRatio(self.screen_ratio)
        return scaled

    def _show_pictures(self):
        if self._count:
            self.dataChanged.emit(self.index(0, PART), self.index(self._count - 1, PART),
                                  [QtCore.Qt.DecorationRole])

    def _length(self, part, millimetres):
        return "" if part.error_kind else self._unit.number(millimetres)

    def _category_text(self, part):
        if part.error_kind:
            return "\u2717 " + translate("ThinPart", "Failed: {}").format(
                translated(KINDS.get(part.error_kind, part.error_kind)))
        title = category_title(part.category, self._profile)
        return translate("ThinPart", "{} (unsure)").format(title) if part.borderline else title


def part_name(part):
    """Display name of a part."""
    return part.label or part.name or os.path.basename(part.file)


def _part(part):
    return part_name(part) + (f" \u00d7 {part.instances}" if (part.instances or 1) > 1 else "")


def _score(part):
    return f"{part.score:.0f}\u00a0%" if hasattr(part, "score") else ""


def _alignment(column):
    side = QtCore.Qt.AlignRight if column.is_number else QtCore.Qt.AlignLeft
    return flags_as_int(side | QtCore.Qt.AlignVCenter)
