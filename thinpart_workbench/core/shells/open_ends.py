# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a shell ends inside the material, because walls that belong together do not meet there."""

import numpy as np

from ..rays.ray_casting import INNER, first_hits

INSIDE = 0.6
"""Distance from an edge of the shell to the surface of the part, by the thickness, from which on it ends inside."""

SAGITTA = 0.14
"""Greatest distance of a chord from its arc by its length, with six chords around a circle."""

_BACK = 0.05


def open_ends(shell, mesh, rays):
    """Length of the free edges of a shell, and of those among them that end inside the material.

    Returns `inside` and `free` (float, mm).

    Parameters
    ----------
    shell : ShellMesh
    mesh : SurfaceMesh
        Of the solid.
    rays : InwardRays
        Of that mesh.
    """
    corners = shell.triangles[:, :3]
    sides = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    owner = np.tile(np.arange(len(corners)), 3)
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    free = first[count == 1]
    if not len(free):
        return 0.0, 0.0
    start, end = shell.points[sides[free].T]
    own = corners[owner[free]]
    middle, centre = 0.5 * (start + end), shell.points[own].mean(axis=1)
    if shell.triangles.shape[1] == 6:
        # Around a hole, the middle of a chord lies in the hole; the node between its ends is on the edge.
        middle = shell.points[shell.triangles[owner[free], 3 + free // len(corners)]]
    along = end - start
    length = np.linalg.norm(along, axis=1)
    along /= length[:, None]
    outward = middle - centre
    outward -= np.einsum("ij,ij->i", outward, along)[:, None] * along
    outward /= np.linalg.norm(outward, axis=1)[:, None]
    thickness = shell.thickness[owner[free]]
    back = _BACK * thickness + (SAGITTA * length if shell.triangles.shape[1] == 3 else 0.0)
    origins = middle - back[:, None] * outward
    distance, _ = first_hits(rays.tree, rays.turned(origins - mesh.origin), rays.turned_directions(outward), INNER)
    is_inside = np.isfinite(distance) & (distance > INSIDE * thickness + back)
    return float(length[is_inside].sum()), float(length.sum())
