"""The triangles of one part, checked once so that everything after can trust them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from .columns import dot
from .edge_balance import closes_at_t_junctions, edge_balance
from .errors import MeshError
from .flat_regions import flattened
from .smooth_normals import corner_normals, smooth_patches
from .tolerances import TOLERANCES


@dataclass(frozen=True)
class SurfaceMesh:
    """A triangulated surface, outward normals where that could be made out.

    Attributes
    ----------
    vertices : ndarray of shape (v, 3), float64, mm
        Relative to `origin`, so that a part far from the origin loses no digits.
    triangles : ndarray of shape (n, 3), int64
        Counter-clockwise seen from outside.
    face_of_triangle : ndarray of shape (n,), int64
        Index of the B-Rep face each triangle came from, or of its smooth patch where there are no
        faces.
    origin : ndarray of shape (3,), float64, mm
    watertight : bool
        Whether the oriented edges cancel, so that the surface bounds a volume; a long edge may be
        met by several short ones.
    cracked : bool
        Whether a ray can slip between triangles that do not share their edges.
    turned_round : bool
        Whether the triangles came inside-out and were inverted.
    dropped_duplicates, dropped_degenerate : int
    warnings : tuple of str
    """

    vertices: np.ndarray
    triangles: np.ndarray
    face_of_triangle: np.ndarray
    origin: np.ndarray
    watertight: bool
    cracked: bool = False
    turned_round: bool = False
    dropped_duplicates: int = 0
    dropped_degenerate: int = 0
    warnings: tuple = ()

    @property
    def count(self):
        """Number of triangles."""
        return len(self.triangles)

    @cached_property
    def corners(self):
        """ndarray of shape (n, 3, 3), mm: triangle, corner, coordinate."""
        return self.vertices[self.triangles]

    @cached_property
    def _area_vectors(self):
        corners = self.corners
        return 0.5 * _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])

    @cached_property
    def areas(self):
        """ndarray of shape (n,), mm2."""
        return np.sqrt(np.einsum("ij,ij->i", self._area_vectors, self._area_vectors))

    @cached_property
    def normals(self):
        """ndarray of shape (n, 3): unit outward normals."""
        return self._area_vectors / self.areas[:, None]

    @cached_property
    def vertex_columns(self):
        """ndarray of shape (3, v), mm: the vertices, the long axis contiguous."""
        return np.ascontiguousarray(self.vertices.T)

    @cached_property
    def corner_normals(self):
        """ndarray of shape (3, 3, n): normals of the smooth surface: corner, coordinate, triangle."""
        return corner_normals(self)

    @cached_property
    def bend(self):
        """ndarray of shape (n,), radians: how far the corner normals turn from the triangle's own."""
        own, chord = np.ascontiguousarray(self.normals.T), np.zeros(self.count)
        for corner in self.corner_normals:
            away = corner - own
            np.maximum(chord, dot(away, away), out=chord)
        return 2.0 * np.arcsin(np.clip(0.5 * np.sqrt(chord), 0.0, 1.0))

    @cached_property
    def extent(self):
        """float, mm: diagonal of the axis-aligned box; the length that tolerances refer to."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))


def surface_mesh(points, triangles, face_of_triangle=None):
    """Check, weld, clean and orient triangles into a `SurfaceMesh`.

    Parameters
    ----------
    points : array_like of shape (v, 3), mm
    triangles : array_like of shape (n, 3), int
    face_of_triangle : array_like of shape (n,), int, optional

    Raises
    ------
    MeshError
        kind ``empty``, ``not_finite`` or ``unreadable``.

    Notes
    -----
    Giannini, Petton, Pernot (TMCE 2012), section 2, work on a soup of triangles: it need not be
    watertight. Duplicate and zero-area triangles are dropped and counted; a surface that is
    consistently inside-out is turned round.
    """
    points = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    triangles = np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
    has_faces = face_of_triangle is not None
    face_of_triangle = np.asarray(
        face_of_triangle if has_faces else np.zeros(len(triangles)), dtype=np.int64
    )
    if len(triangles) == 0:
        raise MeshError("It holds no triangles.", "empty")
    if triangles.min() < 0 or triangles.max() >= len(points):
        raise MeshError("Some triangles refer to points that are not there.")
    used = points[np.unique(triangles)]
    if not np.isfinite(used).all():
        raise MeshError("Some coordinates are not finite numbers.", "not_finite")

    origin = 0.5 * (used.min(axis=0) + used.max(axis=0))
    extent = float(np.linalg.norm(np.ptp(used, axis=0)))
    if not 0.0 < extent < np.inf:
        raise MeshError("All points lie in one place.", "zero_volume")
    vertices, triangles = _weld_equal(points - origin, triangles)
    if _open_edges(triangles):
        welded = _weld_near(vertices, triangles, TOLERANCES.weld * extent)
        if _open_edges(welded) < _open_edges(triangles):
            triangles = welded

    collapsed = _is_collapsed(triangles)
    triangles, face_of_triangle = triangles[~collapsed], face_of_triangle[~collapsed]
    first = _first_of_duplicates(triangles)
    duplicates = len(triangles) - len(first)
    triangles, face_of_triangle = triangles[first], face_of_triangle[first]
    # Asked before needles go: they carry edges even though they carry no area.
    cracked = len(triangles) > 0 and _open_edges(triangles) > 0
    watertight = len(triangles) > 0 and (
        not cracked or closes_at_t_junctions(vertices, triangles, TOLERANCES.gap * extent)
    )

    flat = _is_flat(vertices, triangles, TOLERANCES.zero_height * extent)
    triangles, face_of_triangle = triangles[~flat], face_of_triangle[~flat]
    if len(triangles) == 0:
        raise MeshError("All its triangles have zero area.", "zero_volume")
    vertices = flattened(vertices, triangles, extent)
    inside_out = _signed_volume(vertices, triangles) < 0.0
    if inside_out:
        triangles = triangles[:, ::-1]
    if not has_faces:
        face_of_triangle = smooth_patches(vertices, triangles)

    degenerate = int(collapsed.sum() + flat.sum())
    warnings = []
    if not watertight:
        warnings.append(_why_not_watertight(triangles))
    if inside_out:
        warnings.append("The surface was inside-out and has been turned round.")
    if duplicates:
        warnings.append(f"{duplicates} duplicate triangles were left out.")
    if degenerate:
        warnings.append(f"{degenerate} triangles of zero area were left out.")
    return SurfaceMesh(
        vertices, np.ascontiguousarray(triangles), face_of_triangle, origin, watertight, cracked,
        inside_out, duplicates, degenerate, tuple(warnings),
    )


def _cross(a, b):
    """Row-wise cross product; three times faster than np.cross on many short rows."""
    out = np.empty_like(a)
    out[:, 0] = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    out[:, 1] = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    out[:, 2] = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return out


def _weld_equal(points, triangles):
    """Make equal points one vertex; points that no triangle uses disappear."""
    used, triangles = np.unique(triangles, return_inverse=True)
    points = points[used] + 0.0  # turns -0.0 into 0.0, which compare equal but sort apart
    order = np.lexsort(points.T)
    ranked = points[order]
    is_new = np.concatenate([[True], (ranked[1:] != ranked[:-1]).any(axis=1)])
    vertex_of_point = np.empty(len(points), dtype=np.int64)
    vertex_of_point[order] = np.cumsum(is_new) - 1
    return ranked[is_new], vertex_of_point[triangles.reshape(-1, 3)]


def _weld_near(vertices, triangles, tolerance):
    """Make vertices nearer than `tolerance` one vertex."""
    pairs = cKDTree(vertices).query_pairs(tolerance, output_type="ndarray")
    if len(pairs) == 0:
        return triangles
    graph = coo_matrix((np.ones(len(pairs)), pairs.T), shape=(len(vertices),) * 2)
    cluster = connected_components(graph, directed=False)[1]
    representative = np.full(cluster.max() + 1, len(vertices))
    np.minimum.at(representative, cluster, np.arange(len(vertices)))
    return representative[cluster][triangles]


def _open_edges(triangles):
    return int(np.count_nonzero(edge_balance(triangles)[1]))


def _why_not_watertight(triangles):
    _, _, uses = edge_balance(triangles)
    if (uses % 2 == 0).all():
        return "The triangles are not consistently oriented, so it has no certain volume."
    return f"The surface is open ({int((uses % 2).sum())} free edges), so it has no certain volume."


def _is_collapsed(triangles):
    a, b, c = triangles.T
    return (a == b) | (b == c) | (c == a)


def _first_of_duplicates(triangles):
    """Indices, ascending, of triangles that are not a repetition of an earlier one."""
    start = triangles.argmin(axis=1)
    rows = np.arange(len(triangles))
    turned = np.stack([triangles[rows, (start + k) % 3] for k in range(3)], axis=1)
    return np.sort(np.unique(turned, axis=0, return_index=True)[1])


def _is_flat(vertices, triangles, height):
    corners = vertices[triangles]
    sides = corners - np.roll(corners, 1, axis=1)
    longest = np.sqrt((sides * sides).sum(axis=2).max(axis=1))
    doubled = _cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return np.sqrt((doubled * doubled).sum(axis=1)) <= longest * height


def _signed_volume(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, _cross(b, c))) / 6.0
