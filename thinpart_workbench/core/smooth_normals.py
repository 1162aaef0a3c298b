"""Normals of the surface that the facets stand for."""

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from .edge_balance import shared_sides
from .tolerances import TOLERANCES

_AT_ONCE = 16384

CREASE = np.radians(20.0)
"""Facets that meet at less than this belong to one smooth surface, unless B-Rep faces say more."""


def smooth_patches(vertices, triangles):
    """Patches of a mesh within which no edge is a crease.

    Parameters
    ----------
    vertices : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3)
        Welded and oriented.

    Returns
    -------
    ndarray of shape (n,), int64
        Patch of each triangle, by first appearance.
    """
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    first, second = (side // 3 for side in shared_sides(triangles))
    smooth = np.einsum("ij,ij->i", normals[first], normals[second]) > np.cos(CREASE)
    links = coo_matrix(
        (np.ones(smooth.sum()), (first[smooth], second[smooth])), shape=(len(triangles),) * 2
    )
    label = connected_components(links, directed=False)[1]
    _, appears, which = np.unique(label, return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(appears))
    return rank[which.ravel()]


def normals_at(mesh, triangle, points):
    """Unit normals of the smooth surface at points of triangles.

    Parameters
    ----------
    mesh : SurfaceMesh
    triangle : ndarray of shape (m,), int64
    points : ndarray of shape (m, 3), mm
        In the mesh's own coordinates, on those triangles.

    Returns
    -------
    ndarray of shape (m, 3)

    Notes
    -----
    Corner normals are means over the facets of the same face, weighted by their angle there
    (Thuermer and Wuethrich 1998, doi:10.1080/10867651.1998.10487487), interpolated as by Phong
    (1975, doi:10.1145/360825.360839). On a plane they are the facet's own. Two walls of a
    tessellated shell are parallel by these normals, although their facets are not.
    """
    corner_normals = mesh.corner_normals
    normal = mesh.normals[triangle]
    bent = np.flatnonzero(mesh.bend[triangle] > TOLERANCES.angle)
    for start in range(0, len(bent), _AT_ONCE):
        chosen = bent[start:start + _AT_ONCE]
        weights = _barycentric(mesh.corners[triangle[chosen]], points[chosen])
        mean = np.einsum("ik,ikj->ij", weights, corner_normals[triangle[chosen]])
        normal[chosen] = mean / np.sqrt(np.einsum("ij,ij->i", mean, mean))[:, None]
    return normal


def _barycentric(corners, points):
    """ndarray of shape (m, 3): weights of the corners, of points on or just beside triangles."""
    edge_u, edge_v = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    inside = points - corners[:, 0]
    uu, uv, vv = (np.einsum("ij,ij->i", a, b) for a, b in (
        (edge_u, edge_u), (edge_u, edge_v), (edge_v, edge_v)))
    pu, pv = (np.einsum("ij,ij->i", inside, edge) for edge in (edge_u, edge_v))
    determinant = np.maximum(uu * vv - uv * uv, np.finfo(float).tiny)
    second = np.clip((vv * pu - uv * pv) / determinant, 0.0, 1.0)
    third = np.clip((uu * pv - uv * pu) / determinant, 0.0, 1.0)
    return np.stack([np.clip(1.0 - second - third, 0.0, 1.0), second, third], axis=1)


def corner_normals(mesh):
    """Normals of the smooth surface at the corners, ndarray of shape (n, 3, 3).

    Parameters
    ----------
    mesh : SurfaceMesh
    """
    corners, normals = mesh.corners, mesh.normals
    which = _vertex_of_face(mesh)
    weight = _corner_angles(corners).ravel()
    facet = np.repeat(normals, 3, axis=0)
    mean = np.stack([np.bincount(which, facet[:, k] * weight) for k in range(3)], axis=1)
    length = np.linalg.norm(mean, axis=1)
    mean /= np.where(length > 0.0, length, 1.0)[:, None]
    mean = mean[which]
    # The tip of a cone and a kink within a face have no one normal: the facet's own stands there.
    sharp = np.einsum("ij,ij->i", mean, facet) < np.cos(CREASE)
    mean[sharp] = facet[sharp]
    return mean.reshape(-1, 3, 3)


def _vertex_of_face(mesh):
    """A number for each corner of a triangle, the same for those at one vertex of one face.

    Returns
    -------
    ndarray of shape (3 n,), int64
    """
    vertex = mesh.triangles.ravel()
    face = np.repeat(mesh.face_of_triangle, 3)
    count = len(mesh.vertices)
    # Most vertices lie within a face: only those on its border have to be sorted by face.
    some_face = np.empty(count, dtype=np.int64)
    some_face[vertex] = face
    on_border = np.zeros(count, dtype=bool)
    on_border[vertex[some_face[vertex] != face]] = True
    which = vertex.astype(np.int64)
    border = np.flatnonzero(on_border[vertex])
    key = vertex[border] * (mesh.face_of_triangle.max() + 1) + face[border]
    which[border] = count + np.unique(key, return_inverse=True)[1].ravel()
    return which


def _corner_angles(corners):
    """ndarray of shape (n, 3), radians."""
    sides = [corners[:, (k + 1) % 3] - corners[:, k] for k in range(3)]
    lengths = [np.sqrt(np.einsum("ij,ij->i", side, side)) for side in sides]
    cosine = np.stack([
        -np.einsum("ij,ij->i", sides[k], sides[k - 1]) / (lengths[k] * lengths[k - 1]) for k in range(3)
    ], axis=1)
    return np.arccos(np.clip(cosine, -1.0, 1.0))
