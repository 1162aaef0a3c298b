# SPDX-License-Identifier: LGPL-2.1-or-later
"""PNG files, written with the standard library alone."""

import struct
import zlib

_SIGNATURE = b"\x89PNG\r\n\x1a\n"


def png_bytes(pixels, width, height):
    """An image as a PNG file: bytes.

    Raises ValueError if there are more or fewer pixels.

    ISO/IEC 15948. Rows are stored as they are (filter 0): of pictures with surfaces of one colour, that gives the smallest
    files.

    Parameters
    ----------
    pixels : bytes
        Red, green, blue and alpha, row by row from the top.
    width, height : int
    """
    row = 4 * width
    if len(pixels) != row * height:
        raise ValueError(len(pixels))
    rows = b"".join(b"\x00" + pixels[start:start + row] for start in range(0, len(pixels), row))
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return marked_png(_SIGNATURE + b"".join(
        _chunk(*chunk) for chunk in ((b"IHDR", header), (b"IDAT", zlib.compress(rows, 6)), (b"IEND", b""))))


def marked_png(content):
    """A PNG file with the mark of ThinPart (`core.kinds.file_marks.PICTURE`): bytes."""
    end = len(_SIGNATURE) + len(_chunk(b"IHDR", bytes(13)))
    return content[:end] + _chunk(b"tEXt", b"Software\0ThinPart") + content[end:]


def _chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(
        ">I", zlib.crc32(kind + content))
