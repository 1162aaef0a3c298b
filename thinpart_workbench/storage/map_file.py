# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files with the thickness maps of parts."""

import json
import os
import zipfile

import numpy as np

from ..core.analysis_settings import RAY
from ..core.errors import ThinPartError
from ..core.maps.mapped_part import MappedPart
from ..core.maps.thickness_map import ThicknessMap
from ..core.message import message

_ARRAYS = ("points", "facets", "thickness", "opposite", "face", "origin")
VERSION = 1


def write_maps(path, parts):
    """Write maps, for the parent of a worker or into a FreeCAD document; raises OSError."""
    arrays = {}
    for number, part in enumerate(parts):
        arrays.update({f"{name}_{number}": getattr(part.map, name) for name in _ARRAYS})
        arrays[f"corners_{number}"] = part.map.corner_thickness
        if part.map.balls is not None:
            arrays[f"balls_{number}"] = part.map.balls
        arrays[f"places_{number}"] = part.matrices
        arrays[f"outline_{number}"] = part.map.outline
    content = {"version": VERSION, "parts": [
        {"record": part.record, "features": part.features, "measure": part.map.measure} for part in parts]}
    with open(path, "wb") as file:
        np.savez(file, content=np.array(json.dumps(content)), **arrays)


def read_maps(path):
    """The maps that `write_maps` wrote, list of MappedPart; raises ThinPartError of kind ``unreadable``."""
    try:
        # Opened here because numpy leaves a damaged file open.
        with open(path, "rb") as stream, np.load(stream, allow_pickle=False) as file:
            content = json.loads(str(file["content"]))
            if content["version"] > VERSION:
                raise ThinPartError(
                    message("The thickness map {file} is of a newer ThinPart: update ThinPart or measure the part "
                            "again.", file=os.path.basename(path)), "unreadable")
            return [_part(file, number, entry) for number, entry in enumerate(content["parts"])]
    except (OSError, ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile):
        raise ThinPartError(
            message("The thickness map {file} cannot be read: measure the part again.", file=os.path.basename(path)),
            "unreadable") from None


def _part(file, number, entry):
    corners, balls = (file[f"{name}_{number}"] if f"{name}_{number}" in file.files else None  # earlier versions wrote none
                      for name in ("corners", "balls"))
    thickness_map = ThicknessMap(**{name: file[f"{name}_{number}"] for name in _ARRAYS}, measure=entry.get("measure", RAY),
                                 corner_thickness=corners, balls=balls)
    # Computed by the process that measured: it takes 0.2 s for 200,000 facets.
    vars(thickness_map)["outline"] = file[f"outline_{number}"]
    return MappedPart(entry["record"], thickness_map, entry["features"], file[f"places_{number}"])
