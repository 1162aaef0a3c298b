# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of one library: found in its index, and their records."""

from ...core.errors import ThinPartError
from ...core.foreign_text import sql_text
from ...storage.index.part_query import PartQuery
from ...storage.index.stored_part import SELECT, stored_part
from ...storage.info.stored_records import stored_records

ROWS_AT_ONCE = 500


def stored_parts(index, ids):
    """Parts of a LibraryIndex by their ids: yields StoredPart in the order of the ids, without those that are gone."""
    for start in range(0, len(ids), ROWS_AT_ONCE):
        some = ids[start:start + ROWS_AT_ONCE]
        marks = ", ".join("?" * len(some))
        rows = {row[0]: row for row in index.query(f"{SELECT} WHERE parts.id IN ({marks})", some)}
        yield from (stored_part(index.root, rows[part_id]) for part_id in some if part_id in rows)


def find_parts(index, query=PartQuery()):
    """Parts of a LibraryIndex that match a query, in the order of their paths: list of StoredPart."""
    where, values = query.where()
    return [stored_part(index.root, row)
            for row in index.query(f"{SELECT} WHERE {where} ORDER BY files.path, parts.id", values)]


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
