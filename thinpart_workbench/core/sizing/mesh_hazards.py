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
        "knife_edges": float(field.sharp_edges.under(_KNIFE).lengths.sum()) / diagonal,
        "tight_share": tight,
        "flattened_share": flattened,
        "thin_x": None if thin is None else thin / diagonal,
    }


def _least(lengths):
    return float(lengths.min()) if len(lengths) else None


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
