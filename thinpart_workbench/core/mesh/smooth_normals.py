# SPDX-License-Identifier: LGPL-2.1-or-later
"""Normals of the smooth surface that the facets approximate."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ..columns import corners_of, dot

_AT_ONCE = 16384

CREASE = np.radians(20.0)
"""Facets that meet at less than this angle belong to one smooth surface, unless B-Rep faces are known."""

KNOWN_CREASE = np.radians(30.0)
"""Facets that are turned by less than this against a normal that the geometry has belong to its smooth surface: where OCC
keeps to the chord error only, as in the bend of a free-form tube, facets are turned by more than `CREASE`."""

MOST_BEND = np.radians(10.0)
"""Greatest angle between a facet and the smooth surface at its corners where B-Rep faces are not known: facets that are
turned by more may well be meant as they are, such as those of the flanks of a coarsely meshed thread."""


def smooth_patches(vertices, triangles, sides):
    """Divide a mesh into patches without a crease inside: ndarray of shape (n,), int64.

    Patch of each triangle, numbered by first appearance.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3)
        Welded and oriented.
    sides : tuple of two ndarrays of shape (e,), int64
        Their `shared_sides`.
    """
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    first, second = (side // 3 for side in sides)
    smooth = np.einsum("ij,ij->i", normals[first], normals[second]) > np.cos(CREASE)
    links = coo_matrix(
        (np.ones(smooth.sum()), (first[smooth], second[smooth])), shape=(len(triangles),) * 2
    )
    label = connected_components(links, directed=False)[1]
    _, appears, which = np.unique(label, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(appears))
    return rank[which.ravel()]


def normals_at(mesh, triangle, points):
    """Compute unit normals of the smooth surface at points on triangles: ndarray of shape (m, 3).

    Corner normals are those of the geometry, or else means over the facets of the same face, with the weights of Max (1999,
    doi:10.1080/10867651.1999.10487501), which are exact on a sphere. They are interpolated as by Phong (1975,
    doi:10.1145/360825.360839). On a plane they equal the normal of the facet. By these normals, the two walls of a
    tessellated shell are parallel, although their facets are not.

    Parameters
    ----------
    mesh : SurfaceMesh
    triangle : ndarray of shape (m,), int64
    points : ndarray of shape (m, 3), mm
        On those triangles, in the coordinates of the mesh.
    """
    normal = np.take(mesh.normals, triangle, axis=0)
    for chosen, own, weights in bent_points(mesh, triangle, points):
        normal[chosen] = interpolated_normals(mesh, own, weights)
    return normal


def bent_points(mesh, triangle, points):
    """Yield those of many points that lie on bent triangles, in portions.

    Yields `chosen` and `triangle` (ndarray of shape (k,), int64; which of the points, and their triangles) and `weights`
    (three ndarrays of shape (k,); their barycentric coordinates).

    Parameters
    ----------
    mesh : SurfaceMesh
    triangle : ndarray of shape (m,), int64
    points : ndarray of shape (m, 3), mm
    """
    bent = np.flatnonzero(mesh.is_bent[triangle])
    for start in range(0, len(bent), _AT_ONCE):
        chosen = bent[start:start + _AT_ONCE]
        own = triangle[chosen]
        yield chosen, own, barycentric(corners_of(mesh.vertex_columns, mesh.triangles[own]), points[chosen].T)


def interpolated_normals(mesh, triangle, weights):
    """ndarray of shape (k, 3): smooth unit normals at barycentric coordinates of triangles."""
    mean = sum(weight * np.take(corner, triangle, axis=1) for weight, corner in zip(weights, mesh.corner_normals))
    return (mean / np.sqrt(dot(mean, mean))).T


def barycentric(corners, points):
    """Three ndarrays of shape (m,): barycentric coordinates of points on or just beside triangles."""
    first = corners[:, 0]
    edge_u, edge_v, inside = corners[:, 1] - first, corners[:, 2] - first, points - first
    uu, uv, vv = dot(edge_u, edge_u), dot(edge_u, edge_v), dot(edge_v, edge_v)
    pu, pv = dot(inside, edge_u), dot(inside, edge_v)
    determinant = np.maximum(uu * vv - uv * uv, np.finfo(float).tiny)
    second = np.clip((vv * pu - uv * pv) / determinant, 0.0, 1.0)
    third = np.clip((uu * pv - uv * pu) / determinant, 0.0, 1.0)
    return np.clip(1.0 - second - third, 0.0, 1.0), second, third


def corner_normals(mesh):
    """Compute the smooth normals at the corners, ndarray of shape (3, 3, n): corner, coordinate, triangle."""
    which = _vertex_of_face(mesh)
    facet = np.ascontiguousarray(mesh.normals.T)
    weight = _corner_weights(mesh).ravel()
    mean = np.stack([np.bincount(which, np.tile(facet[k], 3) * weight) for k in range(3)])
    length = np.sqrt(dot(mean, mean))
    mean /= np.where(length > 0.0, length, 1.0)
    least = np.full(mean.shape[1], np.cos(CREASE))
    if mesh.face_normals is not None:
        least[_take_known(mesh, which.reshape(3, -1), mean)] = np.cos(KNOWN_CREASE)
    normals = np.empty((3, 3, mesh.count))
    for corner, vertex in zip(normals, which.reshape(3, -1)):
        np.take(mean, vertex, axis=1, out=corner, mode="clip")
        # The tip of a cone and a kink within a face have no unique normal: use that of the facet.
        sharp = np.flatnonzero(dot(corner, facet) < np.take(least, vertex, mode="clip"))
        corner[:, sharp] = facet[:, sharp]
    return normals


def _take_known(mesh, which, mean):
    """Put the normals of the geometry in place of means, ndarray of shape (3, k), where it has any like them; which ones."""
    triangle = np.flatnonzero(mesh.face_normals.is_known[mesh.face_of_triangle])
    vertex, face = np.full((2, mean.shape[1]), -1)
    vertex[which[:, triangle]] = mesh.triangles[triangle].T
    face[which[:, triangle]] = mesh.face_of_triangle[triangle]
    chosen = np.flatnonzero(face >= 0)
    points = np.take(mesh.vertex_columns, vertex[chosen], axis=1) + mesh.origin[:, None]
    known = mesh.face_normals.at(face[chosen], points)
    # The geometry knows no outside; and it knows a kink by one of its sides only.
    alike = dot(known, mean[:, chosen])
    is_near = np.abs(alike) > np.cos(KNOWN_CREASE)
    mean[:, chosen[is_near]] = known[:, is_near] * np.sign(alike[is_near])
    return chosen[is_near]


def _vertex_of_face(mesh):
    """ndarray of shape (3 n,), int64: one number for corners at one vertex of one face; first corners, second, third."""
    vertex = mesh.triangles.T.ravel()
    face = np.tile(mesh.face_of_triangle, 3)
    count = len(mesh.vertices)
    # Most vertices lie inside a face; only those on a border must be distinguished by face.
    some_face = np.empty(count, dtype=np.int64)
    some_face[vertex] = face
    on_border = np.zeros(count, dtype=bool)
    on_border[vertex[some_face[vertex] != face]] = True
    which = vertex.astype(np.int64)
    border = np.flatnonzero(on_border[vertex])
    key = vertex[border] * (mesh.face_of_triangle.max() + 1) + face[border]
    which[border] = count + np.unique(key, return_inverse=True)[1].ravel()
    return which


def _corner_weights(mesh):
    """ndarray of shape (3, n), 1/mm2: weight of each facet at each of its corners."""
    corners = corners_of(mesh.vertex_columns, mesh.triangles)
    sides = [corners[:, (k + 1) % 3] - corners[:, k] for k in range(3)]
    squares = [dot(side, side) for side in sides]
    return np.stack([mesh.areas / (squares[k] * squares[k - 1]) for k in range(3)])
