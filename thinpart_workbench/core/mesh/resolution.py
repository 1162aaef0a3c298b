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

    def is_enough_for(self, length):
        """Whether the chord error is small against a length, mm. True for None, a length that the part does not have."""
        return length is None or 2.0 * self.deflection <= self.allowed * length

    def required_deflection(self, length):
        """float, share of the diagonal: the linear deflection that is fine enough for a length, mm."""
        return max(_AIM * self.allowed * length / self.extent, FINEST_DEFLECTION)


def is_turned_too_far(mesh, angular_deflection):
    """Whether neighbouring facets are at far more than an angle, degrees, on more than `TURNED_SHARE` of a surface. Its
    walls then seem to be slanted, even if they are round."""
    turned = mesh.areas[mesh.bend > np.radians(max(TURNED, 0.6 * angular_deflection))].sum()
    return bool(turned > TURNED_SHARE * mesh.areas.sum())


def smallest_length(descriptors, thinnest):
    """Find the smallest length that is shown or compared with thresholds: float, mm, or None.

    Parameters
    ----------
    descriptors : Descriptors
    thinnest : float or None, mm
        The thinnest wall. In a coarse mesh of a rod that may be its length, so other lengths are included.

    Notes
    -----
    Distances of slanted walls are not included, because they go to 0 where two faces meet in an edge. Criteria allow
    for the error of those distances.
    """
    lengths = [] if thinnest is None else [thinnest]
    if descriptors.volume is not None:  # an open sheet has no thickness that must be distinguished from 0
        lengths += [descriptors.body_thickness, float(descriptors.box.dimensions[2])]
    return min(lengths, default=None)


def error_to_judge_with(error, smallest):
    """The error of a length, mm, if it is not small against the part; 0 if it is.

    Parameters
    ----------
    error : float, mm
    smallest : float or None, mm
    """
    return error if smallest is not None and error > 1.5 * AnalysisSettings.wall_deflection * smallest else 0.0
