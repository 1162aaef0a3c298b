# SPDX-License-Identifier: LGPL-2.1-or-later
"""Distance between a tessellation and the curved surface that it approximates."""

import numpy as np


def chord_errors(mesh, planar_faces, linear_deflection):
    """Estimate the chord error of each face of a tessellated B-Rep from above: ndarray of shape (f,), mm.

    At most the given deflection, and 0 for a face without triangles.

    On a circle, facets of width w that meet at an angle phi lie w tan(phi / 4) / 2 inside the arc.
    The estimate uses the height of the larger triangle at each inner edge as w, and doubles the result because
    facets of one strip differ in width. A curved face without a bent inner edge gives no information about its
    curvature, so the given deflection is used there.

    Parameters
    ----------
    mesh : SurfaceMesh
    planar_faces : ndarray of shape (f,), bool
        Which B-Rep faces are planes: those have no chord error.
    linear_deflection : float, mm
        Linear deflection given to the mesher. The angular deflection mostly makes the mesh finer than that.
    """
    curved = ~planar_faces
    per_face = np.zeros(len(planar_faces))
    if not curved[np.unique(mesh.face_of_triangle)].any():
        return per_face
    first, second, length = _inner_edges(mesh)
    of_curved = curved[mesh.face_of_triangle[first]]
    first, second, length = first[of_curved], second[of_curved], length[of_curved]
    chord = mesh.normals[first] - mesh.normals[second]
    angle = 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(chord, axis=1), 0.0, 1.0))
    width = 2.0 * np.maximum(mesh.areas[first], mesh.areas[second]) / length
    error = width * np.tan(0.25 * angle)
    order = np.argsort(mesh.face_of_triangle[first], kind="stable")
    faces, starts = np.unique(mesh.face_of_triangle[first][order], return_index=True)
    if len(faces):
        per_face[faces] = np.maximum.reduceat(error[order], starts)
    present = np.zeros(len(planar_faces), dtype=bool)
    present[mesh.face_of_triangle] = True
    per_face[curved & present & (per_face == 0.0)] = linear_deflection
    return np.minimum(linear_deflection, per_face)


def _inner_edges(mesh):
    """Edges with the same B-Rep face on both sides: their two triangles and their length, mm."""
    side, other = mesh.shared_sides
    first, second = side // 3, other // 3
    same = mesh.face_of_triangle[first] == mesh.face_of_triangle[second]
    side, first, second = side[same], first[same], second[same]
    start, end = mesh.corners[first, side % 3], mesh.corners[first, (side + 1) % 3]
    return first, second, np.linalg.norm(start - end, axis=1)
