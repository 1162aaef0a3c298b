"""Faults of mesh files that FreeCAD's readers pass over without a word."""

import re

import numpy as np

from ..core.errors import ThinPartError

_NOT_A_NUMBER = re.compile(rb"(?<!\S)[-+]?(nan|inf(inity)?)(?!\S)", re.IGNORECASE)
_NUMBERS = re.compile(rb"^\s*(vertex\s|v\s|[-+.0-9]|nan|inf)", re.IGNORECASE)
_TEXT_FORMATS = (".stl", ".obj", ".off", ".ply")


def check_mesh_file(path):
    """Raise a `ThinPartError` for a truncated STL and for coordinates that are no numbers.

    FreeCAD reads a truncated binary STL as empty, and skips or zeroes coordinates like ``nan``.
    """
    if path.suffix.lower() == ".stl" and not _is_text_stl(path):
        _check_binary_stl(path)
    elif path.suffix.lower() in _TEXT_FORMATS:
        _check_text(path)


def _is_text_stl(path):
    with open(path, "rb") as file:
        start = file.read(4096)
    return start[:5].lower() == b"solid" and b"\0" not in start


def _check_binary_stl(path):
    """An 80 byte header, the number of triangles, and 50 bytes for each."""
    size = path.stat().st_size
    with open(path, "rb") as file:
        head = file.read(84)
        announced = int.from_bytes(head[80:84], "little")
        if len(head) < 84 or size < 84 + 50 * announced:
            raise ThinPartError(
                f"{path.name} is truncated or no STL file: it announces {announced} triangles and "
                f"holds {max(0, size - 84) // 50}.", "unreadable",
            )
        triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("flags", "<u2")])
        while announced > 0:
            some = np.fromfile(file, triangle, min(announced, 1 << 16))
            announced -= len(some)
            if not np.isfinite(some["corners"]).all():
                raise _not_finite(path)


def _check_text(path):
    last = b""
    with open(path, "rb") as file:
        if path.suffix.lower() == ".ply" and b"format binary" in file.read(4096):
            return  # its coordinates are checked where they are used
        file.seek(0)
        for line in file:
            line = line.partition(b"#")[0]
            if path.suffix.lower() == ".obj" and line.startswith(b"f ") and len(line.split()) > 5:
                raise ThinPartError(
                    f"{path.name} has faces with more than four corners, which FreeCAD leaves out: "
                    "triangulate it first.", "unsupported",
                )
            if _NUMBERS.match(line) and _NOT_A_NUMBER.search(line):
                raise _not_finite(path)
            last = line if line.strip() else last
    if path.suffix.lower() == ".stl" and not last.strip().lower().startswith(b"endsolid"):
        raise ThinPartError(f"{path.name} is truncated: its end is missing.", "unreadable")


def _not_finite(path):
    return ThinPartError(
        f"{path.name} has coordinates that are not finite numbers: export it again.", "not_finite"
    )
