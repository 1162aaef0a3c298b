"""The measured quantities of a part, and the one table of their names.

The command line judges and lists what workers measured, and starts in half the time without numpy
and scipy: what stands here for annotations only is not imported.
"""

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from .bounds import OrientedBox
    from .distribution import Distribution

STATED_FLOOR = 0.0001
"""Share of the area under which a finding is a stray ray; what `min_nonparallel` is stated at."""

STATED_ANGLES = (10, 55)
"""Wedge angles, degrees, between which it is stated (Giannini et al. 2012, 5.2)."""

REPORTED_SHARES = ((0.0, 0.05), (0.0, 0.25), (0.05, 0.29), (0.3, 0.7))
"""The samples of the distribution that the paper keeps in its info file (section 6)."""


@dataclass(frozen=True)
class Descriptors:
    """What was measured on a part. No threshold enters.

    Attributes
    ----------
    volume : float or None, mm3
        None where the surface is not watertight.
    area : float, mm2
    box : OrientedBox
    distribution : Distribution
    min_nonparallel : float or None
        Least distance between slanted walls, in diagonals, at `STATED_FLOOR` and `STATED_ANGLES`.
        At any other it is read off the distribution, to 0.001.
    """

    volume: Optional[float]
    area: float
    box: "OrientedBox"
    distribution: "Distribution"
    min_nonparallel: Optional[float]

    @property
    def unmet(self):
        """float: share of the area about which nothing is known; see `Distribution.unmet`."""
        return self.distribution.unmet

    def value(self, quantity, area_floor=STATED_FLOOR):
        """Value of a named quantity.

        Parameters
        ----------
        quantity : str
            A name or symbol of `QUANTITIES`, with its bounds where it has some: ``F[0;0.25]``.
        area_floor : float
            Area share below which non-parallel walls are stray.

        Returns
        -------
        float or None
            None where it could not be measured.

        Raises
        ------
        KeyError
            When there is no such quantity.
        """
        return quantity_named(quantity).evaluate(self, area_floor)


@dataclass(frozen=True)
class Quantity:
    """A quantity as a profile, a search or a panel names it.

    Attributes
    ----------
    name : str
        Key in the info file.
    symbol : str
        As the paper writes it.
    unit : str
        Empty for a ratio.
    meaning : str
        One line for people.
    bounds : tuple of float
        Breakpoints of x, or wedge angles in degrees, for a quantity that has some.
    absent_means : float or None
        Value that a comparison takes when there is none to measure (no wedge: infinitely far);
        None where absence means unknown.
    """

    name: str
    symbol: str
    unit: str
    meaning: str
    bounds: tuple = ()
    absent_means: Optional[float] = None

    def evaluate(self, descriptors, area_floor):
        """float or None: the value of this quantity."""
        return _EVALUATE[self.name](descriptors, area_floor, *self.bounds)

    @property
    def is_area_share(self):
        """Whether it counts surface: "more than 0" then means more than the area floor, and what
        was not measured may add to it."""
        return self.name == "F"


def _ratio(numerator, denominator):
    if numerator is None or denominator <= 0.0:
        return None
    return float(numerator / denominator)


def _nonparallel_minimum(descriptors, floor, low, high):
    if floor == STATED_FLOOR and (low, high) == STATED_ANGLES:
        return descriptors.min_nonparallel
    return descriptors.distribution.nonparallel_minimum(floor, low, high)


_EVALUATE = {
    "volume_mm3": lambda d, floor: d.volume,
    "area_mm2": lambda d, floor: d.area,
    "d1_mm": lambda d, floor: float(d.box.dimensions[0]),
    "d2_mm": lambda d, floor: float(d.box.dimensions[1]),
    "d3_mm": lambda d, floor: float(d.box.dimensions[2]),
    "diagonal_mm": lambda d, floor: d.box.diagonal,
    "volume_ratio": lambda d, floor: _ratio(d.volume, d.box.volume),
    "d1_d2": lambda d, floor: _ratio(d.box.dimensions[0], d.box.dimensions[1]),
    "d2_d3": lambda d, floor: _ratio(d.box.dimensions[1], d.box.dimensions[2]),
    "F": lambda d, floor, low, high: d.distribution.share(low, high),
    "min_nonparallel": _nonparallel_minimum,
    "parallel": lambda d, floor: d.distribution.parallel,
    "nonparallel": lambda d, floor: d.distribution.nonparallel,
    "unmeasured": lambda d, floor: d.distribution.unmeasured,
    "unmet": lambda d, floor: d.distribution.unmet,
}

QUANTITIES = (
    Quantity("volume_mm3", "V", "mm3", "Volume of the part"),
    Quantity("area_mm2", "A", "mm2", "Area of its surface"),
    Quantity("d1_mm", "D1", "mm", "Longest side of the bounding box"),
    Quantity("d2_mm", "D2", "mm", "Middle side of the bounding box"),
    Quantity("d3_mm", "D3", "mm", "Shortest side of the bounding box"),
    Quantity("diagonal_mm", "diag", "mm", "Diagonal of the bounding box"),
    Quantity("volume_ratio", "V/VBB", "", "Share of the bounding box that the part fills"),
    Quantity("d1_d2", "D1/D2", "", "Longest to middle side of the bounding box"),
    Quantity("d2_d3", "D2/D3", "", "Middle to shortest side of the bounding box"),
    Quantity("F", "F", "", "Share of the area over walls of a thickness from a to b diagonals",
             bounds=(0.0, 1.0)),
    Quantity("min_nonparallel", "min_nonparallel", "",
             "Least distance, in diagonals, between walls at a to b degrees",
             bounds=(10, 55), absent_means=math.inf),
    Quantity("parallel", "parallel", "", "Share of the area over parallel walls"),
    Quantity("nonparallel", "nonparallel", "", "Share of the area over non-parallel walls"),
    Quantity("unmeasured", "unmeasured", "", "Share of the area with no wall opposite"),
    Quantity("unmet", "unmet", "", "Share of the area whose ray met nothing at all"),
)

_BY_NAME = {key: quantity for quantity in QUANTITIES for key in (quantity.name, quantity.symbol)}
_BOUNDED = re.compile(r"^\s*([A-Za-z_]+)\s*\[\s*([0-9.]+)\s*[;:,]\s*([0-9.]+)\s*\]\s*$")


def quantity_named(text):
    """The `Quantity` that a text names, such as ``V/VBB``, ``d2_d3`` or ``F[0;0.25]``.

    Raises
    ------
    KeyError
        When there is no such quantity or its bounds are not in order.
    """
    bounded = _BOUNDED.match(text)
    quantity = _BY_NAME.get(bounded.group(1) if bounded else text.strip())
    if quantity is None or (bounded is not None) != bool(quantity.bounds):
        raise KeyError(text)
    if bounded is None:
        return quantity
    low, high = float(bounded.group(2)), float(bounded.group(3))
    if not low < high:
        raise KeyError(text)
    return Quantity(quantity.name, text.strip(), quantity.unit, quantity.meaning, (low, high),
                    quantity.absent_means)
