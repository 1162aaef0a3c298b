"""What thickness maps come to: area over ranges of thickness, and the walls under each face."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

MOST_OF_THE_AREA = 0.9
"""Share of the measured area that a map's colours tell apart at first."""


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
        Ascending; the last bin includes its upper edge. Rounded as the maps are, to float32: so a sheet of
        0.7 mm is in the bin that begins there.

    Returns
    -------
    shares : ndarray of shape (k,)
    unmeasured : float
        Both of all area.
    """
    edges = np.asarray(edges, dtype=np.float32)
    bins, unmeasured, total = np.zeros(len(edges) - 1), 0.0, 0.0
    for part in parts:
        shown, times = part.map, len(part.places)
        measured = shown.measured
        # As np.histogram does it, without sorting.
        place = np.searchsorted(edges, shown.thickness, side="right") - 1
        place[shown.thickness == edges[-1]] = len(bins) - 1
        inside = measured & (place >= 0) & (place < len(bins))
        bins += times * np.bincount(place[inside], shown.areas[inside], minlength=len(bins))
        unmeasured += times * shown.areas[~measured].sum()
        total += times * shown.areas.sum()
    return bins / total, unmeasured / total


def share_between(parts, low, high):
    """float: share of all area over walls of at least `low` and less than `high`, mm."""
    chosen = sum(len(part.places) * part.map.areas[between(part.map, low, high)].sum() for part in parts)
    return float(chosen / sum(len(part.places) * part.map.areas.sum() for part in parts))


def between(shown, low, high):
    """ndarray of shape (m,), bool: facets over walls of at least `low` and less than `high`, mm."""
    return are_between(shown.thickness, low, high)


def are_between(thickness, low, high):
    """Which thicknesses, rounded as the maps are, are at least `low` and less than `high`, mm; nan never is."""
    thickness = np.asarray(thickness, dtype=np.float32)
    with np.errstate(invalid="ignore"):
        return (thickness >= np.float32(low)) & (thickness < np.float32(high))


def range_of(parts):
    """Least and greatest thickness that is shown, mm; None where nothing was measured."""
    ends = [part.map.ends for part in parts if part.map.ends is not None]
    return (min(low for low, _ in ends), max(high for _, high in ends)) if ends else None


def telling_range(parts):
    """The range of thickness in which most of the surface can be told apart, mm; None where nothing was measured.

    From the thinnest wall to that under which `MOST_OF_THE_AREA` of the measured area lies, or to twice the thinnest:
    the length of a cup, seen through its rim, would leave one colour to its wall.
    """
    ends = range_of(parts)
    if ends is None:
        return None
    thickness = np.concatenate([part.map.thickness[part.map.measured] for part in parts])
    area = np.concatenate([len(part.places) * part.map.areas[part.map.measured] for part in parts])
    order = np.argsort(thickness)
    cumulative = np.cumsum(area[order])
    high = float(thickness[order[np.searchsorted(cumulative, MOST_OF_THE_AREA * cumulative[-1])]])
    return ends[0], min(ends[1], max(high, 2.0 * ends[0]))


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
    area, thickness = shown.areas[order], shown.thickness[order]
    face = shown.face[order]
    start = np.flatnonzero(np.concatenate([[True], face[1:] != face[:-1]]))
    faces = face[start]
    measured = np.isfinite(thickness)
    total = np.maximum(np.add.reduceat(area, start), np.finfo(float).tiny)
    known = np.add.reduceat(np.where(measured, area, 0.0), start)
    count = np.add.reduceat(measured.astype(np.int64), start)
    thin = np.add.reduceat(np.where(are_between(thickness, 0.0, threshold), area, 0.0), start)
    cumulative = np.cumsum(area)
    # The first of each face's facets up to which half of its measured area lies.
    middle = np.searchsorted(cumulative, cumulative[start] - area[start] + 0.5 * known)
    middle = np.clip(middle, start, start + np.maximum(count, 1) - 1)
    return [
        FaceSummary(face, whole, least if some else None, median if some else None, part / whole,
                    max(0.0, 1.0 - seen / whole))
        for face, whole, least, median, some, part, seen in zip(
            faces.tolist(), total.tolist(), thickness[start].tolist(), thickness[middle].tolist(),
            count.tolist(), thin.tolist(), known.tolist())
    ]
