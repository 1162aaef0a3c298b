# SPDX-License-Identifier: LGPL-2.1-or-later
"""The triangles of one part, checked once so that all later code can rely on them."""

from dataclasses import dataclass
from functools import cached_property
from typing import Optional

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ..columns import corners_of, cross, dot
from ..errors import MeshError
from ..message import message
from ..tolerances import TOLERANCES
from .curved_surface import CurvedSurface
from .edge_balance import closes_at_t_junctions, edge_balance, paired_sides, shared_sides, slit_area
from .face_normals import FaceNormals
from .flat_regions import flattened
from .smooth_normals import MOST_BEND, corner_normals, smooth_patches

MOST_SLITS = 2e-6
"""Area of the slits in the mesh of a solid, as a share of its surface, which makes no difference to its volume. OCC leaves
single triangles out; with whole faces it is a thousand times as much."""


@dataclass(frozen=True)
class SurfaceMesh:
    """A triangulated surface, with outward normals where the orientation could be determined.

    Attributes
    ----------
    vertices : ndarray of shape (v, 3), float64, mm
        Relative to `origin`, so that a part far from the origin of its document loses no digits.
    triangles : ndarray of shape (n, 3), int64
        Counter-clockwise seen from outside.
    face_of_triangle : ndarray of shape (n,), int64
        Index of the B-Rep face of each triangle, or of its smooth patch if there are no faces.
    origin : ndarray of shape (3,), float64, mm
    watertight : bool
        Whether the oriented edges cancel, so that the surface bounds a volume; several short edges may cancel a long
        one.
    cracked : bool
        Whether a ray can pass between triangles that do not share their edges.
    warnings : tuple of str
    rounding : float
        Error of the points, as a share of the diagonal.
    has_faces : bool
        Whether the faces are those of a B-Rep, so that the facets of a face approximate a smooth surface.
    face_normals : FaceNormals or None
        What is known of the normals of that surface.
    """

    vertices: np.ndarray
    triangles: np.ndarray
    face_of_triangle: np.ndarray
    origin: np.ndarray
    watertight: bool
    cracked: bool = False
    warnings: tuple = ()
    rounding: float = TOLERANCES.rounding
    has_faces: bool = False
    face_normals: Optional[FaceNormals] = None

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
    def shared_sides(self):
        """Two ndarrays of shape (e,), int64: sides of triangles that share an edge, see `shared_sides`."""
        return shared_sides(self.triangles)

    @cached_property
    def vertex_columns(self):
        """ndarray of shape (3, v), mm: the vertices with the long axis contiguous."""
        return np.ascontiguousarray(self.vertices.T)

    @cached_property
    def corner_normals(self):
        """ndarray of shape (3, 3, n): normals of the smooth surface: corner, coordinate, triangle."""
        return corner_normals(self)

    @cached_property
    def curved_surface(self):
        """The `CurvedSurface` that the facets approximate."""
        return CurvedSurface(self)

    @cached_property
    def bend(self):
        """ndarray of shape (n,), radians: greatest angle between the corner normals and the normal of the triangle."""
        own, chord = np.ascontiguousarray(self.normals.T), np.zeros(self.count)
        for corner in self.corner_normals:
            away = corner - own
            np.maximum(chord, dot(away, away), out=chord)
        return 2.0 * np.arcsin(np.clip(0.5 * np.sqrt(chord), 0.0, 1.0))

    @cached_property
    def is_bent(self):
        """ndarray of shape (n,), bool: triangles that approximate a curved surface."""
        return (self.bend > TOLERANCES.angle) & (self.has_faces | (self.bend < MOST_BEND))

    @cached_property
    def extent(self):
        """float, mm: diagonal of the axis-aligned box, to which tolerances refer."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))


def surface_mesh(points, triangles, face_of_triangle=None, rounding=TOLERANCES.rounding, face_normals=None, of_solid=False):
    """Check, weld, clean and orient triangles into a `SurfaceMesh`.

    Raises MeshError, kind ``empty``, ``not_finite`` or ``unreadable``.

    As in Giannini, Petton, Pernot (TMCE 2012), section 2, the triangles need not be watertight. Duplicate and
    zero-area triangles are dropped and counted. A surface that is consistently inside-out is inverted.

    Parameters
    ----------
    points : array_like of shape (v, 3), mm
    triangles : array_like of shape (n, 3), int
    face_of_triangle : array_like of shape (n,), int, optional
    rounding : float, optional
        Error of the points, as a share of the diagonal; by default that of float32.
    face_normals : FaceNormals, optional
        Of the faces, if they are those of a B-Rep.
    of_solid : bool, optional
        Whether the triangles are those of a solid, so that slits between them are the mesher's and no openings.
    """
    points = np.asarray(points, dtype=np.float64).reshape(-1, 3)
    triangles = np.asarray(triangles, dtype=np.int64).reshape(-1, 3)
    has_faces = face_of_triangle is not None
    face_of_triangle = np.asarray(
        face_of_triangle if has_faces else np.zeros(len(triangles)), dtype=np.int64
    )
    if len(triangles) == 0:
        raise MeshError(message("It holds no triangles."), "empty")
    if triangles.min() < 0 or triangles.max() >= len(points):
        raise MeshError(message("Some triangles refer to points that are not there."))
    used = points[np.unique(triangles)]
    if not np.isfinite(used).all():
        raise MeshError(message("Some coordinates are not finite numbers."), "not_finite")

    origin = 0.5 * (used.min(axis=0) + used.max(axis=0))
    extent = float(np.linalg.norm(np.ptp(used, axis=0)))
    if not 0.0 < extent < np.inf:
        raise MeshError(message("All points coincide."), "zero_volume")
    vertices, triangles = _weld_equal(points - origin, triangles)
    sides = paired_sides(triangles)
    collapsed = duplicates = 0
    cracked, watertight = False, True
    if sides is None:
        vertices, triangles, face_of_triangle, collapsed, duplicates = _without_repetition(
            vertices, triangles, face_of_triangle, TOLERANCES.weld * extent)
        # Check this before removing triangles of zero area, because their edges still connect the others.
        cracked = len(triangles) > 0 and _open_edges(triangles) > 0
        watertight = len(triangles) > 0 and (
            not cracked or closes_at_t_junctions(vertices, triangles, TOLERANCES.gap * extent)
            or of_solid and slit_area(vertices, triangles) < MOST_SLITS * _area(vertices, triangles)
        )

    flat = _is_flat(vertices, triangles, TOLERANCES.zero_height * extent)
    if flat.any():
        triangles, face_of_triangle, sides = triangles[~flat], face_of_triangle[~flat], None
    if len(triangles) == 0:
        raise MeshError(message("All its triangles have zero area."), "zero_volume")
    if sides is None:
        sides = shared_sides(triangles)
    vertices = flattened(vertices, triangles, sides, extent)
    inside_out = _signed_volume(vertices, triangles) < 0.0
    if inside_out:
        triangles, sides = triangles[:, ::-1], tuple(_reversed_sides(side) for side in sides)
    if not has_faces:
        face_of_triangle = smooth_patches(vertices, triangles, sides)

    degenerate = collapsed + int(flat.sum())
    warnings = []
    if not watertight:
        warnings.append(_why_not_watertight(triangles))
    if inside_out:
        warnings.append(message("The surface was inside out and has been reversed."))
    if duplicates:
        warnings.append(message("1 duplicate triangle was left out.") if duplicates == 1 else
                        message("{count} duplicate triangles were left out.", count=duplicates))
    if degenerate:
        warnings.append(message("1 triangle of zero area was left out.") if degenerate == 1 else
                        message("{count} triangles of zero area were left out.", count=degenerate))
    mesh = SurfaceMesh(
        vertices, np.ascontiguousarray(triangles), face_of_triangle, origin, watertight, cracked,
        tuple(warnings), rounding, has_faces, face_normals,
    )
    mesh.__dict__["shared_sides"] = sides  # the cached property, known already
    return mesh


def unchecked_mesh(points, triangles):
    """A `SurfaceMesh` in a tenth of the time, for a first look and nothing else.

    Raises MeshError, kind ``zero_volume`` if no triangle has an area.

    Nothing is welded, repaired or divided into faces, no normal is smooth, and it is taken to be closed. Only triangles
    without area are left out, and an inside-out surface is inverted.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    triangles : ndarray of shape (n, 3), int64
    """
    origin = 0.5 * (points.min(axis=0) + points.max(axis=0))
    vertices = points - origin
    extent = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    triangles = triangles[~_is_flat(vertices, triangles, TOLERANCES.zero_height * extent)]
    if not len(triangles):
        raise MeshError(message("All its triangles have zero area."), "zero_volume")
    if _signed_volume(vertices, triangles) < 0.0:
        triangles = triangles[:, ::-1]
    mesh = SurfaceMesh(vertices, np.ascontiguousarray(triangles), np.zeros(len(triangles), dtype=np.int64), origin, True)
    mesh.__dict__["is_bent"] = np.zeros(len(triangles), dtype=bool)  # the cached property, which takes long
    return mesh


def _cross(a, b):
    """Row-wise cross product, three times as fast as np.cross on many short rows."""
    out = np.empty_like(a)
    out[:, 0] = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    out[:, 1] = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    out[:, 2] = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return out


def _weld_equal(points, triangles):
    """Merge equal points into one vertex, and remove points that no triangle uses."""
    is_used = np.zeros(len(points), dtype=bool)
    is_used[triangles] = True
    triangles = (np.cumsum(is_used) - 1)[triangles]
    points = points[is_used] + 0.0  # turns -0.0 into 0.0: they are equal, but sort differently
    order = np.lexsort(points.T)
    ranked = points[order]
    is_new = np.concatenate([[True], (ranked[1:] != ranked[:-1]).any(axis=1)])
    vertex_of_point = np.empty(len(points), dtype=np.int64)
    vertex_of_point[order] = np.cumsum(is_new) - 1
    return ranked[is_new], vertex_of_point[triangles]


def _weld_near(vertices, triangles, tolerance):
    """Merge vertices nearer than `tolerance` into one vertex."""
    pairs = cKDTree(vertices).query_pairs(tolerance, output_type="ndarray")
    if len(pairs) == 0:
        return triangles
    graph = coo_matrix((np.ones(len(pairs)), pairs.T), shape=(len(vertices),) * 2)
    cluster = connected_components(graph, directed=False)[1]
    representative = np.full(cluster.max() + 1, len(vertices))
    np.minimum.at(representative, cluster, np.arange(len(vertices)))
    return representative[cluster][triangles]


def _without_repetition(vertices, triangles, face_of_triangle, tolerance):
    """Weld what is open, and leave out triangles that are collapsed or repeated; the last two results are their numbers."""
    if _open_edges(triangles):
        welded = _weld_near(vertices, triangles, tolerance)
        if _open_edges(welded) < _open_edges(triangles):
            triangles = welded
    collapsed = _is_collapsed(triangles)
    triangles, face_of_triangle = triangles[~collapsed], face_of_triangle[~collapsed]
    first = _first_of_duplicates(triangles)
    return (vertices, triangles[first], face_of_triangle[first],
            int(collapsed.sum()), len(triangles) - len(first))


def _reversed_sides(sides):
    """Numbers of sides after the corners of their triangles are reversed."""
    triangle, start = np.divmod(sides, 3)
    return 3 * triangle + (1 - start) % 3


def _open_edges(triangles):
    return int(np.count_nonzero(edge_balance(triangles)[1]))


def _why_not_watertight(triangles):
    _, _, uses = edge_balance(triangles)
    if (uses % 2 == 0).all():
        return message("The triangles are not consistently oriented, so it has no certain volume.")
    return message("The surface is open ({edges} free edges), so it has no certain volume.",
                   edges=int((uses % 2).sum()))


def _is_collapsed(triangles):
    a, b, c = triangles.T
    return (a == b) | (b == c) | (c == a)


def _first_of_duplicates(triangles):
    """Indices, ascending, of triangles that do not repeat an earlier one."""
    start = triangles.argmin(axis=1)
    rows = np.arange(len(triangles))
    turned = np.stack([triangles[rows, (start + k) % 3] for k in range(3)], axis=1)
    return np.sort(np.unique(turned, axis=0, return_index=True)[1])


def _is_flat(vertices, triangles, height):
    corners = corners_of(np.ascontiguousarray(vertices.T), triangles)
    sides = [corners[:, k] - corners[:, k - 1] for k in range(3)]
    longest = np.sqrt(np.max([dot(side, side) for side in sides], axis=0))
    doubled = cross(sides[1], sides[2])
    return np.sqrt(dot(doubled, doubled)) <= longest * height


def _area(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return 0.5 * float(np.linalg.norm(_cross(b - a, c - a), axis=1).sum())


def _signed_volume(vertices, triangles):
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->", a, _cross(b, c))) / 6.0
