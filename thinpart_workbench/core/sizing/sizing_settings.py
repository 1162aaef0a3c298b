# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wanted of a mesh: the settings of a size proposal, in one table."""

import math
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ..descriptors.automatic_mesh import AUTOMATIC_SHARE
from ..errors import ThinPartError
from ..message import message
from .error_law import AIM, AIMS

LEAST_ERROR, MOST_ERROR = AIMS
"""Of those that can be aimed at."""

GLOBAL_SHARE = AUTOMATIC_SHARE
"""Greatest element size as a share of the diagonal."""

LAYERS_OF_ORDER = {1: 2.0, 2: 1.0}
"""Elements through a wall by the order of the elements: one of second order bends as well as two of the first."""

BRIDGING = 1.15
"""Sizes in the thickness of a wall by its layers, from two on. Edges of tetrahedra get longer than their size: with two
sizes in the thickness, half of a wall has edges from side to side; with 2.3, less than a tenth."""

LEAST_SHARE = 0.0005
"""Least element size as a share of the diagonal: what is smaller is a flaw of the model, not a wall."""

_MOST_LAYERS, _GROWTHS = 20.0, (1.05, 3.0)


@dataclass(frozen=True)
class SizingSettings:
    """Settings of a proposal. Raises ThinPartError, kind ``usage`` if a value is out of range.

    Attributes
    ----------
    order : int
        Of the elements, 1 or 2.
    error : float or None
        Of an analysis, aimed at; it decides the sizes of elements of second order where no layers are named. None for
        layers.
    layers : float or None
        Elements through the thickness of a thin wall; None for that of `LAYERS_OF_ORDER`.
    growth : float
        Greatest ratio of the sizes of neighbouring elements.
    size : float or None, mm
        Greatest element size; None for `GLOBAL_SHARE` of the diagonal.
    budget : int or None
        Most elements.
    """

    order: int = 2
    error: Optional[float] = AIM
    layers: Optional[float] = None
    growth: float = 1.5
    size: Optional[float] = None
    budget: Optional[int] = None

    def __post_init__(self):
        if self.order not in LAYERS_OF_ORDER:
            raise ThinPartError(message("The order of elements is 1 or 2, not {value}.", value=self.order), "usage")
        if self.error is not None and not LEAST_ERROR <= self.error <= MOST_ERROR:
            raise ThinPartError(message("The error aimed at is from {least:g} to {most:g} %, not {value:g} %.",
                                        least=100.0 * LEAST_ERROR, most=100.0 * MOST_ERROR,
                                        value=100.0 * self.error), "usage")
        if self.layers is not None and not 0.1 <= self.layers <= _MOST_LAYERS:
            raise ThinPartError(message("Layers are from 0.1 to {most:g}, not {value:g}.", most=_MOST_LAYERS,
                                        value=self.layers), "usage")
        if not _GROWTHS[0] <= self.growth <= _GROWTHS[1]:
            raise ThinPartError(message("The growth from element to element is from {least:g} to {most:g}, not {value:g}.",
                                        least=_GROWTHS[0], most=_GROWTHS[1], value=self.growth), "usage")
        if self.size is not None and not 0.0 < self.size < float("inf"):
            raise ThinPartError(message("The greatest element size is more than 0 mm, not {value:g}.", value=self.size),
                                "usage")
        if self.budget is not None and self.budget < 1:
            raise ThinPartError(message("A budget is at least 1 element, not {value}.", value=self.budget), "usage")

    @property
    def is_by_error(self):
        """bool: whether sizes follow from the error aimed at, not from layers."""
        return self.error is not None and self.order == 2 and self.layers is None

    @property
    def wanted_layers(self):
        """float: the layers, those of the order where none were named."""
        return LAYERS_OF_ORDER[self.order] if self.layers is None else self.layers

    @property
    def divisions(self):
        """float: the thickness of a thin wall by the element size there."""
        return divisions_of(self.wanted_layers)

    def global_size(self, diagonal):
        """float, mm: the greatest element size in a part with a box of this diagonal, mm."""
        return GLOBAL_SHARE * diagonal if self.size is None else self.size


def divisions_of(layers):
    """Thickness by element size at which a wall gets so many layers."""
    # A single layer may reach from side to side.
    return layers * float(np.interp(layers, (1.0, 2.0), (1.0, BRIDGING)))


def layers_of(divisions):
    """Layers that a wall gets whose thickness is so many element sizes: the inverse of `divisions_of`."""
    if divisions <= 1.0 or divisions >= divisions_of(2.0):
        return divisions / (1.0 if divisions <= 1.0 else BRIDGING)
    # layers (1 + (layers - 1) (BRIDGING - 1)) = divisions
    rise = BRIDGING - 1.0
    return (rise - 1.0 + math.sqrt((1.0 - rise) ** 2 + 4.0 * rise * divisions)) / (2.0 * rise)
