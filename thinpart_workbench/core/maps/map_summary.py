# SPDX-License-Identifier: LGPL-2.1-or-later
"""Summaries of thickness maps: area by range of thickness, and the walls under each face."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

TYPICAL = 0.02, 0.98
"""Shares of the measured area below which the initial range of a map's colours begins and ends."""

MOST_OF_THE_AREA, OUTLYING = 0.9, 1.5
"""Where the range would end at more than so many times the thickness below which most of the area lies, what lies beyond is
not walls but rims, whose rays run along the wall: the range ends at that thickness."""

ONE_THICKNESS = 1.01
"""Up to this ratio of the ends of a range a part has one thickness: colours would tell errors from errors."""


@dataclass(frozen=True)
class FaceSummary:
    """Walls under one B-Rep face, computed from the facets of a thickness map.

    Attributes
    ----------
    face : int
        From 0.
    area : float, mm2
    thinnest, median : float or None, mm
        None where nothing was measured.
    thin_share, unmeasured_share : float
        Of the face's area.
    thinnest_facet : int
        The facet over the thinnest wall; any where nothing was measured.
    """

    face: int
    area: float
    thinnest: Optional[float]
    median: Optional[float]
    thin_share: float
    unmeasured_share: float
    thinnest_facet: int


def area_by_thickness(parts, edges):
    """Compute the share of the area in each bin of thickness.

    Parameters
    ----------
    parts : list of MappedPart
        Each counts once per occurrence.
    edges : ndarray of shape (k + 1,), mm
        Ascending; the last bin includes its upper edge. The edges are rounded to float32 like the maps, so that a
        sheet of 0.7 mm is in the bin that begins at 0.7.

    Returns
    -------
    shares : ndarray of shape (k,)
    unmeasured : float
        Share of the area where nothing was measured. All shares refer to the area of all occurrences.
    """
    edges = np.asarray(edges, dtype=np.float32)
    bins, unmeasured, total = np.zeros(len(edges) - 1), 0.0, 0.0
    for part in parts:
        thickness_map, occurrences = part.map, len(part.matrices)
        measured = thickness_map.measured
        # Same bins as np.histogram, without sorting.
        bin_index = np.searchsorted(edges, thickness_map.thickness, side="right") - 1
        bin_index[thickness_map.thickness == edges[-1]] = len(bins) - 1
        inside = measured & (bin_index >= 0) & (bin_index < len(bins))
        bins += occurrences * np.bincount(bin_index[inside], thickness_map.areas[inside], minlength=len(bins))
        unmeasured += occurrences * thickness_map.areas[~measured].sum()
        total += occurrences * thickness_map.areas.sum()
    return bins / total, unmeasured / total


def share_between(parts, low, high):
    """float: share of all area over walls that are at least `low` and less than `high` mm thick."""
    chosen = sum(len(part.matrices) * part.map.areas[between(part.map, low, high)].sum() for part in parts)
    return float(chosen / sum(len(part.matrices) * part.map.areas.sum() for part in parts))


def share_of(parts, chosen):
    """float: share of all area on some facets: for each MappedPart, an ndarray of shape (m,), bool."""
    area = sum(len(part.matrices) * part.map.areas[own].sum() for part, own in zip(parts, chosen))
    return float(area / sum(len(part.matrices) * part.map.areas.sum() for part in parts))


def between(thickness_map, low, high):
    """ndarray of shape (m,), bool: facets over walls that are at least `low` and less than `high` mm thick."""
    return are_between(thickness_map.thickness, low, high)


def are_between(thickness, low, high):
    """ndarray of bool: which thicknesses, rounded to float32, are at least `low` and less than `high` mm; nan never is."""
    thickness = np.asarray(thickness, dtype=np.float32)
    with np.errstate(invalid="ignore"):
        return (thickness >= np.float32(low)) & (thickness < np.float32(high))


def thickness_range(parts):
    """Least and greatest thickness of all parts, mm; None where nothing was measured."""
    ends = [part.map.ends for part in parts if part.map.ends is not None]
    return (min(low for low, _ in ends), max(high for _, high in ends)) if ends else None


def typical_range(parts):
    """The range of thickness that most of the surface has, mm; None where nothing was measured.

    It goes from the thinnest wall that the records name, which has some extent and is confirmed, or else from the 2nd
    percentile of the area, to the 98th, at least to twice its beginning. From the least thickness of all facets, half of the
    colours would be for the edge of a tapered letter; up to the greatest, a cup would get one colour for all of its wall,
    because a ray from its rim measures the length of the cup (see `OUTLYING`). Both ends are equal where a part has one
    thickness (see `ONE_THICKNESS`).
    """
    ends = thickness_range(parts)
    if ends is None:
        return None
    thickness = np.concatenate([part.map.thickness[part.map.measured] for part in parts])
    area = np.concatenate([len(part.matrices) * part.map.areas[part.map.measured] for part in parts])
    order = np.argsort(thickness)
    cumulative = np.cumsum(area[order])
    low, most, high = (float(thickness[order[min(np.searchsorted(cumulative, share * cumulative[-1]), len(order) - 1)]])
                       for share in (TYPICAL[0], MOST_OF_THE_AREA, TYPICAL[1]))
    high = most if high > OUTLYING * most else high
    low = max(ends[0], min((_thinnest_wall(part) for part in parts), default=0.0) or low)
    high = max(min(ends[1], max(high, 2.0 * low)), low)
    return (high, high) if high < ONE_THICKNESS * low else (low, high)


def _thinnest_wall(part):
    """Of the record, mm; 0 where it names none."""
    return part.record.get("descriptors", {}).get("thickness_mm", {}).get("min") or 0.0


def face_summaries(thickness_map, threshold):
    """Summarise the walls under each B-Rep face: list of FaceSummary, in the order of the faces.

    Parameters
    ----------
    thickness_map : ThicknessMap
    threshold : float, mm
        Area over walls thinner than this is thin.
    """
    order = np.lexsort([thickness_map.thickness, thickness_map.face])  # nan comes last
    area, thickness = thickness_map.areas[order], thickness_map.thickness[order]
    face = thickness_map.face[order]
    start = np.flatnonzero(np.concatenate([[True], face[1:] != face[:-1]]))
    faces = face[start]
    measured = np.isfinite(thickness)
    total = np.maximum(np.add.reduceat(area, start), np.finfo(float).tiny)
    known = np.add.reduceat(np.where(measured, area, 0.0), start)
    count = np.add.reduceat(measured.astype(np.int64), start)
    thin = np.add.reduceat(np.where(are_between(thickness, 0.0, threshold), area, 0.0), start)
    cumulative = np.cumsum(area)
    # Median: the first facet of each face at which half of its measured area is reached.
    middle = np.searchsorted(cumulative, cumulative[start] - area[start] + 0.5 * known)
    middle = np.clip(middle, start, start + np.maximum(count, 1) - 1)
    return [
        FaceSummary(face, face_area, least if count_measured else None, median if count_measured else None,
                    thin_area / face_area, max(0.0, 1.0 - measured_area / face_area), facet)
        for face, face_area, least, median, count_measured, thin_area, measured_area, facet in zip(
            faces.tolist(), total.tolist(), thickness[start].tolist(), thickness[middle].tolist(),
            count.tolist(), thin.tolist(), known.tolist(), order[start].tolist())
    ]
