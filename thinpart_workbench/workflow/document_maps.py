"""The thickness maps that a document holds: put into it, read, and put anew after measuring again."""

import os
import tempfile

import numpy as np

from ..core.map_summary import range_of, telling_range
from ..core.thin_faces import limit_in_millimetres
from ..freecad_adapter.settings import preferred_thin_limit
from ..freecad_adapter.thickness_object import ThicknessObject
from ..storage.map_file import read_maps, write_maps

NAME = "Thickness"


def new_thickness_object(document, sources, parts):
    """Add maps of parts to a document.

    Parameters
    ----------
    document : FreeCAD.Document
    sources : list of FreeCAD.DocumentObject
        Objects whose change makes the maps stale.
    parts : list of MappedPart

    Returns
    -------
    FreeCAD.DocumentObject

    Raises
    ------
    OSError
        Where there is no room for the file.
    """
    thickness = document.addObject("App::FeaturePython", NAME)
    ThicknessObject(thickness)
    thickness.Sources = sources
    _keep(thickness, parts)
    thickness.Threshold = _thin_limit(parts)
    low, high = telling_range(parts) or (0.0, 0.0)
    if high < thickness.Thickest:
        thickness.AutomaticRange = False
        thickness.Low, thickness.High = low, high
    return thickness


def set_parts(thickness, sources, parts):
    """Put the maps of parts that were measured again into an object; scale and threshold stay.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
    sources : list of FreeCAD.DocumentObject
        See `new_thickness_object`.
    parts : list of MappedPart

    Returns
    -------
    int
        Number of probes that were dropped, because the surface is no longer where they were.

    Raises
    ------
    OSError
    """
    from .thickness_probes import carried_probes, probes_of, set_probes

    carried = carried_probes(thickness, parts)
    dropped = len(probes_of(thickness)) - len(carried)
    thickness.Sources = sources
    _keep(thickness, parts)
    set_probes(thickness, carried)
    return dropped


def parts_of(thickness):
    """The parts of an object with their maps, list of MappedPart.

    Raises
    ------
    ThinPartError
        kind ``unreadable``.
    """
    key = map_version(thickness)
    proxy = thickness.Proxy
    if proxy.kept_parts is None or proxy.kept_parts[0] != key:
        proxy.kept_parts = key, read_maps(thickness.Map)
    return proxy.kept_parts[1]


def map_version(thickness):
    """What changes whenever the maps of an object do, to be compared."""
    try:
        found = os.stat(thickness.Map)
    except OSError:
        return thickness.Map, None
    return found.st_ino, found.st_mtime_ns, found.st_size


def _keep(thickness, parts):
    with tempfile.TemporaryDirectory(prefix="thinpart-") as folder:
        path = os.path.join(folder, "thickness.npz")
        write_maps(path, parts)
        thickness.Map = path  # FreeCAD takes a copy
    thickness.Proxy.kept_parts = map_version(thickness), parts
    thickness.Diagonal = max(map(_diagonal, parts), default=0.0)
    thickness.Thinnest, thickness.Thickest = range_of(parts) or (0.0, 0.0)
    thickness.Proxy.measured(thickness)


def _diagonal(part):
    try:
        return float(part.record["descriptors"]["diagonal_mm"])
    except (KeyError, TypeError):
        return float(np.linalg.norm(np.ptp(part.map.points, axis=0)))


def _thin_limit(parts):
    own = preferred_thin_limit()
    if own is not None:
        return min(limit_in_millimetres(own, part.record["descriptors"]["diagonal_mm"]) for part in parts)
    limits = [part.record.get("thin_limit_mm") for part in parts]
    return min((each for each in limits if each), default=0.0)
