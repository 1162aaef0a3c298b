# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a surface mesh is fine enough for its part, and how fine the next one must be."""

from dataclasses import dataclass

import numpy as np

from ..analysis_settings import AnalysisSettings
from ..tolerances import TOLERANCES

FINEST_DEFLECTION = TOLERANCES.rounding
"""Least linear deflection of a tessellation, as a share of the diagonal."""

TURNED_SHARE = 0.25
"""Share of the surface whose facets may exceed the given angular deflection. OCC respects it only where the linear
deflection is well below the radius, so not on small fillets, nor on a long rod."""

TURNED = 4.0
"""Degrees by which the facets of that share may be turned against the surface at least: those of a rod, which are turned by
more, make opposite walls seem to be at the 10 degrees from which walls are slanted."""

_AIM = 0.4
"""Share of the allowed error to aim at, since the error counts on both sides of a wall and is an estimate."""


@dataclass(frozen=True)
class Resolution:
    """The precision of a mesh.

    Attributes
    ----------
    deflection : float, mm
        Chord error of the mesh.
    extent : float, mm
        Diagonal of the axis-aligned box of the mesh.
    rounding : float
        Additional error of the points, as a share of the extent.
    allowed : float
        Greatest error of a length, as a share of the smallest length of the part.
    """

    deflection: float
    extent: float
    rounding: float = TOLERANCES.rounding
    allowed: float = AnalysisSettings.wall_deflection

    @property
    def error(self):
        """float, mm: error of a length. Each of its ends may be off the surface by the chord error and the rounding
        error."""
        return 2.0 * (self.deflection + self.rounding * self.extent)

    def is_enough_for(self, length, chords=None):
        """Whether the chord error is small against lengths.

        Parameters
        ----------
        length : float or ndarray of shape (k,), mm, or None
            None for a length that the part does not have, for which every mesh is enough.
        chords : float or ndarray of shape (k,), mm, optional
            Chord errors at both ends together; that of the mesh at either end if not given.
        """
        return length is None or (2.0 * self.deflection if chords is None else chords) <= self.allowed * length

    def wall_error(self, chords):
        """float, mm: error of the thickness of a wall, from the chord errors at both of its ends together."""
        return chords + 2.0 * self.rounding * self.extent

    def required_deflection(self, length):
        """float, share of the diagonal: the linear deflection that is fine enough for a length, mm."""
        return max(_AIM * self.allowed * length / self.extent, FINEST_DEFLECTION)


def is_turned_too_far(mesh, angular_deflection):
    """Whether neighbouring facets are at far more than an angle, degrees, on more than `TURNED_SHARE` of a surface. Its
    walls then seem to be slanted, even if they are round."""
    turned = mesh.areas[mesh.bend > np.radians(max(TURNED, 0.6 * angular_deflection))].sum()
    return bool(turned > TURNED_SHARE * mesh.areas.sum())


def smallest_side(descriptors):
    """Find the smallest length of the body as a whole that is shown or compared with thresholds: float, mm, or None.

    In a coarse mesh of a rod the thinnest wall may be its length, so the body counts as well. Distances of slanted walls do
    not, because they go to 0 where two faces meet in an edge. Criteria allow for the error of those distances.
    """
    if descriptors.volume is None:  # an open sheet has no thickness that must be distinguished from 0
        return None
    return min(descriptors.body_thickness, float(descriptors.box.dimensions[2]))


def error_to_judge_with(lengths):
    """The error of a length, mm, where one is not small against its length; 0 otherwise.

    Parameters
    ----------
    lengths : iterable of (float or None, float), mm
        Lengths of a part and their errors; None for a length that it does not have.
    """
    most = 1.5 * AnalysisSettings.wall_deflection
    return max((error for length, error in lengths if length is not None and error > most * length), default=0.0)
