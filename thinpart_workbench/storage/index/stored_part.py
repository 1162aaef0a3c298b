# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part as stored in the index."""

import json
import os
from typing import Any

from ...core.message import from_data
from ..record_columns import INDEXED, row_class

PART_COLUMNS = (*(column.name for column in INDEXED if column.name != "text"), "error_kind", "error_message")
"""Columns of ``parts`` that are read: all but the search text."""

FILE_COLUMNS = ("path", "folder", "document", "sha256", "modified")
"""Columns of ``files`` that are read."""

SELECT = (f"SELECT parts.id, {', '.join(f'files.{column}' for column in FILE_COLUMNS)}, "
          f"{', '.join(PART_COLUMNS)}, error_data FROM parts JOIN files ON files.id = parts.file")

_Row: Any = row_class("_Row", ("root", "id", "file", "info_file", "sha256", "modified", *PART_COLUMNS))


class StoredPart(_Row):
    """A part, or, if ``error_kind`` is set, a failure.

    ``root`` is the library's folder and ``id`` the part's number in its index; ``file`` is the path of the document
    and ``info_file`` that of the info file; ``criteria`` is a tuple of str, ``mesh`` JSON text, ``modified`` an ISO
    date, ``error_message`` a Message if its template is known; the rest is as in the info file, lengths in mm.
    """

    __slots__ = ()


def stored_part(root, row):
    """A row of `SELECT` as a `StoredPart`."""
    number, path, folder, document, sha256, modified, *rest, data = row
    info_file = os.path.join(root, os.fsdecode(path))
    if document is None:
        file = info_file
    else:
        file = os.path.normpath(os.path.join(
            os.path.dirname(info_file), os.fsdecode(folder), os.fsdecode(document)))
    part = StoredPart(root, number, file, info_file, sha256, modified, *rest)
    if data is not None:
        part = part._replace(error_message=from_data(json.loads(data)) or part.error_message)
    criteria = tuple(part.criteria.strip(",").split(",")) if part.criteria and part.criteria != ",," else ()
    return part._replace(criteria=criteria, borderline=bool(part.borderline))
