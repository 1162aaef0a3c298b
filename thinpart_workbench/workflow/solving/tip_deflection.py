# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a body that is held at one end bends under a force at the other, by CalculiX."""

import os

import numpy as np

from .calculix_program import solve
from .solid_model import solid_text

JOB = "bend"

FORCE = 1.0
"""N."""


def tip_deflection(points, tetrahedra, held, loaded, direction, program, seconds, folder):
    """The mean displacement of the loaded surface along the force on it, of a body of steel.

    The force is spread evenly over the surface, so the displacement is the work by the force, which converges as energy does
    and depends on no node.

    Returns `deflection` (float, mm; nan where there is none) and `reason` (str; why).

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 10)
        Of second order, in the order of Gmsh.
    held, loaded : ndarray of int, shape (k, 6)
        Triangles of second order of the surface that does not move, and of that which bears the force `FORCE`.
    direction : ndarray of shape (3,)
        Of the force, a unit vector.
    program : str
        Path of CalculiX.
    seconds : float
        Limit of processor time.
    folder : str
        Working directory, temporary.
    """
    corners = points[loaded[:, :3]]
    areas = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    # An even load on a triangle of second order is borne by the middles of its sides alone.
    share = np.bincount(loaded[:, 3:].ravel(), np.repeat(areas / 3.0, 3), len(points)) / areas.sum()
    fixed = np.unique(held)
    share[fixed] = 0.0
    bearing = np.flatnonzero(share)
    with open(os.path.join(folder, JOB + ".inp"), "w", encoding="ascii") as file:
        file.write(solid_text(points, tetrahedra))
        file.write(_set("HELD", fixed) + _set("TIP", bearing))
        file.write("*STEP\n*STATIC\n*BOUNDARY\nHELD,1,3\n*CLOAD\n")
        for node in bearing.tolist():
            for axis in np.flatnonzero(direction).tolist():
                file.write(f"{node + 1},{axis + 1},{FORCE * share[node] * direction[axis]:.12g}\n")
        file.write("*NODE PRINT, NSET=TIP\nU\n*END STEP\n")
    reason = solve(program, JOB, seconds, folder)
    if reason:
        return np.nan, reason
    moved = np.zeros((len(points), 3))
    with open(os.path.join(folder, JOB + ".dat"), encoding="ascii", errors="replace") as file:
        for line in file:
            words = line.split()
            if len(words) == 4 and words[0].isdigit():
                moved[int(words[0]) - 1] = [float(word) for word in words[1:]]
    return float(share @ (moved @ direction)), ""


def _set(name, nodes):
    return f"*NSET, NSET={name}\n" + "".join(f"{node + 1}\n" for node in nodes.tolist())
