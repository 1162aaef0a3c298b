# SPDX-License-Identifier: LGPL-2.1-or-later
"""The element size that keeps an analysis within an error, from the local thickness: found by `benchmarks/mesh_worth.py`."""

import numpy as np

AIM = 0.02
"""The error aimed at by default: of frequencies and deflections, with tetrahedra of second order."""

AIMS = (0.005, 0.2)
"""Least and greatest error that can be aimed at: what lies between them was measured."""

SHARE = 0.1
"""Element size by the diagonal, where the part is as thick as its diagonal is long, for the error `AIM`."""

BY_THICKNESS = 0.25
"""Exponent of the thickness, by the diagonal: a wall a hundredth as thick as another has elements a third as long. It bends
in waves as long as the part, however thin it is."""

BY_ERROR = 0.35
"""Exponent of the error aimed at, by `AIM`."""

FLAT = 6.0
"""Greatest length of an element by the thickness of its wall: flatter ones have poor shapes, and bend too stiffly."""

IGNORED = 0.05
"""Share of the surface whose thinnest places ask for no more than the rest: a knife's edge has no stiffness of its own."""


def size_for_error(thickness, diagonal, error):
    """Element size, ndarray of shape (m,), mm, of tetrahedra of second order.

    Parameters
    ----------
    thickness : ndarray of shape (m,), mm
        Local thickness.
    diagonal : float, mm
        Of the part's box.
    error : float
        Aimed at; see `AIM`.
    """
    scale = (error / AIM) ** BY_ERROR
    size = SHARE * diagonal * (thickness / diagonal) ** BY_THICKNESS
    return scale * np.minimum(size, FLAT * thickness)


def error_at(error, factor):
    """The error that is left where all sizes are larger by a factor than for the error aimed at: float."""
    return error * factor ** (1.0 / BY_ERROR)


def without_thinnest_places(size, area):
    """Sizes of which those that a small share of the surface asks for, `IGNORED`, are as large as the next: ndarray, mm.

    Parameters
    ----------
    size : ndarray of shape (m,), mm
    area : ndarray of shape (m,), mm2
    """
    order = np.argsort(size)
    reached = np.cumsum(area[order])
    return np.maximum(size, size[order][np.searchsorted(reached, IGNORED * reached[-1])])
