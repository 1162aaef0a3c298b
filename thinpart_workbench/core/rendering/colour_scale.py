# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours for thickness."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from .colour_maps import COLOUR_MAPS, HEX_OF_MAP

UNMEASURED = (0.62, 0.62, 0.62)
"""Colour of unmeasured surface; it occurs in none of the colour maps."""


@dataclass(frozen=True)
class ColourScale:
    """Maps thickness to colours.

    Attributes
    ----------
    low, high : float, mm
        Ends of the range; values beyond it get the colour of its end.
    colour_map : str
        One of `colour_maps.COLOUR_MAPS`.
    reversed : bool
        Whether thin walls get the colours that thick ones have otherwise.
    bands : int
        Number of steps; 0 for a smooth scale.
    unmeasured : tuple of float
        Red, green and blue from 0 to 1.
    logarithmic : bool
        Whether equal ratios of thickness, instead of equal differences, are equally far apart; only where `low` is positive.
    """

    low: float
    high: float
    colour_map: str = COLOUR_MAPS[0]
    reversed: bool = False
    bands: int = 0
    unmeasured: tuple = UNMEASURED
    logarithmic: bool = False

    @property
    def is_logarithmic(self):
        """Whether the scale really is logarithmic: a range that begins at 0 cannot be."""
        return self.logarithmic and 0.0 < self.low < self.high

    def colours(self, thickness):
        """Colours of thicknesses, array_like of shape (m,), mm, nan where unmeasured: ndarray of shape (m, 3), uint8."""
        thickness = np.asarray(thickness, dtype=np.float64)
        measured = np.isfinite(thickness)
        colours = self.bar(self.positions(np.where(measured, thickness, self.low)))
        colours[~measured] = np.round(255.0 * np.array(self.unmeasured))
        return colours

    def of_corners(self, _, shown):
        """Colours at the corners of the facets of a ThicknessMap, of any number: ndarray of shape (m, 3, 3), uint8."""
        return self.colours(shown.corner_thickness.ravel()).reshape(-1, 3, 3)

    def positions(self, thickness):
        """ndarray of shape (m,): where along the scale thicknesses in mm lie, from 0 for its low end to 1."""
        thickness = np.asarray(thickness, dtype=np.float64)
        if self.is_logarithmic:
            share = np.log(np.maximum(thickness, self.low) / self.low) / np.log(self.high / self.low)
        elif self.high > self.low:
            share = (thickness - self.low) / (self.high - self.low)
        else:
            return (thickness > self.low).astype(np.float64)
        return np.clip(share, 0.0, 1.0)

    def thickness_at(self, share):
        """ndarray of shape (m,), mm: the thicknesses at positions along the scale; the inverse of `positions`."""
        share = np.asarray(share, dtype=np.float64)
        if self.is_logarithmic:
            return self.low * (self.high / self.low) ** share
        return self.low + share * (self.high - self.low)

    @property
    def steps(self):
        """list of float, mm: the thicknesses at which the colour changes in a step, ascending; none on a smooth scale."""
        if self.bands < 2 or self.high <= self.low:
            return []
        return self.thickness_at(np.arange(1, self.bands) / self.bands).tolist()

    def bar(self, share):
        """ndarray of shape (m, 3), uint8: colours at positions along the scale, from 0 for its low end to 1."""
        share = np.asarray(share, dtype=np.float64)
        if self.bands > 0:
            step = np.minimum(np.floor(share * self.bands), self.bands - 1)
            share = (step + 0.5) / self.bands
        if self.reversed:
            share = 1.0 - share
        table = colour_table(self.colour_map)
        return table[np.round(share * (len(table) - 1)).astype(np.int64)]


@cache
def colour_table(name):
    """ndarray of shape (256, 3), uint8: a colour map, starting at its low end."""
    return np.frombuffer(bytes.fromhex(HEX_OF_MAP[name]), dtype=np.uint8).reshape(-1, 3).copy()
