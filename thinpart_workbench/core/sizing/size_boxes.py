# SPDX-License-Identifier: LGPL-2.1-or-later
"""The size field as boxes with a size at each corner, which mesh generators interpolate: fine where it is small only."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ..tolerances import TOLERANCES

FEWEST = 4
"""Points within the part from which on a cube is known."""

OUTSIDE = 3.0
"""Distance from the part, in mean distances of the points in it, from which on a cube lies outside."""

MOST_BOXES = 150_000
"""Boxes stay larger where there would be more."""

_ROOT = 4
_CORNERS = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
_CHILDREN = np.array([[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
_HALF_DIAGONAL = 0.5 * np.sqrt(3.0)


@dataclass(frozen=True)
class SizeBoxes:
    """Cubes that fill the surroundings of a part.

    Attributes
    ----------
    corners : ndarray of shape (n, 8, 3), mm
        In the order of a hexahedron: the four below counter-clockwise, then those above them.
    sizes : ndarray of shape (n, 8), mm
        Element sizes at the corners.
    """

    corners: np.ndarray
    sizes: np.ndarray


def size_boxes(field, low, high, inner, most=MOST_BOXES):
    """Divide a box into cubes, fine where the size changes within the part: SizeBoxes.

    A cube is divided until it is no larger than its least element: the size changes by no more than `field.slope` by length,
    so that interpolating errs by a small share. It stays whole before, where all of the part in it has about one size: its
    corners, which may lie outside, get that size. Outside of the part nothing is resolved.

    Parameters
    ----------
    field : SizeField
    low, high : array_like of shape (3,), mm
        Of the part.
    inner : ndarray of shape (n, 3), mm
        Points spread over the inside of the part.
    most : int
        Greatest number of cubes.
    """
    low, high = np.asarray(low, dtype=np.float64), np.asarray(high, dtype=np.float64)
    side = max(float((high - low).max()), field.least) * 1.02
    origin = 0.5 * (low + high - side)
    sizes, tree = field.at(inner), cKDTree(inner)
    spacing = _spacing(tree, inner)
    side /= _ROOT
    cell = np.stack(np.meshgrid(*[np.arange(_ROOT)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    done, count = [], 0
    while len(cell):
        corner = origin + cell * side
        middle = field.at(corner + 0.5 * side)
        off = field.slope * side * _HALF_DIAGONAL
        has_points, least, greatest = _sizes_within(cell, np.floor((inner - origin) / side).astype(np.int64), sizes)
        away = tree.query(corner + 0.5 * side, distance_upper_bound=4.0 * side + OUTSIDE * spacing)[0]
        split = (side > np.maximum(middle - off, field.least)) & (middle - off < field.global_size)
        split &= ~(has_points & (greatest <= TOLERANCES.alike * least))  # alike as far as the cube lies in the part
        split &= away < side * _HALF_DIAGONAL + OUTSIDE * spacing
        if count + len(cell) + 7 * np.count_nonzero(split) > most:
            split[:] = False
        whole = ~split
        done.append((corner[whole], np.full(np.count_nonzero(whole), side),
                     np.where(has_points, greatest, np.inf)[whole]))
        count += np.count_nonzero(whole)
        side *= 0.5
        cell = (2 * cell[split][:, None] + _CHILDREN).reshape(-1, 3)
    corner, sides, greatest = (np.concatenate(column) for column in zip(*done))
    corners = corner[:, None] + _CORNERS * sides[:, None, None]
    # Neighbours share corners: ask for each once.
    step = np.rint((corners.reshape(-1, 3) - origin) / (0.5 * sides.min())).astype(np.int64)
    _, first, back = np.unique(step, axis=0, return_index=True, return_inverse=True)
    at_corners = field.at(corners.reshape(-1, 3)[first])[back.ravel()].reshape(-1, 8)
    return SizeBoxes(corners, np.minimum(at_corners, greatest[:, None]))


def _spacing(tree, points):
    """Mean distance of neighbouring points."""
    some = points[np.linspace(0, len(points) - 1, min(len(points), 1000)).astype(np.int64)]
    return float(np.mean(tree.query(some, k=min(4, len(points)))[0][:, -1]))


def _sizes_within(cells, cell_of_point, sizes):
    """Whether cubes have enough points in them, and the least and greatest size at those: three ndarrays."""
    # One number for the three indices of a cube; no index is larger than the last cube that was made.
    span = int(max(cells.max(), cell_of_point.max())) + 2
    own = np.clip(cell_of_point, -1, span - 1) + 1
    key = (own[:, 0] * (span + 1) + own[:, 1]) * (span + 1) + own[:, 2]
    order = np.argsort(key, kind="stable")
    found, start = np.unique(key[order], return_index=True)
    count = np.diff(np.append(start, len(key)))
    low, high = np.minimum.reduceat(sizes[order], start), np.maximum.reduceat(sizes[order], start)
    wanted = ((cells[:, 0] + 1) * (span + 1) + cells[:, 1] + 1) * (span + 1) + cells[:, 2] + 1
    row = np.minimum(np.searchsorted(found, wanted), len(found) - 1)
    is_known = (found[row] == wanted) & (count[row] >= FEWEST)
    return is_known, low[row], high[row]
