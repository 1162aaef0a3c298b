# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thumbnails of parts in the user's cache, identified by the document's hash and the part's name."""

import hashlib
import re

from ..core.rendering.picture_size import HEIGHT, WIDTH
from .cache_folder import cache_folder, write_cached
from .png import png_bytes


def thumbnail_path(sha256, part_name):
    """The path of the thumbnail of a part, whether or not it exists.

    Returns a Path or None: a PNG file of 160 x 120 pixels. Copies of a document share a thumbnail. None if `sha256` is not a
    valid hash: info files are untrusted, and their content must not lead to paths outside the cache. Raises OSError if there
    is no cache folder.

    Parameters
    ----------
    sha256 : str
        Hash of the document from its info file.
    part_name : str
        The part's unique name in the document.
    """
    if not isinstance(sha256, str) or not re.fullmatch("[0-9a-f]{64}", sha256):
        return None
    # A part name may contain characters that file names must not.
    name = hashlib.sha256(part_name.encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return cache_folder() / "thumbnails" / sha256[:2] / f"{sha256}-{name}.png"


def has_thumbnail(sha256, part_name):
    """Whether the cache has the thumbnail of a part; parameters as of `thumbnail_path`."""
    try:
        path = thumbnail_path(sha256, part_name)
        return path is not None and path.is_file()
    except OSError:
        return False


def write_thumbnail(sha256, part_name, pixels):
    """Write the thumbnail of a part.

    Raises OSError: no partial file is left, and an existing thumbnail stays. Raises ValueError if there are more or fewer
    pixels.

    Parameters
    ----------
    sha256, part_name : str
    pixels : bytes
        Red, green, blue and alpha of `WIDTH` x `HEIGHT` pixels.
    """
    write_cached(thumbnail_path(sha256, part_name), png_bytes(pixels, WIDTH, HEIGHT))
