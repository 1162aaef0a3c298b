"""PNG files, written with the standard library alone."""

import struct
import zlib


def png_bytes(pixels):
    """An image as a PNG file.

    Parameters
    ----------
    pixels : ndarray of shape (height, width, 4), uint8
        Red, green, blue and alpha.

    Returns
    -------
    bytes

    Notes
    -----
    ISO/IEC 15948. Each row is stored as its difference from the row above (filter 2), which is zero for
    surfaces of one colour.
    """
    height, width, _ = pixels.shape
    rows = pixels.reshape(height, -1)
    difference = rows.copy()
    difference[1:] -= rows[:-1]
    filtered = b"".join(b"\x02" + row.tobytes() for row in difference)
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        _chunk(*chunk) for chunk in ((b"IHDR", header), (b"IDAT", zlib.compress(filtered, 9)), (b"IEND", b"")))


def _chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(
        ">I", zlib.crc32(kind + content))
