"""Colours that stand for thickness."""

import json
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

COLOUR_MAPS = ("viridis", "cividis", "plasma", "inferno", "magma")
"""Perceptually uniform, and told apart by people who see no red or no green."""

UNMEASURED = (0.62, 0.62, 0.62)
"""Colour of what could not be measured: none of a colour map's."""

_TABLES = Path(__file__).resolve().parents[2] / "resources" / "colour_maps.json"


@dataclass(frozen=True)
class ColourScale:
    """From thickness to colours.

    Attributes
    ----------
    low, high : float, mm
        Ends of the range; what lies beyond has the colour of the end.
    colour_map : str
        One of `COLOUR_MAPS`.
    reversed : bool
        Thin walls have the colours that thick ones have otherwise.
    bands : int
        Number of steps; 0 for a smooth scale.
    unmeasured : tuple of float
        Red, green and blue from 0 to 1.
    """

    low: float
    high: float
    colour_map: str = COLOUR_MAPS[0]
    reversed: bool = False
    bands: int = 0
    unmeasured: tuple = UNMEASURED

    def colours(self, thickness):
        """Colours of values.

        Parameters
        ----------
        thickness : array_like of shape (m,), mm
            nan where nothing was measured.

        Returns
        -------
        ndarray of shape (m, 3), uint8
        """
        thickness = np.asarray(thickness, dtype=np.float64)
        measured = np.isfinite(thickness)
        span = self.high - self.low
        share = np.where(measured, thickness, self.low) - self.low
        share = np.clip(share / span, 0.0, 1.0) if span > 0.0 else (share > 0.0).astype(float)
        colours = self.bar(share)
        colours[~measured] = np.round(255.0 * np.array(self.unmeasured))
        return colours

    def bar(self, share):
        """Colours along the scale, from 0 for its low end to 1: ndarray of shape (m, 3), uint8."""
        share = np.asarray(share, dtype=np.float64)
        if self.bands > 0:
            step = np.minimum(np.floor(share * self.bands), self.bands - 1)
            share = (step + 0.5) / self.bands
        if self.reversed:
            share = 1.0 - share
        table = colour_table(self.colour_map)
        return table[np.round(share * (len(table) - 1)).astype(np.int64)]


@lru_cache(maxsize=None)
def colour_table(name):
    """ndarray of shape (256, 3), uint8: a colour map from its low end on."""
    with open(_TABLES, encoding="utf-8") as file:
        text = json.load(file)["maps"][name]
    return np.frombuffer(bytes.fromhex(text), dtype=np.uint8).reshape(-1, 3).copy()
