"""How far a tessellation lies from the curved surface that it stands for."""

import numpy as np

from .edge_balance import shared_sides


def chord_error(mesh, planar_faces, linear_deflection):
    """Upper estimate of the chord error of a tessellated B-Rep.

    Parameters
    ----------
    mesh : SurfaceMesh
    planar_faces : ndarray of shape (f,), bool
        Which B-Rep faces are planes: those have none.
    linear_deflection : float, mm
        What the mesher was asked for. The angular deflection mostly makes the mesh finer than that.

    Returns
    -------
    float, mm

    Notes
    -----
    On a circle, facets of width w that meet at an angle phi lie w tan(phi / 4) / 2 inside the arc.
    The estimate takes the height of the larger triangle at each inner edge for w and twice the
    result, since facets of one strip differ in width. A curved face without inner bent edge shows
    nothing of its curvature, so there the asked deflection stands.
    """
    curved = ~planar_faces
    if not curved[np.unique(mesh.face_of_triangle)].any():
        return 0.0
    first, second, length = _inner_edges(mesh)
    of_curved = curved[mesh.face_of_triangle[first]]
    first, second, length = first[of_curved], second[of_curved], length[of_curved]
    chord = mesh.normals[first] - mesh.normals[second]
    angle = 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(chord, axis=1), 0.0, 1.0))
    width = 2.0 * np.maximum(mesh.areas[first], mesh.areas[second]) / length
    error = width * np.tan(0.25 * angle)
    per_face = np.zeros(len(planar_faces))
    np.maximum.at(per_face, mesh.face_of_triangle[first], error)
    present = np.zeros(len(planar_faces), dtype=bool)
    present[mesh.face_of_triangle] = True
    per_face[curved & present & (per_face == 0.0)] = linear_deflection
    return float(min(linear_deflection, per_face.max()))


def _inner_edges(mesh):
    """Edges with the same B-Rep face on both sides: two triangles and the length, mm."""
    side, other = shared_sides(mesh.triangles)
    first, second = side // 3, other // 3
    same = mesh.face_of_triangle[first] == mesh.face_of_triangle[second]
    side, first, second = side[same], first[same], second[same]
    start, end = mesh.corners[first, side % 3], mesh.corners[first, (side + 1) % 3]
    return first, second, np.linalg.norm(start - end, axis=1)
