"""The picture of a part, drawn when it was measured."""

from contextlib import suppress

from ..core.picture import picture
from ..freecad_adapter.thin_colours import preferred_colours
from ..storage.thumbnails import write_thumbnail


def keep_thumbnail(mesh, record, sha256):
    """Draw a part and keep the picture in the user's cache, if there is room for it.

    Parameters
    ----------
    mesh : SurfaceMesh
    record : dict
        Part record.
    sha256 : str
        Of the document.
    """
    # A picture can be made again, and what was measured is worth more than it.
    with suppress(OSError, MemoryError):
        write_thumbnail(sha256, record["name"], picture(mesh, preferred_colours(record)))
