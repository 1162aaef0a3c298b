# SPDX-License-Identifier: LGPL-2.1-or-later
"""The found parts: their columns, pictures, and the files that one can drag."""

import os

from ..application.qt import QtCore, translate
from ..application.sentences import translated, translated_list
from ..record.part_columns import category_column, measured, quantity_columns, risk_column, thinnest_column
from ..record.thumbnails import RowPictures, show_pictures
from ..tables.column import Column
from ..tables.fetched_rows import FetchedRows

_MOST = 34
"""Greatest width of a column, in characters."""


class FoundRows(FetchedRows):
    """Model of found parts: rows with the fields of StoredPart.

    Parameters
    ----------
    profile : Profile
        Provides the titles of the categories.
    pictures : Thumbnails

    Attributes
    ----------
    pictures : RowPictures
    """

    def __init__(self, profile, pictures, parent=None):
        self.pictures = RowPictures(pictures)
        super().__init__(self._columns(profile), "label", parent)
        pictures.loaded.connect(lambda: show_pictures(self))

    def tip(self, row, column):
        """Why a part failed; otherwise its file and what is noted of it."""
        return translated(row.error_message or "") or "\n".join(filter(None, (row.file, row.notes)))

    def flags(self, index):
        """Allow dragging of rows."""
        return super().flags(index) | QtCore.Qt.ItemIsDragEnabled

    def mimeTypes(self):
        """MIME type of files, as used by file managers."""
        return ["text/uri-list"]

    def mimeData(self, indexes):
        """URLs of the documents of the dragged parts, without duplicates."""
        parts = [self.row_at(row) for row in sorted({index.row() for index in indexes})]
        files = dict.fromkeys(part.file for part in parts if part is not None)
        data = QtCore.QMimeData()
        data.setUrls([QtCore.QUrl.fromLocalFile(file) for file in files])
        return data

    def _columns(self, profile):
        def reasons(part):
            return translated_list(getattr(part, "reasons", ""))

        columns = [
            Column("score", translate("ThinPart", "Like"), _score, is_number=True, most=8),
            Column("label", translate("ThinPart", "Part"), _part, picture=self.pictures.of, most=_MOST),
            category_column(profile, most=_MOST),
            Column("reasons", translate("ThinPart", "Why"), reasons, tip=lambda part, unit: reasons(part), most=45,
                   is_sortable=False),
            thinnest_column(most=_MOST),
            measured("d1_mm", translate("ThinPart", "Longest, {}"), most=_MOST),
            Column("file", translate("ThinPart", "File"), lambda part: part.place, is_path=True, most=_MOST),
            risk_column(),
        ]
        return columns + quantity_columns({column.key for column in columns}, is_sortable=False)


def part_name(part):
    """Display name of a part."""
    return part.label or part.name or os.path.basename(part.file)


def _part(part):
    return part_name(part) + (f" \u00d7 {part.instances}" if (part.instances or 1) > 1 else "")


def _score(part):
    return f"{part.score:.0f}\u00a0%" if hasattr(part, "score") else ""
