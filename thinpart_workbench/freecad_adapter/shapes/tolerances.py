# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far measures of the same shape may differ, with the reason for each tolerance."""

from dataclasses import dataclass


@dataclass(frozen=True)
class ShapeTolerances:
    """Tolerances, named after what happened to the shape between two measurements."""

    recomputed: float = 1e-9
    """Relative difference of measures of a shape that was computed twice from the same features: rounding alone."""

    written: float = 1e-8
    """Difference, in units of the part, from measures that were saved with nine digits: 5e-9 at most for the last
    digit, plus rounding."""

    reread: float = 1e-7
    """Relative difference of volumes and areas between two copies of a solid in an exchange file: each copy is built
    from its own numbers, with the digits that the file has."""

    moved: float = 1e-6
    """Share of the diagonal by which corresponding points of two equal solids may differ, and by which a point of a
    face may lie off it. The coarsest tolerance, because points far from the origin lose digits."""

    placed: float = 1e-7
    """Distance by which two placements may differ, as a share of the distance from the origin (at least 1 mm), and
    angle in radians. Such placements are products of the same placements in another order."""


SHAPE_TOLERANCES = ShapeTolerances()
