# SPDX-License-Identifier: LGPL-2.1-or-later
"""A body of steel as CalculiX reads it."""

import numpy as np

STEEL = "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000,0.3\n*DENSITY\n7.85e-9\n"


def solid_text(points, tetrahedra):
    """Nodes, elements, material and section: str. A node is numbered by its row, from 1; one of no element is left out.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    tetrahedra : ndarray of int, shape (n, 10)
        Of second order, in the order of Gmsh, which has the last two nodes the other way round than CalculiX.
    """
    used = np.unique(tetrahedra)
    tetrahedra = tetrahedra[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]] + 1
    numbers, places = (used + 1).tolist(), points[used].tolist()
    nodes = "".join(f"{row},{x:.12g},{y:.12g},{z:.12g}\n" for row, (x, y, z) in zip(numbers, places))
    elements = "".join(f"{row},{','.join(map(str, own))}\n" for row, own in enumerate(tetrahedra.tolist(), start=1))
    return (f"*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D10, ELSET=SOLID\n{elements}{STEEL}"
            "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL\n")
