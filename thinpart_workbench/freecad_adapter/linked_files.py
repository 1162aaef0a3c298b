"""The other documents that a FreeCAD document takes shapes from, read without FreeCAD."""

import os
import re
import zipfile
from html import unescape
from pathlib import Path

from .damaged_archive import DAMAGED_ARCHIVE


def linked_files(document):
    """Files into which a document links, and into which those link in turn.

    Parameters
    ----------
    document : str or Path

    Returns
    -------
    list of Path
        Sorted, each once, whether it is there or not; empty for what is no FreeCAD document or
        cannot be read, which is told by whoever opens it.
    """
    start = os.path.abspath(document)
    found, waiting = {}, [start]
    while waiting:
        current = waiting.pop()
        for file in _links_of(current):
            path = os.path.normpath(os.path.join(os.path.dirname(current), file))
            if path != start and path not in found:
                found[path] = Path(path)
                waiting.append(path)
    return [found[path] for path in sorted(found)]


def _links_of(file):
    if not file.lower().endswith(".fcstd"):
        return []
    try:
        with zipfile.ZipFile(file) as archive:
            text = archive.read("Document.xml").decode("utf-8", "surrogateescape")
    except DAMAGED_ARCHIVE:
        # Whatever a damaged archive raises: what cannot be read links to nothing, and reading the
        # document itself says why it cannot be read.
        return []
    links = (unescape(file)
             for file in re.findall(r'<XLink\b[^>]*?\bfile="([^"]+)"', text))
    # What lies on a server is none of the files that can be looked at.
    return [file for file in links if "://" not in file]
