# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part that is shell and solid: triangles on the middle of its walls, tetrahedra in the rest, tied where it was cut."""

from dataclasses import dataclass

import numpy as np

SIDES = ((0, 1, 3), (1, 2, 4), (2, 0, 5))
"""Nodes of each side of a triangle of second order: its ends, and what lies between them."""

IN_FACE = 0.002
"""Distance by the length of a side up to which CalculiX ties a node beside its face, which it makes straight facets of."""


@dataclass(frozen=True)
class SolidMesh:
    """Tetrahedra of second order, and how they are tied to a shell.

    Attributes
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int64, shape (n, 10)
        Rows of the points, in the order of Gmsh.
    tied : ndarray of int64, shape (k,)
        Rows of the points that lie on cuts.
    sides : ndarray of int64, shape (m, 2)
        Triangles of the shell that end at cuts, and which of their `SIDES` does.
    volume_share : float
        Of the part.
    """

    points: np.ndarray
    tetrahedra: np.ndarray
    tied: np.ndarray
    sides: np.ndarray
    volume_share: float


def sides_on(triangles, is_on):
    """Sides of triangles of second order all of whose nodes are marked.

    Returns an ndarray of int64, shape (m, 2): rows of the triangles, and numbers in `SIDES`.

    Parameters
    ----------
    triangles : ndarray of int64, shape (n, 6)
    is_on : ndarray of bool, shape (v,)
        By node.
    """
    found = [np.column_stack([rows, np.full(len(rows), number)]) for number, nodes in enumerate(SIDES)
             for rows in [np.flatnonzero(is_on[triangles[:, nodes]].all(axis=1))]]
    return np.concatenate(found)


def area_of_sides(shell, sides):
    """Area of the cross section of a shell over some of its sides: length by thickness, float, mm2.

    Parameters
    ----------
    shell : ShellMesh
        Of second order.
    sides : ndarray of int64, shape (m, 2)
        As of `sides_on`.
    """
    rows, numbers = sides.T
    start, end, middle = (shell.points[shell.triangles[rows, np.array(SIDES)[numbers, column]]] for column in range(3))
    # An arc is longer than its chord by four thirds of what its middle adds.
    chord = np.linalg.norm(end - start, axis=1)
    halves = np.linalg.norm(middle - start, axis=1) + np.linalg.norm(end - middle, axis=1)
    return float((chord + 4.0 / 3.0 * (halves - chord)) @ shell.thickness[rows])


def reached_by(shell, sides, points):
    """Which points on a cut the wall reaches that ends there: ndarray of bool, shape (k,).

    CalculiX ties these. Of a round wall, it leaves out those on the outside between the nodes of the shell.

    Parameters
    ----------
    shell : ShellMesh
        Of second order.
    sides : ndarray of int64, shape (m, 2)
        As of `sides_on`.
    points : ndarray of shape (k, 3), mm
    """
    rows, numbers = sides.T
    start, end, middle = (shell.points[shell.triangles[rows, np.array(SIDES)[numbers, column]]] for column in range(3))
    found = np.zeros(len(points), dtype=bool)
    for one, other in ((start, middle), (middle, end)):
        way = other - one
        length = np.linalg.norm(way, axis=1)
        away = points[:, None] - one
        along = np.clip(np.einsum("kij,ij->ki", away, way) / length ** 2, 0.0, 1.0)
        distance = np.linalg.norm(away - along[..., None] * way, axis=2)
        found |= (distance <= 0.5 * shell.thickness[rows] + IN_FACE * length).any(axis=1)
    return found
