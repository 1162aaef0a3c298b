# SPDX-License-Identifier: LGPL-2.1-or-later
"""How precisely a part was measured, and the errors of quantities that follow from it."""

import math
from dataclasses import dataclass, replace

SAMPLING, STRATIFIED = 3.3, -0.6
"""Error of a share p of the surface by n samples: `SAMPLING` sqrt(p (1 - p)) n ^ `STRATIFIED`. Random samples would have the
power -0.5; those that are spread evenly err along the border of the share only. Both are fitted to real parts, so that 95 %
of the errors are smaller (benchmarks/accuracy.py)."""

CORRECTED = 0.25
"""Share of the chord error that is left in a thickness, where both sides are taken as the smooth surfaces."""

OF_VOLUME = 0.06
"""Share of the chord error that is left in the volume, for which every facet is corrected."""

OF_AREA = 2.4
"""Share of the squared angle between facets and their surface by which the area of the facets may be off: they fall short of
a convex surface and make up for it at holes, so that parts differ."""


BALLS = 2000
"""Places of the surface, each for the same area, whose largest balls make the local thickness, at any accuracy."""


@dataclass(frozen=True)
class Precision:
    """Of a measurement.

    Attributes
    ----------
    accuracy : str
        The one of `ACCURACIES` at which the part was measured at last.
    samples : int
        That represent area.
    wall_mm : float
        Error of a thickness: 95 % of the surface have less.
    chord_mm : float
        Greatest distance between a facet and its face.
    mean_chord_mm : float
        The mean by area.
    area_share : float
        Relative error of the area.
    plate_share : float
        Error of the share of plates, as far as the widths of walls are not certain.
    slanted : float
        Error of the least distance of slanted walls, in diagonals, as far as the search for it was ended.
    """

    accuracy: str
    samples: int
    wall_mm: float
    chord_mm: float
    mean_chord_mm: float
    area_share: float
    plate_share: float = 0.0
    slanted: float = 0.0

    @property
    def of_balls(self):
        """Precision: that of shares which are known from `BALLS` places."""
        return replace(self, samples=min(self.samples, BALLS))

    def at(self, samples, turned=1.0):
        """What to expect of more samples, and of facets at so many times the angle to each other: `Precision`."""
        chord, samples = turned ** 2, max(samples, self.samples)
        return replace(
            self, samples=samples, wall_mm=chord * self.wall_mm, chord_mm=chord * self.chord_mm,
            mean_chord_mm=chord * self.mean_chord_mm, area_share=chord * self.area_share,
            slanted=self.slanted * (samples / self.samples) ** STRATIFIED)

    def with_blurred_lengths(self, error, body):
        """What is known where the mesh does not resolve lengths: `Precision`.

        Parameters
        ----------
        error : float, mm
            Of any length.
        body : float or None, mm
            Thickness of the body, by whose error the area is off.
        """
        return replace(
            self, wall_mm=max(self.wall_mm, error), chord_mm=max(self.chord_mm, error / (2.0 * CORRECTED)),
            mean_chord_mm=max(self.mean_chord_mm, error / (2.0 * OF_VOLUME)),
            area_share=self.area_share if body is None else max(self.area_share, error / body))

    @property
    def side_mm(self):
        """float: error of a side of the box, both ends of which may be on facets."""
        return 2.0 * CORRECTED * self.chord_mm

    def volume_mm3(self, area):
        """float: error of the volume under an area, mm2, of curved surface taken for smooth."""
        return OF_VOLUME * self.mean_chord_mm * area

    def of_share(self, value):
        """float: error of a share of the surface, because only samples of it were looked at."""
        spread = max(value * (1.0 - value), 1.0 / self.samples)
        return SAMPLING * math.sqrt(spread) * self.samples ** STRATIFIED


EXACT = Precision("", 10 ** 18, 0.0, 0.0, 0.0, 0.0)
"""Where nothing but the error of lengths is known."""
