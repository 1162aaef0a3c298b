# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tetrahedra of second order: whether curved ones are inside out, and the fewest sides made straight so that none is."""

import numpy as np

SIDES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
"""Corners at the ends of the sides whose middles are the nodes 4 to 9, in the order of Gmsh."""

LEAST = 0.05
"""Least determinant of the Jacobian in an element, by that of the same one with straight sides. At 0 it is inside out there,
which solvers refuse."""

_INNER = 0.1381966011250105  # (5 - sqrt 5) / 20, of the four points at which solvers integrate
_ROUNDS = 20


def _slopes():
    """Derivatives of the ten shape functions by the first three coordinates, at all places that are checked: (14, 10, 3)."""
    corner = np.eye(4)
    places = np.concatenate([corner, [0.5 * (corner[one] + corner[other]) for one, other in SIDES],
                             np.where(corner > 0.0, 1.0 - 3.0 * _INNER, _INNER)])
    slopes = np.zeros((len(places), 10, 4))
    slopes[:, range(4), range(4)] = 4.0 * places - 1.0
    for number, (one, other) in enumerate(SIDES, start=4):
        slopes[:, number, one], slopes[:, number, other] = 4.0 * places[:, other], 4.0 * places[:, one]
    return slopes[:, :, 1:] - slopes[:, :, :1]


_SLOPES = _slopes()


def least_jacobians(points, tetrahedra):
    """Least determinant of the Jacobian in each element by that with straight sides: ndarray of shape (n,).

    At its nodes and at the four points at which solvers integrate. 1 for an element with straight sides; an element without
    volume counts as 0.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 10)
        In the order of Gmsh.
    """
    nodes = points[tetrahedra] - points[tetrahedra[:, :1]]
    straight = np.linalg.det(nodes[:, 1:4])
    least = np.full(len(tetrahedra), np.inf)
    for slopes in _SLOPES:
        least = np.minimum(least, np.linalg.det(np.einsum("nij,ik->nkj", nodes, slopes))
                           / np.where(straight == 0.0, np.inf, straight))
    return least


def straightened(points, tetrahedra):
    """Points of which the middles of sides lie straight between the ends, where an element would be inside out else.

    Returns `points` (ndarray of shape (v, 3), mm) and `moved` (ndarray of shape (k,), int64; which ones lie elsewhere now).
    Only elements that have no volume with straight sides either stay as they are.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 10)
        In the order of Gmsh.
    """
    found, checked = points.copy(), np.arange(len(tetrahedra))
    is_moved = np.zeros(len(points), dtype=bool)
    ends = tetrahedra[:, np.array(SIDES)]
    for _ in range(_ROUNDS):
        bad = checked[least_jacobians(found, tetrahedra[checked]) < LEAST]
        middles, own = tetrahedra[bad, 4:].ravel(), ends[bad].reshape(-1, 2)
        new = ~is_moved[middles]
        if not new.any():
            break
        found[middles] = found[own].mean(axis=1)
        is_moved[middles] = True
        # Elements that share a side with these have another shape now.
        checked = np.flatnonzero(is_moved[tetrahedra[:, 4:]].any(axis=1))
    return found, np.flatnonzero(is_moved)
