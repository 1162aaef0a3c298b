"""Searching libraries: refresh their indexes, query them, read rows when they are shown."""

from collections.abc import Sequence

from ...core.errors import ThinPartError
from ...core.foreign_text import sql_text
from ...storage.index.library_index import LibraryIndex
from ...storage.index.part_query import PartQuery
from ...storage.index.stored_part import SELECT, stored_part
from ...storage.info.stored_records import stored_records

ROWS_AT_ONCE = 500


class FoundParts(Sequence):
    """The parts that a query found: their number is known at once, their rows are read on access.

    Parameters
    ----------
    index : LibraryIndex
    ids : list of int
        In display order.
    """

    def __init__(self, index, ids):
        self._index, self.ids = index, ids

    def __len__(self):
        return len(self.ids)

    def __getitem__(self, index):
        if isinstance(index, slice):
            return self._rows(self.ids[index])
        rows = self._rows([self.ids[index]])
        if not rows:
            raise IndexError("the part has gone from the index since it was found")
        return rows[0]

    def __iter__(self):
        for start in range(0, len(self.ids), ROWS_AT_ONCE):
            yield from self._rows(self.ids[start:start + ROWS_AT_ONCE])

    def _rows(self, ids):
        marks = ", ".join("?" * len(ids))
        rows = {row[0]: row for row in self._index.query(f"{SELECT} WHERE parts.id IN ({marks})", ids)}
        return [stored_part(self._index.root, rows[part_id]) for part_id in ids if part_id in rows]


def open_library(root, report=None):
    """The up-to-date index of a folder.

    Returns `index` (LibraryIndex) and `refreshed` (Refreshed). Raises ThinPartError if the folder cannot be reached.

    Parameters
    ----------
    root : str or Path
    report : callable, optional
        Called with the numbers of info files read and to be read; may raise to stop.
    """
    index = LibraryIndex(root)
    return index, index.refresh(report)


def find_parts(index, query=PartQuery(), order="files.path, parts.id"):
    """Parts of a library that match a query: FoundParts.

    Parameters
    ----------
    index : LibraryIndex
    query : PartQuery
    order : str
        SQL; empty for the order of the index, which is fastest.
    """
    where, values = query.where()
    joined = " JOIN files ON files.id = parts.file" if "files." in where + order else ""
    ordered = f" ORDER BY {order}" if order else ""
    rows = index.query(f"SELECT parts.id FROM parts{joined} WHERE {where}{ordered}", values)
    return FoundParts(index, [number for number, in rows])


def read_records(parts):
    """Part records of found StoredParts from their info files, as ``--json`` prints them.

    Yields a dict: the record and ``file``; for a failure ``file``, ``name``, ``label`` and ``error``.
    """
    last_info_file, records, error = None, {}, None
    for part in parts:
        paths = {"file": part.file, "info_file": part.info_file}
        if part.info_file != last_info_file and not part.error_kind:
            last_info_file, (records, error) = part.info_file, _records(part.info_file)
        if part.error_kind:
            failure = {"kind": part.error_kind, "message": part.error_message}
            yield {**paths, "name": part.name, "label": part.label, "error": failure}
        elif error is not None:
            yield {**paths, "name": part.name, "label": part.label, "error": error}
        elif part.name in records:
            yield {**paths, **records[part.name]}


def _records(info_file):
    """Records by their name in the index; and the error if they can no longer be read, or None."""
    try:
        return {sql_text(record["name"]): record for record in stored_records(info_file)}, None
    except ThinPartError as error:
        return {}, {"kind": error.kind, "message": str(error)}
