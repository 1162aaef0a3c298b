"""How many elements a size field leads to."""

import numpy as np

PER_CUBE = 4.9
"""Tetrahedra of Gmsh in a cube as long as their size: its edges get longer. Regular ones would be 8.5."""


def elements_by_sample(inner, size_field, count):
    """Estimate the number of tetrahedra under each sample of the surface.

    Parameters
    ----------
    inner : InnerPoints
    size_field : SizeField
    count : int
        Number of samples.

    Returns
    -------
    ndarray of shape (count,)
    """
    elements = np.zeros(count)
    sizes = size_field.at(inner.points.reshape(-1, 3)).reshape(inner.volumes.shape)
    elements[inner.sample] = PER_CUBE * np.sum(inner.volumes * sizes ** -3.0, axis=0)
    return elements
