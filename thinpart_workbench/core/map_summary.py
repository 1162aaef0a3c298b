"""What thickness maps come to: area over ranges of thickness, and the walls under each face."""

from dataclasses import dataclass
from typing import Optional

import numpy as np


@dataclass(frozen=True)
class FaceSummary:
    """Walls under one B-Rep face, as its facets show them.

    Attributes
    ----------
    face : int
        From 0.
    area : float, mm2
    thinnest, median : float or None, mm
        None where nothing was measured.
    thin_share, unmeasured_share : float
        Of the face's area.
    """

    face: int
    area: float
    thinnest: Optional[float]
    median: Optional[float]
    thin_share: float
    unmeasured_share: float


def area_by_thickness(parts, edges):
    """Share of the area over walls between edges.

    Parameters
    ----------
    parts : list of MappedPart
        Each counts as often as it stands somewhere.
    edges : ndarray of shape (k + 1,), mm
        Ascending; the last bin includes its upper edge.

    Returns
    -------
    shares : ndarray of shape (k,)
    unmeasured : float
        Both of all area.
    """
    bins, unmeasured, total = np.zeros(len(edges) - 1), 0.0, 0.0
    for part in parts:
        shown, times = part.map, len(part.places)
        measured = shown.measured
        bins += times * np.histogram(shown.thickness[measured], edges, weights=shown.areas[measured])[0]
        unmeasured += times * shown.areas[~measured].sum()
        total += times * shown.areas.sum()
    return bins / total, unmeasured / total


def share_between(parts, low, high):
    """float: share of all area over walls of at least `low` and less than `high`, mm."""
    chosen = sum(len(part.places) * part.map.areas[between(part.map, low, high)].sum() for part in parts)
    return float(chosen / sum(len(part.places) * part.map.areas.sum() for part in parts))


def between(shown, low, high):
    """ndarray of shape (m,), bool: facets over walls of at least `low` and less than `high`, mm."""
    with np.errstate(invalid="ignore"):
        return (shown.thickness >= low) & (shown.thickness < high)


def range_of(parts):
    """Least and greatest thickness that is shown, mm; None where nothing was measured."""
    values = [part.map.thickness[part.map.measured] for part in parts]
    values = [each for each in values if len(each)]
    if not values:
        return None
    return float(min(each.min() for each in values)), float(max(each.max() for each in values))


def face_summaries(shown, threshold):
    """Walls under each B-Rep face.

    Parameters
    ----------
    shown : ThicknessMap
    threshold : float, mm
        Area over walls under it is thin.

    Returns
    -------
    list of FaceSummary
        By face.
    """
    order = np.lexsort([shown.thickness, shown.face])  # nan comes last
    faces, start = np.unique(shown.face[order], return_index=True)
    return [_face(shown, int(face), rows, threshold)
            for face, rows in zip(faces, np.split(order, start[1:]))]


def _face(shown, face, rows, threshold):
    area, thickness = shown.areas[rows], shown.thickness[rows]
    total = max(float(area.sum()), np.finfo(float).tiny)
    measured = int(np.isfinite(thickness).sum())
    thinnest = median = None
    if measured:
        cumulative = np.cumsum(area[:measured])
        middle = min(np.searchsorted(cumulative, 0.5 * cumulative[-1]), measured - 1)
        thinnest, median = float(thickness[0]), float(thickness[middle])
    thin = int(np.searchsorted(thickness[:measured], threshold))
    return FaceSummary(face, total, thinnest, median, float(area[:thin].sum()) / total,
                       float(area[measured:].sum()) / total)
