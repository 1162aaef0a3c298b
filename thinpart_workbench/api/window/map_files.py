"""Thickness maps of open documents as files."""

from pathlib import Path

from ...core.kinds.file_marks import MAPS
from ...storage.exchange.map_export import MAP_FORMATS, write_map_file
from ...storage.output_file import write_output
from ...storage.png import marked_png
from ...storage.temporary_folder import temporary_folder
from ..document_maps import parts_of

PICTURE = ".png"
"""Ending of pictures of the view."""

MARKS = MAPS
"""By ending, what files of ThinPart's own have in them; see `storage.output_file.check_output`."""


def map_titles():
    """By ending, the titles of the formats for triangles with values, each with its ending: dict of str to Message.

    Examples
    --------
    >>> map_titles()[".vtp"]
    'VTK PolyData with thickness (*.vtp)'
    """
    return {ending: each.title for ending, each in MAP_FORMATS.items()}


def write_triangles(path, ending, thickness, colours, overwrite=False):
    """Write a map as triangles with values.

    Parameters
    ----------
    path : str or Path
    ending : str
        One of `map_titles`.
    thickness : FreeCAD.DocumentObject
    colours : callable
        Maps thicknesses in mm, ndarray of shape (n,), to ndarray of shape (n, 3), uint8.
    overwrite : bool, optional
        Whether the file may be one that ThinPart did not write.

    Raises
    ------
    OSError
    ForeignFile

    Examples
    --------
    >>> write_triangles(f"{samples}/map.vtp", ".vtp", thickness, None)
    >>> os.path.getsize(f"{samples}/map.vtp") > 1000
    True
    """
    write_map_file(path, ending, parts_of(thickness), colours, overwrite)


def write_picture(path, draw, overwrite=False):
    """Write a picture that someone else draws.

    Parameters
    ----------
    path : str or Path
    draw : callable
        Called with the path of a PNG file to be made; it raises an OSError where that is not possible.
    overwrite : bool, optional
        See `write_triangles`.

    Raises
    ------
    OSError
    ForeignFile

    Examples
    --------
    >>> from thinpart_workbench.storage.png import png_bytes
    >>> write_picture(f"{samples}/map.png", lambda file: Path(file).write_bytes(png_bytes(bytes(4), 1, 1)))
    >>> os.path.isfile(f"{samples}/map.png")
    True
    """
    with temporary_folder() as folder:
        file = Path(folder) / f"view{PICTURE}"
        draw(str(file))
        write_output(path, marked_png(file.read_bytes()), MAPS[PICTURE], overwrite)
