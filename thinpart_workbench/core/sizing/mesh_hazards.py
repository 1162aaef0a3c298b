# SPDX-License-Identifier: LGPL-2.1-or-later
"""What makes a part hard to mesh automatically: edges, faces and walls that are small against the elements.

Limits are shares of an element, a tenth of the diagonal (`automatic_mesh`), so scale changes nothing. Nothing is meshed.
"""

from dataclasses import dataclass

import numpy as np

from ..columns import corners_of, dot
from ..descriptors.automatic_mesh import AUTOMATIC_SHARE, ELEMENTS_ROUND, FLATTENED, KNIFE, SHORT, TIGHT
from ..descriptors.descriptor_types import HazardsRecord

_KNIFE = np.radians(KNIFE)

_FACET_TURN = np.radians(20.0)
"""Facets are turned by less against the smooth surface, so that theirs tell which edges to look at."""

_PLANE = 1e-6
"""Curvature, times the diagonal, below which surface is plane: normals are rounded."""


@dataclass(frozen=True)
class EdgeLengths:
    """Of a solid, without edges that have no length.

    Attributes
    ----------
    edges : ndarray of shape (e,), mm
    borders : ndarray of shape (f,), mm
        Of the edges around each face.
    """

    edges: np.ndarray
    borders: np.ndarray


def mesh_hazards(field, diagonal, lengths, thin) -> HazardsRecord:
    """Measure what makes a part hard to mesh: HazardsRecord.

    Parameters
    ----------
    field : ThicknessField
        On a mesh with B-Rep faces.
    diagonal : float, mm
        Of the part's box.
    lengths : EdgeLengths
    thin : float or None, mm
        Local thickness below which a twentieth of the surface is.
    """
    element = AUTOMATIC_SHARE * diagonal
    mesh = field.mesh
    areas = np.bincount(mesh.face_of_triangle, mesh.areas, minlength=len(lengths.borders))
    bordered = lengths.borders > 0.0  # a ball has no border
    widths = 2.0 * areas[bordered] / lengths.borders[bordered]
    tight, flattened = _curved_shares(field, element)
    return {
        "faces": len(lengths.borders),
        "shortest_edge_mm": _least(lengths.edges),
        "short_edges": int(np.count_nonzero(lengths.edges < SHORT * element)),
        "narrowest_face_mm": _least(widths),
        "narrow_faces": int(np.count_nonzero(widths < SHORT * element)),
        "knife_edges": _knife_edges(mesh) / diagonal,
        "tight_share": tight,
        "flattened_share": flattened,
        "thin_x": None if thin is None else thin / diagonal,
    }


def _least(lengths):
    return float(lengths.min()) if len(lengths) else None


def _knife_edges(mesh):
    """Length, mm, of edges at which two faces meet under less than `KNIFE` inside the material: float."""
    first, second = mesh.shared_sides
    facets = mesh.normals
    one, other = first // 3, second // 3
    against = np.einsum("ij,ij->i", facets[one], facets[other]) < -np.cos(_KNIFE + _FACET_TURN)
    sharp = np.flatnonzero(against & (mesh.face_of_triangle[one] != mesh.face_of_triangle[other]))
    (one, start), (other, side) = np.divmod(first[sharp], 3), np.divmod(second[sharp], 3)
    corners, normals = mesh.corners, mesh.corner_normals
    end = (start + 1) % 3
    here = normals[start, :, one] + normals[end, :, one]
    there = normals[side, :, other] + normals[(side + 1) % 3, :, other]
    cosine = np.einsum("ij,ij->i", here, there) / np.maximum(
        np.linalg.norm(here, axis=1) * np.linalg.norm(there, axis=1), np.finfo(float).tiny)
    along = corners[one, end] - corners[one, start]
    into = corners[other, (side + 2) % 3] - corners[one, start]
    is_convex = np.einsum("ij,ij->i", here, into) < 0.0
    return float(np.linalg.norm(along, axis=1)[is_convex & (cosine < -np.cos(_KNIFE))].sum())


def _curved_shares(field, element):
    """Shares of the area, floats: tightly curved; over walls that flat elements make thinner or thicker."""
    curvature = greatest_curvature(field.mesh)
    here = curvature[field.samples.triangle]
    met = field.opposite >= 0
    there = np.where(met, curvature[field.opposite], 0.0)
    is_wall = met & (field.parallel | field.nonparallel)
    off = np.maximum(_sag(here, element), _sag(there, element))
    total = field.area.sum()
    return (float(field.area[here * TIGHT * element > 1.0].sum() / total),
            float(field.area[is_wall & (off > FLATTENED * field.distance)].sum() / total))


def _sag(curvature, element):
    """How far chords of elements lie from curves, mm: ndarray of the shape of `curvature`, 1/mm."""
    radius = np.where(curvature > 0.0, 1.0 / np.where(curvature > 0.0, curvature, 1.0), 0.0)
    half = np.minimum(0.5 * element, radius * np.sin(np.pi / ELEMENTS_ROUND))
    return radius - np.sqrt(radius * radius - half * half)


def greatest_curvature(mesh):
    """Greatest curvature along a side of each triangle, 1/mm: ndarray of shape (n,), 0 where the surface is plane."""
    found = np.zeros(mesh.count)
    bent = np.flatnonzero(mesh.is_bent)
    corners = corners_of(mesh.vertex_columns, mesh.triangles[bent])
    normals = mesh.corner_normals[:, :, bent]
    for k in range(3):
        along, turned = corners[:, (k + 1) % 3] - corners[:, k], normals[(k + 1) % 3] - normals[k]
        squared = dot(turned, turned) / np.maximum(dot(along, along), np.finfo(float).tiny)
        found[bent] = np.maximum(found[bent], np.sqrt(squared))
    found[found * mesh.extent < _PLANE] = 0.0
    return found
