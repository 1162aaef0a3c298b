# SPDX-License-Identifier: LGPL-2.1-or-later
"""Global placements of document objects, and placements as arrays for `core/rigid_transform`."""

import numpy as np

from ..occurrence import objects_along
from .tolerances import SHAPE_TOLERANCES


def placement_matrix(placement):
    """A FreeCAD.Placement as ndarray of shape (4, 4), mm."""
    return matrix_array(placement.toMatrix())


def matrix_array(matrix):
    """A FreeCAD.Matrix, which may scale, as ndarray of shape (4, 4), mm."""
    return np.array(matrix.A).reshape(4, 4)


def global_placement(source):
    """The FreeCAD.Placement of an object in its document, including those of its containers."""
    paths = [(root, path) for root, path in getattr(source, "Parents", ()) if root.Document == source.Document]
    if not paths:
        return source.getSubObject("", retType=3)
    # FreeCAD lists the paths in any order. Prefer one without links: links to its container do not move the object.
    root, path = min(paths, key=lambda entry: (len(links_in(objects_along(*entry))), entry[0].Name, entry[1]))
    return root.getSubObject(path, retType=3)


def links_in(chain):
    """The links among some objects: list of FreeCAD.DocumentObject."""
    return [candidate for candidate in chain
            if candidate.isDerivedFrom("App::Link") or candidate.isDerivedFrom("App::LinkElement")]


def same_placement(one, other):
    """Whether two placements are equal up to rounding."""
    apart = one.inverse() * other
    reach = max(1.0, one.Base.Length, other.Base.Length)
    return apart.Base.Length < SHAPE_TOLERANCES.placed * reach and abs(apart.Rotation.Angle) < SHAPE_TOLERANCES.placed
