# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many elements a size field leads to."""

import numpy as np

PER_CUBE = 4.9
"""Tetrahedra of Gmsh in a cube as long as their size: its edges get longer. Regular ones would be 8.5."""

PER_SQUARE = 3.6
"""Tetrahedra of Gmsh under a square as long as their size, on either side of a wall that is thinner than 1.4 sizes: a single
layer of flat ones reaches from side to side, however thin the wall is. Three fill a prism, on 2.3 triangles for a square."""


NODES_OF_ORDER = {1: 0.3, 2: 2.06}
"""Nodes by elements, of parts whose surface has much of the mesh."""

FINER, PER_FACE = 1.21, 14.0
"""Of meshes with few elements, those for an error aimed at: elements by those of the size field, and more for each face,
whose edges and corners have nodes however large the elements are."""


MANY_NODES = 200_000
"""Nodes from which on that is said first."""

SOLVED_NODES, SOLVED_SECONDS, SOLVED_BY_NODES = 5_400, 1.75, 1.5
"""CalculiX 2.20, one thread, takes so many seconds for the first six elastic frequencies of so many nodes of second order;
and the exponent with which the time grows."""


def elements_by_sample(inner, size_field, count):
    """Estimate the number of tetrahedra under each sample of the surface: ndarray of shape (count,).

    Parameters
    ----------
    inner : InnerPoints
    size_field : SizeField
    count : int
        Number of samples.
    """
    elements = np.zeros(count)
    sizes = size_field.at(inner.points.reshape(-1, 3)).reshape(inner.volumes.shape)
    elements[inner.sample] = PER_CUBE * np.sum(inner.volumes * sizes ** -3.0, axis=0)
    # What flat elements are more than those that the volume asks for. The volume under a sample is not that of `volumes`,
    # where samples on the rim, which see along the wall, have a share of it.
    size = sizes[0]
    flat = inner.areas * size ** -2.0 * (PER_SQUARE - PER_CUBE * inner.halves / size)
    elements[inner.sample] += np.maximum(flat, 0.0)
    return elements


def of_few(elements, faces):
    """The number of tetrahedra where there are few: float.

    58 meshes of real parts had 0.87 to 1.33 times as many, but for one in ten.

    Parameters
    ----------
    elements : float
        Of `elements_by_sample`, together.
    faces : int
        Of the part.
    """
    return FINER * elements + PER_FACE * faces


def nodes_of(elements, order):
    """The number of nodes that so many tetrahedra have together, about: int."""
    return round(NODES_OF_ORDER[order] * elements)


def solver_seconds(nodes):
    """Seconds that CalculiX takes for the first six elastic frequencies of a mesh of second order, about: float."""
    return SOLVED_SECONDS * (nodes / SOLVED_NODES) ** SOLVED_BY_NODES
