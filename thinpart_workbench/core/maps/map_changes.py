# SPDX-License-Identifier: LGPL-2.1-or-later
"""What became thinner between two thickness maps of a part that was changed meanwhile."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from .facet_refinement import side_keys

LEAST_LOSS = 0.03
"""Share of its thickness that a wall loses at least; less is within what maps of one part differ by."""

LEAST_AREA = 5e-4
"""Share of the surface below which a thinner place is no wall, but the rim of one."""

_ASIDE = 4.0
"""Sides of a facet by which its counterpart may lie aside; along the normal, it may move by its wall."""

_ALIKE = 0.9
"""Least cosine between the normals of facets that are counterparts."""


@dataclass(frozen=True)
class ThinnerWall:
    """A wall that is thinner than it was.

    Attributes
    ----------
    before, now : float, mm
        Its median thickness.
    least : float, mm
        Where it is thinnest now.
    area : float, mm2
        Of what is thinner, both sides.
    ends : tuple of ndarray of shape (3,), mm
        Both ends of the wall where it is thinnest now, in the coordinates of the document.
    faces : tuple of int
        Numbers of its B-Rep faces now, from 0.
    """

    before: float
    now: float
    least: float
    area: float
    ends: tuple
    faces: tuple


def thinner_walls(before, now):
    """Walls that became thinner, the one that lost the greatest share first: list of ThinnerWall.

    Each facet is compared with the one of before that is nearest and looks the same way. So a wall is found whether one of
    its sides moved or both; what was not there before has nothing to be compared with, and is left out.

    Parameters
    ----------
    before, now : ThicknessMap
        In the same coordinates, by the same measure.
    """
    was = _thickness_before(before, now)
    with np.errstate(invalid="ignore"):
        is_thinner = now.thickness < was * (1.0 - LEAST_LOSS)
    if not is_thinner.any():
        return []
    walls = _connected(now, is_thinner)
    found = []
    for number in range(walls.max() + 1):
        facets = np.flatnonzero(walls == number)
        areas = now.areas[facets]
        if areas.sum() < LEAST_AREA * now.areas.sum():
            continue
        thinnest = int(facets[np.argmin(now.thickness[facets])])
        middle = now.corners[thinnest].mean(axis=0) + now.origin
        _, opposite = now.wall_at(thinnest, middle)
        found.append(ThinnerWall(
            _median(was[facets], areas), _median(now.thickness[facets], areas), float(now.thickness[thinnest]),
            float(areas.sum()), (middle, opposite), tuple(np.unique(now.face[facets][now.face[facets] >= 0]).tolist())))
    return sorted(found, key=lambda wall: wall.now / wall.before)


def _thickness_before(before, now):
    """The thickness that the wall under each facet had before, ndarray of shape (m,); nan where it had none."""
    known = np.flatnonzero(before.measured)
    was = np.full(now.count, np.nan)
    if not len(known):
        return was
    # In the space of places and normals, so that the other side of a thin wall is far away.
    apart = float(np.linalg.norm(np.ptp(before.points, axis=0)))
    old, new = (np.concatenate([each.corners.mean(axis=1) + each.origin, apart * each.normals], axis=1)
                for each in (before, now))
    _, nearest = cKDTree(old[known]).query(new)
    nearest = known[nearest]
    normals = new[:, 3:] / apart
    away = new[:, :3] - old[nearest, :3]
    along = np.abs(np.einsum("ij,ij->i", away, normals))
    aside = np.sqrt(np.maximum(np.einsum("ij,ij->i", away, away) - along ** 2, 0.0))
    side = np.sqrt(2.0 * before.areas.sum() / max(len(known), 1))
    own = np.sqrt(2.0 * np.maximum(before.areas[nearest], now.areas))
    is_same = ((aside <= _ASIDE * np.maximum(own, side)) & (along <= before.thickness[nearest])
               & (np.einsum("ij,ij->i", normals, old[nearest, 3:] / apart) >= _ALIKE) & now.measured)
    was[is_same] = before.thickness[nearest[is_same]]
    return was


def _connected(now, chosen):
    """Which wall each chosen facet belongs to, -1 for the others.

    Those of one wall share a side and look the same way, or are opposite each other.
    """
    facets = np.flatnonzero(chosen)
    key = side_keys(now.facets[facets].astype(np.int64), len(now.points)).ravel()
    order = np.argsort(key, kind="stable")
    shared = np.flatnonzero(key[order[1:]] == key[order[:-1]])
    one, other = order[shared] // 3, order[shared + 1] // 3
    normals = now.normals[facets]
    is_flat = np.einsum("ij,ij->i", normals[one], normals[other]) >= _ALIKE
    middles = now.corners[facets].mean(axis=1)
    away, faced = cKDTree(middles).query(middles - now.thickness[facets, None] * normals)
    sees = np.flatnonzero((away <= np.sqrt(2.0 * now.areas[facets].max()))
                          & (np.einsum("ij,ij->i", normals, normals[faced]) <= -0.5))
    rows, columns = np.concatenate([one[is_flat], sees]), np.concatenate([other[is_flat], faced[sees]])
    _, labels = connected_components(coo_matrix((np.ones(len(rows)), (rows, columns)), (len(facets),) * 2), directed=False)
    walls = np.full(now.count, -1)
    walls[facets] = labels
    return walls


def _median(values, weights):
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(total, 0.5 * total[-1])])
