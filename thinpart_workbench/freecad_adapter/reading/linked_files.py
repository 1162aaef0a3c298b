# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the other documents that a FreeCAD document links to, without FreeCAD."""

import os
import re
import zipfile
from html import unescape
from pathlib import Path
from xml.parsers import expat

from ...core.file_formats import is_document
from .damaged_archive import DAMAGED_ARCHIVE

_TOKEN = re.compile(r'<XLink\b|>|\bfile="([^"]+)"')
"""Searched once through the XML: a pattern for whole tags takes the square of the time where none is closed."""


def linked_files(document):
    """Files that the document at a path links to, directly or through other files.

    Returns a list of Path: sorted, without duplicates, including files that do not exist. Empty if the file is not a FreeCAD
    document or cannot be read; opening it reports the error.
    """
    start = os.path.abspath(document)
    found, pending = {}, [start] if is_document(start) else []
    while pending:
        current = pending.pop()
        for file in _links_of(current):
            path = os.path.normpath(os.path.join(os.path.dirname(current), file))
            if path != start and path not in found:
                found[path] = Path(path)
                pending.append(path)
    return [found[path] for path in sorted(found)]


def _links_of(file):
    # Opening a pipe would block. A linked file may have any suffix, because FreeCAD looks at its content.
    if not os.path.isfile(file):
        return []
    try:
        with zipfile.ZipFile(file) as archive:
            content = archive.read("Document.xml")
    except DAMAGED_ARCHIVE:
        # An unreadable file links to nothing; opening the document reports why it cannot be read.
        return []
    # Files on a server cannot be inspected.
    return [file for file in dict.fromkeys([*_by_parser(content), *_by_pattern(content)]) if "://" not in file]


def _by_parser(content):
    """Links found by an XML parser, whatever the notation, up to the point where the XML is damaged."""
    found = []

    def start(tag, attributes):
        if tag.rpartition(":")[2] == "XLink" and attributes.get("file"):
            found.append(attributes["file"])

    parser = expat.ParserCreate()
    parser.StartElementHandler = start
    try:
        parser.Parse(content, True)
    except (expat.ExpatError, ValueError, LookupError):
        pass  # FreeCAD may read on, so `_by_pattern` searches the rest
    return found


def _by_pattern(content):
    """Links found by a pattern in XML as FreeCAD writes it, even if file names are not valid UTF-8."""
    is_link, found = False, []
    for token in _TOKEN.finditer(content.decode("utf-8", "surrogateescape")):
        if token[1] is None:
            is_link = token[0] != ">"
        elif is_link:
            found.append(unescape(token[1]))
            is_link = False
    return found
