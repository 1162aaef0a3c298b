# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles that a solver takes as shells: none that is as good as a line, none of which its wedge is inside out."""

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import connected_components

SHORTEST = 0.1
"""Side of a triangle by the thickness of its wall below which its ends become one node: a bevel at the rim of a wall."""

LEAST_JACOBIAN = 0.1
"""Least determinant of the Jacobian in a triangle, half of the thickness to either side of it, by that of its corners: a
solver makes a wedge of it. Below, its sides become straight, as at small holes, or else the ends of its shortest one become
one node, as at bends with a radius of less than half of the thickness."""

SMOOTH = np.cos(np.radians(20.0))
"""Cosine of the angle between triangles up to which they have one normal at a node, as in CalculiX."""

LOOSE = 0.02
"""Share of the area that groups of triangles which hang on by a node may have to be left out."""

ROUNDS = 12
"""Of mending, at most."""

_SIDES = ((0, 1), (1, 2), (2, 0))

_PLACES = ((0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5), (1 / 6, 1 / 6), (2 / 3, 1 / 6), (1 / 6, 2 / 3))
"""Where the Jacobian is looked at: the nodes and the points of integration."""


def sound_triangles(points, triangles, thickness):
    """Leave out what is no triangle, and mend what would be inside out.

    Returns `points` (ndarray of shape (v, 3), mm), `triangles` (ndarray of int64, shape (m, 3) or (m, 6)) and `kept`
    (ndarray of int64: the rows of the triangles that are left).

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of int64, shape (n, 3) or (n, 6)
        Corners, then the middles of the sides 0-1, 1-2 and 2-0.
    thickness : ndarray of shape (n,), mm
        Of the wall of each triangle.
    """
    mesh = _Triangles(points.copy(), triangles.copy(), np.asarray(thickness))
    for _ in range(ROUNDS):
        if not mesh.join(*mesh.sides_below(SHORTEST)):
            break
    for _ in range(ROUNDS):
        bad = mesh.inside_out()
        if not len(bad):
            break
        mesh.straighten(bad)
        mesh.join(*mesh.shortest_sides(mesh.inside_out()))
    mesh.leave_out_loose()
    return mesh.points, mesh.triangles, mesh.kept


class _Triangles:
    """Triangles that are mended in place."""

    def __init__(self, points, triangles, thickness):
        self.points, self.triangles, self._thickness = points, triangles, thickness
        self.kept = np.arange(len(triangles))

    def sides_below(self, share):
        """Ends and lengths of the sides that are shorter than a share of the thickness."""
        ends = np.concatenate([self.triangles[:, side] for side in _SIDES])
        length = self._length(ends)
        short = length < share * np.tile(self._thickness[self.kept], 3)
        return ends[short], length[short]

    def shortest_sides(self, rows):
        """Ends and length of the shortest side of some triangles."""
        ends = self.triangles[rows][:, np.array(_SIDES)]
        length = self._length(ends.reshape(-1, 2)).reshape(-1, 3)
        own = np.arange(len(rows)), length.argmin(axis=1)
        return ends[own], length[own]

    def _length(self, ends):
        return np.linalg.norm(self.points[ends[:, 0]] - self.points[ends[:, 1]], axis=1)

    def join(self, ends, length):
        """Make one node of the ends of sides, the shortest first; a node takes part once. What is no triangle then goes.

        Returns whether there was any.
        """
        becomes = np.arange(len(self.points))
        taken: set = set()
        for first, second in ends[np.argsort(length, kind="stable")].tolist():
            if first not in taken and second not in taken:
                taken.update((first, second))
                self.points[first] = 0.5 * (self.points[first] + self.points[second])
                becomes[second] = first
        if not taken:
            return False
        self.triangles[:, :3] = becomes[self.triangles[:, :3]]
        corners = np.sort(self.triangles[:, :3], axis=1)
        is_left = (np.diff(corners, axis=1) > 0).all(axis=1)
        is_left[is_left] = _is_first(corners[is_left])  # what folded onto its neighbour is there once
        self.triangles, self.kept = self.triangles[is_left], self.kept[is_left]
        if self.triangles.shape[1] == 6:
            self._share_middles(np.unique(becomes[list(taken)]))
        return True

    def _share_middles(self, joined):
        """Give triangles that share a side since its ends were joined one middle, half-way between theirs."""
        ends = np.sort(np.concatenate([self.triangles[:, side] for side in _SIDES]), axis=1)
        middles = self.triangles[:, 3:].T.ravel()
        own = np.flatnonzero(np.isin(ends, joined).any(axis=1))
        if not len(own):
            return
        number = np.unique(ends[own], axis=0, return_inverse=True)[1].ravel()
        first = np.full(number.max() + 1, len(self.points))
        np.minimum.at(first, number, middles[own])
        count = np.bincount(number)
        self.points[first] = np.column_stack(
            [np.bincount(number, self.points[middles[own], axis]) / count for axis in range(3)])
        middles[own] = first[number]
        self.triangles[:, 3:] = middles.reshape(3, -1).T

    def straighten(self, rows):
        """Put the middles of the sides of some triangles half-way between their ends."""
        if self.triangles.shape[1] == 6:
            for number, side in enumerate(_SIDES):
                self.points[self.triangles[rows, 3 + number]] = self.points[self.triangles[rows][:, side]].mean(axis=1)

    def inside_out(self):
        """Triangles of which a solver's wedge would be inside out: ndarray of int64."""
        least = least_jacobians(self.points, self.triangles, self._thickness[self.kept])
        return np.flatnonzero(least < LEAST_JACOBIAN)


    def leave_out_loose(self):
        """Leave out small groups of triangles that share no side with the largest one: at a single node, they would turn."""
        number = groups_by_sides(self.triangles)
        a, b, c = self.points[self.triangles[:, :3].T]
        area = np.bincount(number, np.linalg.norm(np.cross(b - a, c - a), axis=1))
        is_small = area < LOOSE * area.sum()
        if is_small.any() and area[is_small].sum() < LOOSE * area.sum():
            self.triangles, self.kept = self.triangles[~is_small[number]], self.kept[~is_small[number]]


