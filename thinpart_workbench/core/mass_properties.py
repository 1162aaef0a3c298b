"""Volume and area of a surface mesh (Giannini, Petton, Pernot, TMCE 2012, 4.1 and 4.2.1)."""

import numpy as np

from .errors import MeshError
from .tolerances import TOLERANCES


def volume(mesh):
    """Enclosed volume as the sum of signed tetrahedra.

    Parameters
    ----------
    mesh : SurfaceMesh

    Returns
    -------
    float or None
        mm3; None where the surface is not watertight, because then the sum depends on the
        reference point.

    Raises
    ------
    MeshError
        kind ``zero_volume`` when a closed surface encloses nothing.

    Notes
    -----
    The paper takes the origin of the reference frame as the common vertex of the tetrahedra; the
    mesh's own middle is used here, since far from the origin the sum loses all its digits.
    """
    if not mesh.watertight:
        return None
    a, b, c = (mesh.corners[:, k] for k in range(3))
    total = float(np.einsum("ij,ij->", a, np.cross(b, c))) / 6.0
    if total <= TOLERANCES.zero_volume * mesh.extent ** 3:
        raise MeshError("Its surface encloses no volume.", "zero_volume")
    return total


def area(mesh):
    """Area of the surface, mm2: the sum of the areas of the triangles."""
    return float(mesh.areas.sum())
