# SPDX-License-Identifier: LGPL-2.1-or-later
"""Detect errors in mesh files that FreeCAD's readers silently ignore."""

import re

import numpy as np

from ...core.errors import ThinPartError
from ...core.file_formats import format_of
from ...core.message import message

_NOT_A_NUMBER = re.compile(rb"(?<!\S)[-+]?(nan|inf(inity)?)(?!\S)", re.IGNORECASE)
_NUMBERS = re.compile(rb"^\s*(vertex\s|v\s|[-+.0-9]|nan|inf)", re.IGNORECASE)


def check_mesh_file(path):
    """Raise a `ThinPartError` for a truncated STL and for coordinates that are not finite numbers.

    FreeCAD reads a truncated binary STL as empty, and skips or zeroes coordinates like ``nan``.
    """
    found = format_of(path)
    if found.name == "STL" and not _is_text_stl(path):
        _check_binary_stl(path)
    elif found.has_text:
        _check_text(path, found.name)


def _is_text_stl(path):
    with open(path, "rb") as file:
        start = file.read(4096)
    return start[:5].lower() == b"solid" and b"\0" not in start


def _check_binary_stl(path):
    """Check a binary STL: an 80 byte header, the number of triangles, and 50 bytes per triangle."""
    size = path.stat().st_size
    with open(path, "rb") as file:
        head = file.read(84)
        announced = int.from_bytes(head[80:84], "little")
        if len(head) < 84 or size < 84 + 50 * announced:
            raise ThinPartError(
                message("{file} is truncated or not an STL file: its header says {announced} triangles, it holds {held}.",
                        file=path.name, announced=announced, held=max(0, size - 84) // 50), "unreadable",
            )
        triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("flags", "<u2")])
        while announced > 0:
            block = np.fromfile(file, triangle, min(announced, 1 << 16))
            announced -= len(block)
            if not np.isfinite(block["corners"]).all():
                raise _not_finite(path)


def _check_text(path, format_name):
    last = b""
    with open(path, "rb") as file:
        if format_name == "PLY" and b"format binary" in file.read(4096):
            return  # binary coordinates are checked when the mesh is used
        file.seek(0)
        for line in file:
            line = line.partition(b"#")[0]
            if format_name == "OBJ" and line.startswith(b"f ") and len(line.split()) > 5:
                raise ThinPartError(
                    message("{file} has faces with more than four corners, which FreeCAD leaves out: triangulate it "
                            "first.", file=path.name), "unsupported",
                )
            if _NUMBERS.match(line) and _NOT_A_NUMBER.search(line):
                raise _not_finite(path)
            last = line if line.strip() else last
    if format_name == "STL" and not last.strip().lower().startswith(b"endsolid"):
        raise ThinPartError(message("{file} is truncated: its end is missing.", file=path.name), "unreadable")


def _not_finite(path):
    return ThinPartError(
        message("{file} has coordinates that are not finite numbers: export it again.", file=path.name), "not_finite"
    )
