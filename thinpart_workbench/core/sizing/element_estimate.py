"""How many elements a size field leads to."""

import numpy as np

PER_CUBE = 4.9
"""Tetrahedra of Gmsh in a cube as long as their size: its edges get longer. Regular ones would be 8.5."""

PER_SQUARE = 3.6
"""Tetrahedra of Gmsh under a square as long as their size, on either side of a wall that is thinner than 1.4 sizes: a single
layer of flat ones reaches from side to side, however thin the wall is. Three fill a prism, on 2.3 triangles for a square."""


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
