"""The table of parts that were found, of which only the rows that are seen are fetched."""

import os
from collections import OrderedDict
from dataclasses import dataclass

from ..core.errors import KINDS
from .length_unit import MILLIMETRE
from .part_pictures import neutral_picture
from .qt import QtCore, QtGui, Signal, colour, number_of, translate
from .result_filter import colour_square
from .result_table import FAILED_COLOUR
from .sentences import translated, translated_list
from .verdict_text import category_colour, category_title

PAGE = 100
"""Rows that are fetched together."""

MOST_PAGES = 40
WAITING = "\u2026"


@dataclass(frozen=True)
class FoundColumn:
    """A column.

    Attributes
    ----------
    title : str
    sort : str or None
        What the search calls it when it sorts by it; None where it does not.
    text : callable
        From a part to what is shown.
    is_number : bool
        Whether it stands on the right.
    """

    title: str
    sort: object
    text: object
    is_number: bool = False


SCORE, PART, CATEGORY, REASONS, THINNEST, SIZE, FILE = range(7)


class FoundTable(QtCore.QAbstractTableModel):
    """Parts that were found.

    Parameters
    ----------
    profile : Profile
        Has the words for categories.
    pictures : PartPictures

    Signals
    -------
    rows_wanted(int, int)
        Rows from the first to the second, which is excluded, are to be seen.
    sort_asked(str, bool)
        What to sort by, and whether the largest comes first.
    """

    rows_wanted = Signal(int, int)
    sort_asked = Signal(str, bool)

    def __init__(self, profile, pictures, parent=None):
        super().__init__(parent)
        self._profile, self._pictures, self._unit = profile, pictures, MILLIMETRE
        self._count, self._pages, self._asked = 0, OrderedDict(), set()
        self._neutral = {}
        self.picture_size, self.screen_ratio = QtCore.QSize(48, 36), 1.0
        self._columns = self._new_columns()
        pictures.came.connect(self._show_pictures)

    def show_unit(self, unit):
        """Write lengths in a LengthUnit from now on."""
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

    def show_found(self, count, rows):
        """Show what was found.

        Parameters
        ----------
        count : int
        rows : list
            The first ones, None for parts that have gone.
        """
        self.beginResetModel()
        self._count = count
        self._pages.clear()
        self._asked.clear()
        self.endResetModel()
        self.take_rows(0, rows)

    def take_rows(self, start, rows):
        """Rows that were asked for."""
        for place in range(0, len(rows), PAGE):
            page = (start + place) // PAGE
            self._pages[page] = rows[place:place + PAGE]
            self._asked.discard(page)
        while len(self._pages) > MOST_PAGES:
            self._pages.popitem(last=False)
        if rows:
            self.dataChanged.emit(self.index(start, 0),
                                  self.index(start + len(rows) - 1, len(self._columns) - 1))

    def part_at(self, row):
        """The part in a row; None where it is not here, or gone."""
        page = self._pages.get(row // PAGE)
        if page is None:
            return None
        self._pages.move_to_end(row // PAGE)
        return page[row % PAGE] if row % PAGE < len(page) else None

    def rowCount(self, parent=QtCore.QModelIndex()):
        """Number of parts that were found."""
        return 0 if parent.isValid() else self._count

    def columnCount(self, parent=QtCore.QModelIndex()):
        """Number of columns."""
        return 0 if parent.isValid() else len(self._columns)

    def headerData(self, section, orientation, role=QtCore.Qt.DisplayRole):
        """Titles of the columns, on the side on which their cells stand."""
        if orientation != QtCore.Qt.Horizontal:
            return None
        if role == QtCore.Qt.DisplayRole:
            return self._columns[section].title
        return _alignment(self._columns[section]) if role == QtCore.Qt.TextAlignmentRole else None

    def flags(self, index):
        """Rows can be chosen and dragged."""
        return super().flags(index) | QtCore.Qt.ItemIsDragEnabled

    def mimeTypes(self):
        """Files, as a file manager would give them."""
        return ["text/uri-list"]

    def mimeData(self, indexes):
        """The documents of the chosen parts, each once."""
        parts = [self.part_at(row) for row in sorted({index.row() for index in indexes})]
        files = dict.fromkeys(part.file for part in parts if part is not None)
        data = QtCore.QMimeData()
        data.setUrls([QtCore.QUrl.fromLocalFile(each) for each in files])
        return data

    def sort(self, column, order=QtCore.Qt.AscendingOrder):
        """Have the search sort by a column."""
        key = self._columns[column].sort if column >= 0 else "file"
        if key is not None:
            self.sort_asked.emit(key, order == QtCore.Qt.DescendingOrder)

    def data(self, index, role=QtCore.Qt.DisplayRole):
        """One cell; where the row is not here it is asked for."""
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
        if page not in self._pages and page not in self._asked:
            self._asked.add(page)
            self.rows_wanted.emit(page * PAGE, min((page + 1) * PAGE, self._count))
        return WAITING if role == QtCore.Qt.DisplayRole and index.column() == PART else None

    def _decoration(self, column, part):
        if column == CATEGORY and not part.error_kind:
            # A bare colour would be drawn as large as the pictures of parts.
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
        return translate("ThinPart", "{} (borderline)").format(title) if part.borderline else title


def part_name(part):
    """What a part is called."""
    return part.label or part.name or os.path.basename(part.file)


def _part(part):
    return part_name(part) + (f" \u00d7 {part.instances}" if (part.instances or 1) > 1 else "")


def _score(part):
    return f"{part.score:.0f}\u00a0%" if hasattr(part, "score") else ""


def _alignment(column):
    side = QtCore.Qt.AlignRight if column.is_number else QtCore.Qt.AlignLeft
    return number_of(side | QtCore.Qt.AlignVCenter)
