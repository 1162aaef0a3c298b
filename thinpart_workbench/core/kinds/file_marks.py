# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one table of the marks by which files that ThinPart has written are recognised.

A mark stands where the format has room for it: in the first line, a comment, a text chunk, or as the titles of a table. Each
also fits what earlier versions wrote, except where people write such files themselves.
"""

import csv
import hashlib
import io
import json
import re
from dataclasses import dataclass

from .json_file import UnreadableJson, parsed_json

_HEAD = 1 << 16
"""Bytes of a file in which its mark lies."""

_LARGEST = 64 << 20
"""Bytes of a file above which it is not read as a whole to find out whether it is ThinPart's."""


@dataclass(frozen=True)
class HeadMark:
    """A mark at the start of a file.

    Attributes
    ----------
    pattern : bytes
        Regular expression, from the first byte on.
    endings : tuple of str
        Endings of CAD formats that a file with this mark may have nevertheless.
    """

    pattern: bytes
    endings: tuple = ()

    def is_in(self, file):
        """Whether an open binary file bears the mark: bool."""
        return re.match(self.pattern, file.read(_HEAD), re.DOTALL) is not None


@dataclass(frozen=True)
class JsonMark:
    """The ``format`` of a JSON file.

    Attributes
    ----------
    format : str
    """

    format: str
    endings = ()

    def is_in(self, file):
        """Whether an open binary file bears the mark: bool."""
        content = file.read(_LARGEST + 1)
        try:
            return len(content) <= _LARGEST and self.is_of(parsed_json(content))
        except UnreadableJson:
            return False

    def is_of(self, content):
        """Whether content of JSON says that it is of this format: bool."""
        return isinstance(content, dict) and content.get("format") == self.format


@dataclass(frozen=True)
class SealMark:
    """A last column of a CSV table whose title has a hash of all other cells.

    People write such tables themselves, and change those that ThinPart wrote. What was changed is no longer ThinPart's.
    """

    endings = ()

    def sealed(self, text):
        """A table with this column: str, as `text`, of which the first line has the titles."""
        titles, end, rows = text.partition("\r\n")
        return f"{titles},{_seal(_cells(text))}{end}{rows}"

    def is_in(self, file):
        """Whether an open binary file bears the mark, and its cells are as they were written: bool."""
        content = file.read(_LARGEST + 1)
        if len(content) > _LARGEST or _SEAL.encode() not in content.split(b"\n", 1)[0]:
            return False
        try:
            titles, *rows = _cells(content.decode("utf-8"))
        except (ValueError, csv.Error):
            return False
        return bool(titles) and titles[-1] == _seal([titles[:-1], *rows])


@dataclass(frozen=True)
class SealedHead:
    """A mark at the start of a file, with a hash of all else in it behind: people add to such files, as loads to a shell.

    What was changed is no longer ThinPart's.

    Attributes
    ----------
    pattern : bytes
        Regular expression, from the first byte to where the hash stands.
    """

    pattern: bytes
    endings = ()

    def sealed(self, content):
        """A file's content with the hash: bytes, as `content`, which begins with the mark."""
        mark = re.match(self.pattern, content)
        if mark is None:
            raise ValueError(self.pattern)
        end = mark.end()
        return content[:end] + f" [{_hash(content)}]".encode() + content[end:]

    def is_in(self, file):
        """Whether an open binary file bears the mark, and all else is as it was written: bool."""
        content = file.read(_LARGEST_SEALED + 1)
        found = re.match(self.pattern + rb"(?P<seal> \[[0-9a-f]{16}\])", content)
        if found is None or len(content) > _LARGEST_SEALED:
            return False
        start, end = found.span("seal")
        return found["seal"].decode() == f" [{_hash(content[:start] + content[end:])}]"


_LARGEST_SEALED = 1 << 30
"""Bytes of a file with such a mark."""

_SEAL = "thinpart:"


def _cells(text):
    rows = list(csv.reader(io.StringIO(text, newline=""), strict=True))
    for row in rows:
        while row and not row[-1]:  # spreadsheets fill rows up with empty cells
            row.pop()
    return rows


def _seal(rows):
    return _SEAL + _hash(json.dumps(rows).encode())


def _hash(content):
    return hashlib.sha256(content).hexdigest()[:16]


_SHELL = rb"Mid-surface of [^\n]* with the thickness of its walls, by ThinPart"

SCRIPT = SealedHead(rb"// Element sizes in mm, by ThinPart")
"""Scripts of Gmsh."""

SHELLS = {
    ".inp": SealedHead(rb"\*\* " + _SHELL),
    ".msh": SealedHead(rb"\$Comments\n" + _SHELL),
    # Its lines have 80 characters at most, which the first may need for the label.
    ".unv": SealedHead(rb"    -1\n   151\nMid-surface of [^\n]*\nLengths in mm, by ThinPart"),
}
"""Shells, by their endings."""

VTP_COMMENT = "<!-- wall thickness in mm, by ThinPart -->"
PLY_COMMENT = "comment wall thickness in mm, by ThinPart"

PICTURE = HeadMark(rb"\x89PNG\r\n\x1a\n.{25}.{4}tEXtSoftware\0ThinPart")
"""PNG: a chunk behind the first one, which has the same size in every PNG file."""

MAPS = {
    ".png": PICTURE,
    # Those of earlier versions have no comment, but the name of the values.
    ".vtp": HeadMark(rb'<\?xml version="1\.0"\?>\n<VTKFile type="PolyData" [^\n]*>\n(' + VTP_COMMENT.encode() + rb'\n|'
                     rb'<PolyData>\n<Piece [^\n]*>\n<PointData Scalars="thickness_mm">)'),
    # ThinPart reads such files too.
    ".ply": HeadMark(rb"ply\nformat binary_little_endian 1\.0\n" + PLY_COMMENT.encode() + rb"\n", (".ply",)),
}
"""Thickness maps, by their endings."""

TABLE = HeadMark(rb"file,part,label,(instances,category,criteria,|category,order,wanted_layers,|face,made_by,area_mm2,|"
                 rb"group,kind,compared,|face,(made_by,)?thinnest_mm,|wall,(thinnest|size|thickness)_mm,|probe,thickness_mm\r?\n)")
"""CSV tables of parts, of their sizes, of what is there twice, and of faces, walls and probes: their titles."""

PAGE = HeadMark(rb'\s*<!DOCTYPE html>.{0,400}<meta name="generator" content="ThinPart ')
"""Pages of reports."""

LABELS = SealMark()
PROFILE = JsonMark("thinpart-profile")
LIMITS = JsonMark("thinpart-wall-limits")
REPORT = JsonMark("thinpart-report")
INFO = JsonMark("thinpart-info")
