"""Searching libraries: refresh their indexes, ask them, read the rows that are shown."""

from collections.abc import Sequence

from ..storage.library_index import LibraryIndex
from ..storage.part_query import PartQuery
from ..storage.stored_part import SELECT, stored_part
from .kept_notes import stored_records

ROWS_AT_ONCE = 500


class FoundParts(Sequence):
    """Parts that were found: their number is known at once, rows are read when they are asked for.

    Parameters
    ----------
    index : LibraryIndex
    ids : list of int
        In the order in which they are shown.
    """

    def __init__(self, index, ids):
        self._index, self.ids = index, ids

    def __len__(self):
        return len(self.ids)

    def __getitem__(self, place):
        if isinstance(place, slice):
            return self._rows(self.ids[place])
        rows = self._rows([self.ids[place]])
        if not rows:
            raise IndexError("the part has gone from the index since it was found")
        return rows[0]

    def __iter__(self):
        for start in range(0, len(self.ids), ROWS_AT_ONCE):
            yield from self._rows(self.ids[start:start + ROWS_AT_ONCE])

    def _rows(self, ids):
        marks = ", ".join("?" * len(ids))
        rows = {row[0]: row for row in self._index.query(f"{SELECT} WHERE parts.id IN ({marks})", ids)}
        return [stored_part(self._index.root, rows[each]) for each in ids if each in rows]


def open_library(root, report=None):
    """The index of a folder, brought up to date.

    Parameters
    ----------
    root : str or Path
    report : callable, optional
        Called with the numbers of info files read and to be read; may raise to stop.

    Returns
    -------
    index : LibraryIndex
    refreshed : Refreshed

    Raises
    ------
    ThinPartError
        where the folder cannot be reached.
    """
    index = LibraryIndex(root)
    return index, index.refresh(report)


def find_parts(index, query=PartQuery(), order="files.path, parts.id"):
    """Parts of a library that fulfil a query.

    Parameters
    ----------
    index : LibraryIndex
    query : PartQuery
    order : str
        SQL; empty for the order of the index, which is the quickest.

    Returns
    -------
    FoundParts
    """
    where, values = query.where()
    joined = " JOIN files ON files.id = parts.file" if "files." in where + order else ""
    ordered = f" ORDER BY {order}" if order else ""
    rows = index.query(f"SELECT parts.id FROM parts{joined} WHERE {where}{ordered}", values)
    return FoundParts(index, [number for number, in rows])


def read_records(parts):
    """Part records of found parts from their info files, as ``--json`` prints them.

    Parameters
    ----------
    parts : iterable of StoredPart

    Yields
    ------
    dict
        The record and ``file``; for a failure ``file``, ``name``, ``label`` and ``error``.
    """
    last, records = None, {}
    for part in parts:
        named = {"file": part.file, "info_file": part.info_file}
        if part.info_file != last and not part.error_kind:
            last, records = part.info_file, {each["name"]: each for each in stored_records(part.info_file)}
        if part.error_kind:
            error = {"kind": part.error_kind, "message": part.error_message}
            yield {**named, "name": part.name, "label": part.label, "error": error}
        elif part.name in records:
            yield {**named, **records[part.name]}
