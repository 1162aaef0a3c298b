# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers of thickness maps: bars of a distribution, walls to look at, faces of a range of thickness."""

import numpy as np

from ...core.descriptors.distribution_bars import round_up
from ...core.length_unit import MILLIMETRE
from ...core.maps.map_summary import area_by_thickness, between, thickness_range, typical_range
from ...core.rigid_transform import transform_points
from ...freecad_adapter.objects.thickness_probes import moved_matrix

BARS = 40
"""Bars of a distribution, about."""

_BEYOND_MOST = 1.25
"""Factor by which the bars extend beyond the walls of most of the area; thicker walls share the last bar."""

_MOST_PLACES = 8
"""Occurrences of a part among which one is looked for where a wall can be seen."""


def thickness_bars(parts, threshold, unit=MILLIMETRE):
    """The surface of parts by thickness, in bars.

    Parameters
    ----------
    parts : list of MappedPart
    threshold : float, mm
        The bars reach beyond it.
    unit : LengthUnit, optional
        In which the width of a bar is a round number.

    Returns
    -------
    edges : ndarray of shape (k + 1,), mm
    shares : ndarray of shape (k,)
        Of all area; thicker walls count in the last bar.
    thickest : float, mm

    Examples
    --------
    >>> edges, shares, thickest = thickness_bars(parts_of(thickness), 1.0)
    >>> round(float(shares.sum()), 3)
    1.0
    """
    ends = thickness_range(parts)
    thickest = 1.0 if ends is None else ends[1]
    last = thickest
    if ends is not None:
        most = max(_BEYOND_MOST * typical_range(parts)[1], 2.0 * threshold)
        last = thickest if thickest <= 2.0 * most else most
    edges = bar_edges(last, unit)
    shares, _ = area_by_thickness(parts, np.append(edges[:-1], max(edges[-1], thickest)))
    return edges, shares, thickest


def bar_edges(last, unit=MILLIMETRE):
    """Edges of the bars from 0 to a thickness: ndarray of shape (k + 1,), mm.

    The bars are centred on multiples of a round width in the unit, so that a wall of 3 mm that measures 2.999 mm
    in places falls into one bar; the first bar is half as wide.

    Examples
    --------
    >>> bar_edges(150.0)[:3]
    array([0. , 2.5, 7.5])
    """
    width = unit.millimetres * round_up(unit.value(last) / BARS)
    return np.concatenate([[0.0], width * (np.arange(int(np.ceil(last / width + 0.5 - 1e-6))) + 0.5)])


def faces_between(part, low, high):
    """Numbers of the faces with walls from `low` to `high`, mm: list of int; `part` is a MappedPart.

    Examples
    --------
    >>> len(faces_between(parts_of(thickness)[0], 1.9, 2.1))  # both sides of the plate
    2
    """
    return np.unique(part.map.face[between(part.map, low, high)]).tolist()


def walls_between_faces(records):
    """Where walls are thinnest, once for each pair of faces.

    Parameters
    ----------
    records : dict of int to PartRecord
        By the number of the part.

    Returns
    -------
    list of (float, int, list)
        The thickness, mm, the number of the part, and both ends of the wall; the thinnest first.

    Examples
    --------
    >>> walls_between_faces({0: record})[0][0]
    8.0
    """
    found, known = [], set()
    for number, record in records.items():
        for face in sorted((face for face in record["faces"] if face["witness"] is not None),
                           key=lambda face: face["witness"]["distance"]):
            pair = number, frozenset((face["face"], face["witness"]["opposite_face"]))
            if pair not in known:  # each of the two sees the other
                known.add(pair)
                found.append((face["witness"]["distance"], number, face["witness"]["points"]))
    return sorted(found)


def wall_under_facet(part, facet):
    """Both ends of the wall under the middle of a facet of a MappedPart: pair of ndarray of shape (3,), mm.

    Examples
    --------
    >>> one, other = wall_under_facet(parts_of(thickness)[0], 0)
    >>> one.shape, other.shape
    ((3,), (3,))
    """
    middle = part.map.corners[facet].mean(axis=0) + part.map.origin
    return middle, part.map.wall_at(facet, middle)[1]


def places_of_wall(thickness, part, ends):
    """Both ends of a wall at the occurrences of its part, of the first ones where there are many.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        The map, which may have been moved.
    part : MappedPart
    ends : array_like of shape (2, 3), mm

    Returns
    -------
    list of tuple of ndarray of shape (3,), mm
        In the coordinates of the document.

    Examples
    --------
    >>> part, = parts_of(thickness)
    >>> len(places_of_wall(thickness, part, [[0, 0, 0], [0, 0, 2]]))
    1
    """
    moved = moved_matrix(thickness)
    return [tuple(transform_points(moved @ matrix, ends)) for matrix in part.matrices[:_MOST_PLACES]]