def groups_by_sides(triangles):
    """Number of the group of each triangle, from 0; those that share a side are in one: ndarray of shape (n,)."""
    corners = triangles[:, :3]
    ends = np.sort(np.concatenate([corners[:, side] for side in _SIDES]), axis=1)
    side = np.unique(ends, axis=0, return_inverse=True)[1].ravel()
    own = np.tile(np.arange(len(corners)), 3)
    graph = coo_matrix((np.ones(len(own)), (own, len(corners) + side)), shape=(len(corners) + side.max(initial=-1) + 1,) * 2)
    return np.unique(connected_components(graph, directed=False)[1][:len(corners)], return_inverse=True)[1].ravel()


def _is_first(rows):
    """Which rows are the first of their kind: ndarray of bool."""
    found = np.zeros(len(rows), dtype=bool)
    found[np.unique(rows, axis=0, return_index=True)[1]] = True
    return found


def least_jacobians(points, triangles, thickness):
    """Least determinant of the Jacobian in the wedges of triangles, by that of the corners: ndarray of shape (n,).

    At the nodes and the points of integration, half of the thickness to either side, as CalculiX makes wedges of shells:
    along normals at the nodes, the mean of those of the triangles that meet there smoothly (user's manual 2.20, 6.2.14).

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of int64, shape (n, 3) or (n, 6)
    thickness : ndarray of shape (n,), mm
    """
    width = triangles.shape[1]
    places = [((r, s), *_slopes(r, s, width)) for r, s in _PLACES[:width] + _PLACES[6:]]
    nodes = points[triangles]
    spanned = np.stack([_across(nodes, *slopes[1:]) for slopes in places[:width]], axis=1)
    normals = _smooth_normals(triangles, spanned)
    a, b, c = nodes[:, :3].transpose(1, 0, 2)
    double = np.maximum(np.linalg.norm(np.cross(b - a, c - a), axis=1), 1e-300)
    away = 0.5 * thickness[:, None, None] * normals
    found = np.full(len(triangles), np.inf)
    for (r, s), *slopes in places:
        normal = np.einsum("j,njk->nk", _shares(r, s, width), normals)
        normal /= np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
        for side in (nodes - away, nodes + away):
            found = np.minimum(found, np.einsum("nk,nk->n", _across(side, *slopes), normal) / double)
    return found


def _across(nodes, along_r, along_s):
    """The vector product of the two derivatives of the place in triangles: ndarray of shape (n, 3)."""
    return np.cross(np.einsum("j,njk->nk", along_r, nodes), np.einsum("j,njk->nk", along_s, nodes))


def _shares(r, s, width):
    """The shape functions of a triangle."""
    t = 1.0 - r - s
    if width == 3:
        return np.array([t, r, s])
    return np.array([t * (2.0 * t - 1.0), r * (2.0 * r - 1.0), s * (2.0 * s - 1.0), 4.0 * r * t, 4.0 * r * s, 4.0 * s * t])


def _slopes(r, s, width):
    """Their derivatives by the two coordinates."""
    t = 1.0 - r - s
    if width == 3:
        return np.array([-1.0, 1.0, 0.0]), np.array([-1.0, 0.0, 1.0])
    return (np.array([1.0 - 4.0 * t, 4.0 * r - 1.0, 0.0, 4.0 * (t - r), 4.0 * s, -4.0 * s]),
            np.array([1.0 - 4.0 * t, 0.0, 4.0 * s - 1.0, -4.0 * r, 4.0 * r, 4.0 * (t - s)]))


def _smooth_normals(triangles, spanned):
    """Unit normals at the nodes of triangles, of those that meet there smoothly: ndarray of the shape of `spanned`."""
    own = (spanned / np.maximum(np.linalg.norm(spanned, axis=2), 1e-300)[:, :, None]).reshape(-1, 3)
    node = triangles.ravel()
    at = csr_matrix((np.ones(len(node)), (node, np.arange(len(node)))), shape=(node.max() + 1, len(node)))
    row, other = at[node].nonzero()
    cosine = np.einsum("ij,ij->i", own[row], own[other])
    smooth = np.abs(cosine) > SMOOTH
    row, other, sign = row[smooth], other[smooth], np.sign(cosine[smooth])
    found = np.column_stack([np.bincount(row, sign * own[other, axis], len(node)) for axis in range(3)])
    return (found / np.maximum(np.linalg.norm(found, axis=1), 1e-300)[:, None]).reshape(spanned.shape)
