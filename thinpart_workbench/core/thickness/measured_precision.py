# SPDX-License-Identifier: LGPL-2.1-or-later
"""How precisely a part was measured, from its mesh and its samples."""

import numpy as np

from ..descriptors.precision import CORRECTED, OF_AREA, Precision

_CERTAIN = 0.95
"""Share of the surface whose thicknesses have at most the error that is stated."""


def precision_of(measurement, deflections, accuracy):
    """Estimate the precision of a measurement: Precision.

    Parameters
    ----------
    measurement : Measurement
    deflections : ndarray of shape (f,), mm
        Chord error of each face.
    accuracy : str
        One of `ACCURACIES`.
    """
    field = measurement.field
    mesh = field.mesh
    chord = _chord_errors(mesh, deflections)
    counted = np.flatnonzero((field.area > 0.0) & (field.opposite >= 0))
    wall = CORRECTED * chords_of(field, counted, deflections)
    order = np.argsort(wall)
    reached = np.cumsum(field.area[counted][order])
    rounding = 2.0 * mesh.rounding * mesh.extent
    most = float(wall[order[np.searchsorted(reached, _CERTAIN * reached[-1])]]) if len(order) else 0.0
    area = mesh.areas.sum()
    return Precision(
        accuracy, max(1, int(np.count_nonzero(field.area > 0.0))), most + rounding, float(chord.max()) + 0.5 * rounding,
        float(mesh.areas @ chord / area) + 0.5 * rounding,
        float(OF_AREA * (mesh.areas @ mesh.bend ** 2) / area) + 2.0 * mesh.rounding,
        measurement.regions.plate_share_error, measurement.slanted_error,
    )


def chords_of(field, samples, deflections):
    """Chord errors of the facets at both ends of walls, together: ndarray of shape (k,), mm.

    Parameters
    ----------
    field : ThicknessField
    samples : ndarray of shape (k,), int64
        Those whose rays hit something.
    deflections : ndarray of shape (f,), mm
        Chord error of each face, or of all of them.
    """
    chord = _chord_errors(field.mesh, deflections)
    return chord[field.samples.triangle[samples]] + chord[field.opposite[samples]]


def _chord_errors(mesh, deflections):
    """Chord error of each triangle, mm: ndarray of shape (n,)."""
    return deflections[mesh.face_of_triangle] if len(deflections) > 1 else np.full(mesh.count, float(deflections.max()))
