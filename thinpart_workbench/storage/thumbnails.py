"""Small pictures of parts in the user's cache, found by the document's content and the part's name."""

import hashlib

from .atomic_file import write_atomically
from .cache_folder import cache_folder
from .png import png_bytes


def thumbnail_path(sha256, part_name):
    """Where the picture of a part lies, whether or not there is one.

    Parameters
    ----------
    sha256 : str
        Of the document, as its info file has it.
    part_name : str
        The part's unique name in it.

    Returns
    -------
    Path
        A PNG file of 160 x 120 pixels. The same document in two places has one picture.

    Raises
    ------
    OSError
        Where there is no cache folder.
    """
    # A name may hold what no file name may.
    name = hashlib.sha256(part_name.encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return cache_folder() / "thumbnails" / sha256[:2] / f"{sha256}-{name}.png"


def write_thumbnail(sha256, part_name, pixels):
    """Keep the picture of a part.

    Parameters
    ----------
    sha256, part_name : str
    pixels : ndarray of shape (height, width, 4), uint8
        Red, green, blue and alpha.

    Raises
    ------
    OSError
        Nothing half-written is left; a picture that was there still is.
    """
    path = thumbnail_path(sha256, part_name)
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, png_bytes(pixels), lasting=False)
