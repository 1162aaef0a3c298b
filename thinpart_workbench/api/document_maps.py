# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thickness maps in a document: adding, reading and updating them."""

import os
import shutil
import tempfile

import numpy as np

from ..core.analysis_settings import RAY
from ..core.maps.map_summary import thickness_range, typical_range
from ..core.record.thin_faces import limit_in_millimetres, shown_limit_mm
from ..freecad_adapter.objects.thickness_object import ThicknessObject, unit_in_mm
from ..freecad_adapter.objects.thickness_probes import carried_probes, probes_of, set_probes
from ..freecad_adapter.preferences import preferred_thin_limit
from ..storage.map_file import read_maps, write_maps

NAME = "Thickness"


def new_thickness_object(document, sources, parts):
    """Add maps of parts to a document: FreeCAD.DocumentObject. Raises an OSError if there is no space for the file.

    Parameters
    ----------
    document : FreeCAD.Document
    sources : list of FreeCAD.DocumentObject
        Objects whose change makes the maps stale.
    parts : list of MappedPart

    Examples
    --------
    >>> added = new_thickness_object(document, thickness.Sources, parts_of(thickness))
    >>> round(added.Thinnest, 2)
    2.0
    """
    thickness = document.addObject("App::FeaturePython", NAME)
    ThicknessObject(thickness)
    thickness.Sources = sources
    _store(thickness, parts)
    thickness.Threshold = _thin_limit_mm(parts)
    _choose_range(thickness, parts)
    return thickness


def set_parts(thickness, sources, parts):
    """Replace the maps of an object after measuring again; threshold and scale stay, and so does the former map in
    `parts_before` where the sources have changed since.

    By another measure, the range of the scale is chosen as that of a new object. Returns how many probes were dropped, since
    they no longer lie on the surface. Raises an OSError.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
    sources, parts
        See `new_thickness_object`.

    Examples
    --------
    >>> set_parts(thickness, thickness.Sources, parts_of(thickness))  # none of its probes was dropped
    0
    """
    probes = carried_probes(thickness, parts)
    dropped = len(probes_of(thickness)) - len(probes)
    if thickness.Stale:
        _keep_map_of_before(thickness)
    thickness.Sources = sources
    measure_before = thickness.Measure
    _store(thickness, parts)
    if thickness.Measure != measure_before:
        _choose_range(thickness, parts)
    set_probes(thickness, probes)
    return dropped


def parts_of(thickness):
    """The parts of an object with their maps, list of MappedPart. Raises a ThinPartError, kind ``unreadable``.

    Examples
    --------
    >>> [part.record["label"] for part in parts_of(thickness)]
    ['plate']
    """
    key = map_version(thickness)
    proxy = thickness.Proxy
    if proxy.cached_parts is None or proxy.cached_parts[0] != key:
        proxy.cached_parts = key, read_maps(thickness.Map)
    return proxy.cached_parts[1]


def parts_before(thickness):
    """The parts of an object with their maps of before the last change of the sources, list of MappedPart; may be empty.

    Raises a ThinPartError, kind ``unreadable``.

    Examples
    --------
    >>> parts_before(thickness)
    []
    """
    return read_maps(thickness.MapBefore) if thickness.MapBefore else []


def map_version(thickness):
    """A value to compare, which changes whenever the maps of an object do.

    Examples
    --------
    >>> map_version(thickness) == map_version(thickness)
    True
    """
    try:
        status = os.stat(thickness.Map)
    except OSError:
        return thickness.Map, None
    return status.st_ino, status.st_mtime_ns, status.st_size


def _keep_map_of_before(thickness):
    with tempfile.TemporaryDirectory(prefix="thinpart-") as folder:
        path = os.path.join(folder, "thickness-before.npz")
        try:
            shutil.copyfile(thickness.Map, path)
        except OSError:
            return  # the map is lost, and there is nothing to compare with
        thickness.MapBefore = path  # FreeCAD copies the file


def _store(thickness, parts):
    with tempfile.TemporaryDirectory(prefix="thinpart-") as folder:
        path = os.path.join(folder, "thickness.npz")
        write_maps(path, parts)
        thickness.Map = path  # FreeCAD copies the file
    thickness.Proxy.cached_parts = map_version(thickness), parts
    thickness.Measure = next((part.map.measure for part in parts), RAY)
    thickness.Diagonal = max(map(_diagonal, parts), default=0.0)
    thickness.Thinnest, thickness.Thickest = _extremes(parts)
    thickness.Proxy.measured(thickness)


def _extremes(parts):
    """The thinnest wall, as the records of the parts have it, and the greatest thickness of their maps, mm.

    Beside an edge, facets are as thin as one likes: that is no wall.
    """
    thinnest, thickest = thickness_range(parts) or (0.0, 0.0)
    recorded = [part.record.get("descriptors", {}).get("thickness_mm", {}).get("min") for part in parts
                if part.map.measure == RAY]
    return min((wall for wall in recorded if wall is not None), default=thinnest), thickest


def _choose_range(thickness, parts):
    low, high = typical_range(parts) or (0.0, 0.0)
    thickness.AutomaticRange = high >= thickness.Thickest
    if not thickness.AutomaticRange:
        unit = unit_in_mm(thickness)
        thickness.Low, thickness.High = low / unit, high / unit


def _diagonal(part):
    try:
        return float(part.record["descriptors"]["diagonal_mm"])
    except (KeyError, TypeError):
        return float(np.linalg.norm(np.ptp(part.map.points, axis=0)))


def _thin_limit_mm(parts):
    preferred_limit = preferred_thin_limit()
    if preferred_limit is not None:
        return min(limit_in_millimetres(preferred_limit, part.record["descriptors"]["diagonal_mm"]) for part in parts)
    limits = [shown_limit_mm(part.record) for part in parts if "descriptors" in part.record]
    return min((limit for limit in limits if limit), default=0.0)
