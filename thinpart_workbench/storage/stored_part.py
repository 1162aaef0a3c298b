"""A part as the index knows it."""

import os
from collections import namedtuple

READ = ("name", "label", "instances", "category", "criteria", "margin", "borderline", "d1_mm", "d2_mm", "d3_mm",
        "diagonal_mm", "volume_mm3", "area_mm2", "volume_ratio", "thinnest_mm", "median_mm", "triangles",
        "notes", "mesh", "link", "error_kind", "error_message")
"""Columns of ``parts`` that are read."""

FROM_FILE = ("path", "folder", "document", "sha256", "modified")
"""Columns of ``files`` that are read."""

SELECT = (f"SELECT parts.id, {', '.join(f'files.{each}' for each in FROM_FILE)}, {', '.join(READ)} "
          "FROM parts JOIN files ON files.id = parts.file")

StoredPart = namedtuple("StoredPart", ("root", "id", "file", "info_file", "sha256", "modified", *READ))
"""A part, or, where ``error_kind`` is set, a failure.

``root`` is the library and ``id`` its number in it; ``file`` the document's path and ``info_file`` that of the
info file; ``criteria`` a tuple of str; ``mesh`` JSON text; ``modified`` an ISO date; the rest is as in the info
file, lengths in mm.
"""


def stored_part(root, row):
    """A row of `SELECT` as a `StoredPart`."""
    number, path, folder, document, sha256, modified, *rest = row
    info_file = os.path.join(root, os.fsdecode(path))
    if document is None:
        file = info_file
    else:
        file = os.path.normpath(os.path.join(
            os.path.dirname(info_file), os.fsdecode(folder), os.fsdecode(document)))
    part = StoredPart(root, number, file, info_file, sha256, modified, *rest)
    criteria = tuple(part.criteria.strip(",").split(",")) if part.criteria and part.criteria != ",," else ()
    return part._replace(criteria=criteria, borderline=bool(part.borderline))
