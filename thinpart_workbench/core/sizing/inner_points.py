# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points within a part, each of which stands for a piece of its volume."""

from dataclasses import dataclass

import numpy as np

_PLACES, _WEIGHTS = np.polynomial.legendre.leggauss(5)
"""Between the surface and the middle of the wall, from -1 to 1."""


@dataclass(frozen=True)
class InnerPoints:
    """Points under the samples of the surface, as far as half-way through the wall.

    Attributes
    ----------
    points : ndarray of shape (d, k, 3), mm
        Depth, sample; in the coordinates of the document.
    volumes : ndarray of shape (d, k), mm3
        Together the volume of the part, where it is known.
    sample : ndarray of shape (k,), int64
        Of the field.
    areas, halves : ndarray of shape (k,), mm2 and mm
        Of the surface that each sample stands for; from there to the middle of the wall.
    """

    points: np.ndarray
    volumes: np.ndarray
    sample: np.ndarray
    areas: np.ndarray
    halves: np.ndarray


def inner_points(measurement):
    """Spread points over the inside of a part, densely under its surface: InnerPoints.

    The wall under a sample belongs to it as far as its middle; the other half belongs to the opposite side. What no sample
    sees, in corners, counts as the rest does.
    """
    field, volume = measurement.field, measurement.descriptors.volume
    sample = np.flatnonzero((field.area > 0.0) & np.isfinite(field.distance))
    here, inward = field.samples.points[sample] + field.mesh.origin, -field.normals[sample]
    half = 0.5 * field.distance[sample] * np.cos(np.minimum(field.wedge_angle[sample], 0.5 * np.pi))
    under = field.area[sample] * half
    total = under.sum()
    scale = volume / total if volume and total > 0.0 else 1.0
    depths = 0.5 * (1.0 + _PLACES)[:, None] * half
    return InnerPoints(here + depths[:, :, None] * inward, 0.5 * scale * _WEIGHTS[:, None] * under, sample,
                       field.area[sample], half)
