# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a thickness map is currently coloured: its scale, its threshold and its highlighted range or faces."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...core.judging.limit_bands import FAILS, JUST_ABOVE, PASSES, TOO_THICK, limit_bands
from ...core.maps.level_cuts import within_steps
from ...core.maps.map_summary import are_between
from ...core.rendering.colour_scale import ColourScale
from ...freecad_adapter.objects.thickness_object import scale_of
from .checked_facets import CheckedMaps, checked_maps, is_checked

NEUTRAL = (205, 205, 205)
"""Walls that are not thin, where only thin walls are coloured."""

BAND_COLOURS = {FAILS: (214, 38, 31), JUST_ABOVE: (250, 203, 60), PASSES: (122, 178, 226), TOO_THICK: (116, 66, 148)}
"""Walls by the limits that are checked, distinct for the colour-blind too: by `limit_bands`."""

GREYED = (214, 214, 214)
"""Facets outside the highlight; also the colour towards which an outdated map fades."""

_FADED = 0.65


@dataclass(frozen=True)
class ThicknessColours:
    """Colours of both the facets and the colour bar, so that the two always agree.

    Attributes
    ----------
    scale : ColourScale
    thin_below : float or None, mm
        Set where only thin walls are coloured.
    checked : tuple of float or None, mm
        Least and greatest wall of the process that is checked, 0 for any; colours are those of `limit_bands` then.
        None where balls are shown and the limits are those of a process, which are of the wall across.
    stale : bool
        Whether the colours are faded.
    between : tuple of float or None, mm
        The highlighted range.
    faces : dict or None
        Sets of highlighted B-Rep faces, by part number.
    maps : CheckedMaps or None
        Facets as they are compared with the limits that are checked.
    """

    scale: ColourScale
    thin_below: Optional[float] = None
    checked: Optional[tuple] = None
    stale: bool = False
    between: Optional[tuple] = None
    faces: Optional[dict] = None
    maps: Optional[CheckedMaps] = None

    @classmethod
    def of(cls, thickness, between=None, faces=None):
        """The colours of a thickness object."""
        return cls(scale_of(thickness), thickness.Threshold if thickness.ThinOnly else None,
                   (thickness.Threshold, thickness.CheckMost) if is_checked(thickness) else None,
                   bool(thickness.Stale), between, faces, checked_maps(thickness))

    @property
    def bands(self):
        """list of LimitBand: those of the limits that are checked; empty where none are."""
        return [] if self.checked is None else limit_bands(*self.checked)

    def compared(self, number, shown):
        """The map of a part with thicknesses as they are compared with the limits that are checked: ThicknessMap."""
        return shown if self.maps is None else self.maps.of_parts[number].compared

    def are_thick(self, number):
        """Which facets of a part are too thick: ndarray of shape (m,), bool, or None where that is not checked."""
        return None if self.maps is None else self.maps.are_thick(number)

    def are_failing(self, values):
        """Which thicknesses, mm, are under the least wall that is checked: ndarray of bool. That is told before a ball."""
        failing = next((band for band in self.bands if band.name == FAILS), None)
        return np.zeros(np.shape(values), bool) if failing is None else are_between(values, failing.low, failing.high)

    def of_values(self, values, are_thick=None):
        """Colours of thicknesses in mm, nan where unmeasured: ndarray of shape (m, 3), uint8.

        Parameters
        ----------
        values : array_like of shape (m,), mm
            Across the wall, or of balls where these are shown.
        are_thick : ndarray of shape (m,), bool, optional
            Where balls are larger than the greatest wall that is checked: the values do not tell that.
        """
        values = np.asarray(values, dtype=np.float64)
        colours = self.scale.colours(values)
        if self.checked is not None:
            for band in self.bands:
                if band.name != TOO_THICK:
                    colours[are_between(values, band.low, band.high)] = BAND_COLOURS[band.name]
            if are_thick is not None:
                colours[are_thick & ~self.are_failing(values)] = BAND_COLOURS[TOO_THICK]
        elif self.thin_below is not None:
            colours[are_between(values, self.thin_below, np.inf)] = NEUTRAL
        if self.between is not None:
            colours[~are_between(values, *self.between)] = GREYED
        return self._faded(colours)

    @property
    def levels(self):
        """tuple of float, mm: the thicknesses at which the colour changes in a step, ascending."""
        if self.checked is not None:
            found = [band.low for band in self.bands if band.name != TOO_THICK]
        else:
            found = [*self.scale.steps, *([] if self.thin_below is None else [self.thin_below])]
        if self.between is not None:
            found += self.between
        return tuple(sorted({float(each) for each in found if 0.0 < each < np.inf}))

    def of_corners(self, number, shown, cut=None):
        """Colours of the corners of the facets of a part's map: ndarray of shape (m, 3, 3), uint8.

        Parameters
        ----------
        number : int
            Of the part.
        shown : ThicknessMap
        cut : LevelCuts or MapSection, optional
            Pieces of the facets of the `compared` map, or lines on them, cut at `levels`: their corners or ends, ndarray of
            shape (k, 2, 3) for lines, are coloured instead.
        """
        shown = self.compared(number, shown)
        facet = np.arange(shown.count) if cut is None else cut.facet
        thickness, levels = shown.corner_thickness if cut is None else cut.thickness, self.levels
        values = within_steps(thickness, levels) if levels else thickness
        are_thick = self.are_thick(number)
        are_thick = None if are_thick is None else np.repeat(are_thick[facet], values.shape[1])
        colours = self.of_values(values.ravel(), are_thick).reshape(*values.shape, 3)
        if self.faces is not None:
            chosen = np.fromiter(self.faces.get(number, ()), dtype=np.int64)
            colours[~np.isin(shown.face[facet], chosen)] = GREYED
        return colours

    def _faded(self, colours):
        if not self.stale:
            return colours
        faded = (1.0 - _FADED) * colours + _FADED * np.array(GREYED)
        return np.round(faded).astype(np.uint8)
