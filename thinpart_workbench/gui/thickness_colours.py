"""What a thickness map is coloured by at a moment: its scale, its threshold, and what is pointed out."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..core.colour_scale import ColourScale
from ..core.map_summary import are_between
from ..freecad_adapter.thickness_object import scale_of

NEUTRAL = (205, 205, 205)
"""Walls that are not thin, where only those are asked for."""

GREYED = (176, 176, 176)
"""What is not pointed out, and what colours fade to where the map is out of date."""

_FADED = 0.65


@dataclass(frozen=True)
class ThicknessColours:
    """Colours of facets and of the colour bar, which so always agree.

    Attributes
    ----------
    scale : ColourScale
    thin_below : float or None, mm
        Where only thin walls are coloured.
    stale : bool
        Faded.
    between : tuple of float or None, mm
        The range that is pointed out.
    faces : dict or None
        Set of B-Rep faces that are pointed out, by the number of the part.
    """

    scale: ColourScale
    thin_below: Optional[float] = None
    stale: bool = False
    between: Optional[tuple] = None
    faces: Optional[dict] = None

    @classmethod
    def of(cls, thickness, between=None, faces=None):
        """Those of a thickness object."""
        return cls(scale_of(thickness), thickness.Threshold if thickness.ThinOnly else None,
                   bool(thickness.Stale), between, faces)

    def of_values(self, values):
        """Colours of thicknesses in mm, nan where nothing was measured: ndarray of shape (m, 3), uint8."""
        values = np.asarray(values, dtype=np.float64)
        colours = self.scale.colours(values)
        if self.thin_below is not None:
            colours[are_between(values, self.thin_below, np.inf)] = NEUTRAL
        if self.between is not None:
            colours[~are_between(values, *self.between)] = GREYED
        return self._faded(colours)

    def of_facets(self, number, shown):
        """Colours of the facets of a part's map: ndarray of shape (m, 3), uint8."""
        colours = self.of_values(shown.thickness)
        if self.faces is not None:
            chosen = np.fromiter(self.faces.get(number, ()), dtype=np.int64)
            colours[~np.isin(shown.face, chosen)] = GREYED
        return colours

    def _faded(self, colours):
        if not self.stale:
            return colours
        faded = (1.0 - _FADED) * colours + _FADED * np.array(GREYED)
        return np.round(faded).astype(np.uint8)
