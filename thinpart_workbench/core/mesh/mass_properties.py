# SPDX-License-Identifier: LGPL-2.1-or-later
"""Volume and area of a surface mesh (Giannini, Petton, Pernot, TMCE 2012, 4.1 and 4.2.1)."""

from ..columns import corners_of, cross, dot
from ..errors import MeshError
from ..message import message
from ..tolerances import TOLERANCES


def volume(mesh):
    """Compute the enclosed volume as the sum of signed tetrahedra, and of what curved surfaces add to their facets.

    Returns a float or None: mm3; None where the surface is not watertight, because then the sum depends on the reference
    point. Raises MeshError, kind ``zero_volume`` if a closed surface encloses nothing.

    The paper uses the origin of the reference frame as the common vertex of the tetrahedra. Here it is the centre of
    the mesh, because far from the origin the sum loses all its digits.
    """
    if not mesh.watertight:
        return None
    a, b, c = corners_of(mesh.vertex_columns, mesh.triangles).transpose(1, 0, 2)
    total = float(dot(a, cross(b, c)).sum()) / 6.0
    if total <= TOLERANCES.zero_volume * mesh.extent * area(mesh):
        raise MeshError(message("Its surface encloses no volume."), "zero_volume")
    # Triangles that are given as such have the volume that other programs say.
    return total + mesh.curved_surface.volume_gain if mesh.has_faces else total


def area(mesh):
    """Area of the surface, mm2: the sum of the areas of the triangles."""
    return float(mesh.areas.sum())
