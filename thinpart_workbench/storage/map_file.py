"""Thickness maps of parts in one file."""

import json
import os
import zipfile

import numpy as np

from ..core.errors import ThinPartError
from ..core.mapped_part import MappedPart
from ..core.thickness_map import ThicknessMap

_ARRAYS = ("points", "facets", "thickness", "opposite", "face", "origin")
VERSION = 1


def write_maps(path, parts):
    """Write maps, for a worker's parent or into a FreeCAD document.

    Parameters
    ----------
    path : str
    parts : list of MappedPart

    Raises
    ------
    OSError
    """
    arrays = {}
    for number, part in enumerate(parts):
        arrays.update({f"{name}_{number}": getattr(part.map, name) for name in _ARRAYS})
        arrays[f"places_{number}"] = part.places
        arrays[f"outline_{number}"] = part.map.outline
    content = {"version": VERSION, "parts": [
        {"record": part.record, "features": part.features} for part in parts]}
    with open(path, "wb") as file:
        np.savez(file, content=np.array(json.dumps(content)), **arrays)


def read_maps(path):
    """The maps that `write_maps` wrote, list of MappedPart.

    Raises
    ------
    ThinPartError
        kind ``unreadable``.
    """
    try:
        # Opened here: numpy leaves a damaged file open.
        with open(path, "rb") as opened, np.load(opened, allow_pickle=False) as file:
            content = json.loads(str(file["content"]))
            if content["version"] > VERSION:
                raise ThinPartError(
                    f"The thickness map {os.path.basename(path)} is of a newer ThinPart: update ThinPart or "
                    "measure the part again.", "unreadable")
            return [_part(file, number, entry) for number, entry in enumerate(content["parts"])]
    except (OSError, ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile):
        raise ThinPartError(
            f"The thickness map {os.path.basename(path)} cannot be read: measure the part again.",
            "unreadable") from None


def _part(file, number, entry):
    shown = ThicknessMap(*(file[f"{name}_{number}"] for name in _ARRAYS))
    # Found by the process that measured: it takes 0.2 s where there are 200,000 facets.
    vars(shown)["outline"] = file[f"outline_{number}"]
    return MappedPart(entry["record"], shown, entry["features"], file[f"places_{number}"])
