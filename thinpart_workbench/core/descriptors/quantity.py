# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measured quantities: the base class and its kinds. `descriptor_table` has the table of them."""

import math
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Callable, Optional

from ..kinds.typed_kinds import kind_of
from ..kinds.value_kinds import LARGEST, LARGEST_WHOLE, Number, OrNull
from ..tolerances import TOLERANCES
from .bins import BINS
from .descriptor_types import DescriptorsRecord
from .equal_walls import SAME

_BY_NAME = (None,)
"""Placeholder for the keys of a quantity whose only key is its name."""

BLURRED = 0.2
"""Length error, as a share of a thickness bound, up to which a result that it could reverse is given as borderline."""

THICK_FROM = 0.3
"""From this x on, walls belong to the thick body beside a thin feature (criterion 6 of the paper)."""


@dataclass(frozen=True)
class Quantity:
    """A quantity that profiles, searches and panels refer to.

    Attributes
    ----------
    name : str
        Key in the info file.
    symbol : str
        As in the paper.
    unit : str
        Empty for a ratio.
    meaning : str
        One line of explanation for people.
    compute : callable
        Returns the value, float or None. Called with the `Descriptors`, and for a quantity with bounds also with the
        area floor and the two bounds.
    bounds : tuple of float
        Bounds of x, or wedge angles in degrees; empty for a quantity without bounds.
    absent_means : float or None
        Value to compare with when there is nothing to measure (no wedge: infinitely far); None where absence means
        unknown.
    keys : tuple of str and int
        Path of its value in a record's ``descriptors``, outermost key first; by default the name. Empty for a
        quantity that is computed from the distribution.
    in_table : bool
        Whether the CSV table has a column for it.
    error_of : callable, optional
        Returns how far the value may be off. Called with the `Descriptors`, their `Precision` and the value.
    """

    name: str
    symbol: str
    unit: str
    meaning: str
    compute: Callable
    bounds: tuple = ()
    absent_means: Optional[float] = None
    keys: tuple = _BY_NAME
    in_table: bool = True
    error_of: Optional[Callable] = field(default=None, compare=False)

    def __post_init__(self):
        if self.keys == _BY_NAME:
            object.__setattr__(self, "keys", (self.name,))

    @cached_property
    def kind(self):
        """Kind: of its value in a record."""
        kind = kind_of(DescriptorsRecord)
        if not self.keys or len(self.keys) == 1 and self.keys[0] not in kind.kinds:
            return OrNull(Number())
        for key in self.keys:
            kind = kind.kinds[key]
        return kind

    @property
    def record_key(self):
        """str: the key of a record's ``descriptors`` that it is read from. Where a record of an earlier version lacks it,
        the quantity is computed from others, less exactly, or not known."""
        return self.keys[0] if self.keys else "distribution"

    is_area_share = False
    """Whether it is a share of the surface: "more than 0" then means more than the area floor, and unmeasured surface
    may add to it."""

    def is_only_blurred(self, descriptors):
        """Whether the error of lengths is small enough to give an answer where it could turn it, though a borderline one."""
        return False

    def margin(self, relative, threshold, descriptors):
        """How far a value lies from its threshold, relative to it, where the quantity knows better than by that: float.

        Parameters
        ----------
        relative : float
            The difference, relative to the threshold, positive where the condition holds.
        threshold : float
        descriptors : Descriptors
        """
        return relative

    thin_where = ">"
    """Comparison of the conditions on it that say that a part is thin."""

    def thin_bound(self, threshold, descriptors):
        """The x under which walls count as thin by a condition on this quantity: float, or None if it says nothing.

        Parameters
        ----------
        threshold : float
            Of the condition.
        descriptors : Descriptors
        """
        return None

    def error(self, descriptors, area_floor):
        """float or None: how far the value may be off, with a probability of 95 %; None where that is not known, infinite
        where lengths may be off by more than half of the body."""
        if descriptors.is_unresolved:
            return math.inf
        value, precision = self.evaluate(descriptors, area_floor), descriptors.resolved_precision
        return None if value is None or precision is None else self._error(descriptors, precision, value)

    @property
    def has_error(self):
        """Whether its error can be known."""
        return self.error_of is not None or type(self)._error is not Quantity._error

    def _error(self, descriptors, precision, value):
        return None if self.error_of is None else self.error_of(descriptors, precision, value)

    is_wall_distance = False
    """Whether it is the least distance between walls of some kind, which need not exist: surface about which nothing
    is known may have nearer ones."""

    @property
    def limits(self):
        """Least and greatest value that any part can have: two floats, infinite where there is no bound."""
        kind = self.kind.kind if isinstance(self.kind, OrNull) else self.kind
        least, most = getattr(kind, "least", -math.inf), getattr(kind, "most", math.inf)
        least = 0.0 if 0.0 < least <= 1.0 / LARGEST else least
        return (least if least > -LARGEST else -math.inf), (most if most < LARGEST_WHOLE else math.inf)

    def is_never_more_than(self, other):
        """Whether no part has more of this quantity than of another one, or of the same one with other bounds."""
        return (self.name, self.bounds) == (other.name, other.bounds)

    def evaluate(self, descriptors, area_floor):
        """float or None: the value of this quantity."""
        return self.compute(descriptors, area_floor, *self.bounds) if self.bounds else self.compute(descriptors)

    def bounded(self, symbol, low, high):
        """The same quantity with other bounds and the symbol for them."""
        return replace(self, symbol=symbol, bounds=(low, high))

    def recorded(self, content):
        """Look up the value in a record's ``descriptors``, at the bounds of the table.

        Raises KeyError if the version that wrote the record did not have the quantity.
        """
        for key in self.keys:
            content = content[key]
        return content

    def rounding_share(self, descriptors):
        """float: share of the value within which two values count as equal, because of rounding."""
        return 0.0


@dataclass(frozen=True)
class BoxRatio(Quantity):
    """A ratio of sides of the bounding box.

    Attributes
    ----------
    sides : tuple of int
        Indices of those sides among the dimensions of the box, longest first.
    """

    sides: tuple = (0, 1, 2)

    @property
    def limits(self):
        """1 and infinity: the sides are in order."""
        return 1.0, math.inf

    def rounding_share(self, descriptors):
        """float: the rounding of mesh points to float32 is a share of the diagonal, so a larger share of a short side."""
        shortest = float(descriptors.box.dimensions[2])
        if shortest <= 0.0:
            return 0.0
        return TOLERANCES.threshold + 2.0 * TOLERANCES.rounding * descriptors.box.diagonal / shortest

    def _error(self, descriptors, precision, value):
        return value * self._share_of_sides(descriptors, precision)

    def _share_of_sides(self, descriptors, precision):
        return sum(precision.side_mm / float(descriptors.box.dimensions[side]) for side in self.sides)


@dataclass(frozen=True)
class BoxFill(BoxRatio):
    """A share of the bounding box that the part's volume fills."""

    @property
    def limits(self):
        """0 and 1."""
        return 0.0, 1.0

    def _error(self, descriptors, precision, value):
        of_volume = precision.volume_mm3(descriptors.area) / abs(descriptors.volume)
        return value * (self._share_of_sides(descriptors, precision) + of_volume)


@dataclass(frozen=True)
class AreaShare(Quantity):
    """A share of the surface, over walls between two bounds of x."""

    is_area_share = True

    @property
    def limits(self):
        """0 and 1."""
        return 0.0, 1.0

    def is_never_more_than(self, other):
        """Whether the other share is over all these walls too."""
        return (type(other) is type(self) and self._counts_no_more_than(other)
                and other.bounds[0] <= self.bounds[0] and self.bounds[1] <= other.bounds[1])

    def _counts_no_more_than(self, other):
        return self.name == other.name

    def thin_bound(self, threshold, descriptors):
        """The upper bound. A share of thick walls, such as F[0.3;0.7], puts no bound on the thin ones."""
        return self.bounds[1] if self.bounds[1] < THICK_FROM else None

    def _error(self, descriptors, precision, value):
        # Walls that are about as thick as a bound may lie on its other side.
        step = precision.wall_mm / self._unit(descriptors)
        return min(1.0, precision.of_share(value) + sum(
            self._spread(descriptors, max(bound - step, 0.0), bound + step) for bound in self.bounds if 0.0 < bound < 1.0))

    def _unit(self, descriptors):
        """float, mm: what thicknesses are divided by."""
        return descriptors.box.diagonal

    def _spread(self, descriptors, low, high):
        """Share between two bounds, of which bins that they cut count in part."""
        return descriptors.distribution.spread_share(low, high)


@dataclass(frozen=True)
class MiddleShare(AreaShare):
    """A share of the surface, over walls between two bounds in units of D2, the middle side of the box.

    Attributes
    ----------
    slanted : bool
        Whether walls at 10 to 60 degrees count, beside parallel ones.
    """

    slanted: bool = True

    @property
    def record_key(self):
        """The shares in units of D2."""
        return "middle"

    def _counts_no_more_than(self, other):
        return other.slanted or not self.slanted

    def _unit(self, descriptors):
        return float(descriptors.box.dimensions[1])

    def _spread(self, descriptors, low, high):
        return descriptors.middle_share(low, high, self.slanted)

    def margin(self, relative, threshold, descriptors):
        """The share may be far from its threshold and all of it lie over walls that are just as thick as the bound.

        So it counts too by how much walls would have to be thinner or thicker.
        """
        low, high = self.bounds
        if low > 0.0 or not 0.0 < threshold < 1.0:
            return relative
        wall = self._wall_under(threshold, descriptors)
        off = abs(high / wall - 1.0) if wall > 0.0 else math.inf
        return math.copysign(min(abs(relative), off), relative)

    def _wall_under(self, share, descriptors):
        """The thickness, in units of D2, under which a share of the surface lies: float, inf where that is never reached."""
        return descriptors.distribution.middle_quantile(share, middle_by_diagonal(descriptors.box), self.slanted)

    def is_only_blurred(self, descriptors):
        """Whether the upper bound is known to a fifth."""
        return descriptors.length_error <= BLURRED * self.bounds[1] * float(descriptors.box.dimensions[1])

    def thin_bound(self, threshold, descriptors):
        """The upper bound, in diagonals."""
        return self.bounds[1] * middle_by_diagonal(descriptors.box)


@dataclass(frozen=True)
class LocalShare(MiddleShare):
    """A share of the surface, by its local thickness in units of D2."""

    @property
    def record_key(self):
        """The shares by local thickness."""
        return "local"

    def _counts_no_more_than(self, other):
        return True

    def _wall_under(self, share, descriptors):
        return math.inf if descriptors.local is None else descriptors.local.quantile(share)

    def _spread(self, descriptors, low, high):
        return descriptors.local.share(low, high)

    def _error(self, descriptors, precision, value):
        return super()._error(descriptors, precision.of_balls, value)


@dataclass(frozen=True)
class LocalQuantile(Quantity):
    """The local thickness, in units of D2, that a share of the surface is below.

    Attributes
    ----------
    share : float
    """

    share: float = 0.5

    @property
    def limits(self):
        """0 and 1."""
        return 0.0, 1.0

    def _error(self, descriptors, precision, value):
        of_balls, local = precision.of_balls, descriptors.local
        off = of_balls.of_share(self.share)
        found = [local.quantile(min(max(self.share + each, 0.0), 1.0)) for each in (-off, off)]
        length = precision.wall_mm / float(descriptors.box.dimensions[1])
        return max(abs(each - value) for each in found) + length


def middle_by_diagonal(box):
    """The middle side of a box as a share of its diagonal: what thicknesses in units of D2 are multiplied by."""
    return float(box.dimensions[1]) / box.diagonal


@dataclass(frozen=True)
class WallDistance(Quantity):
    """The distance of the nearest walls at angles between two bounds, in diagonals."""

    is_wall_distance = True
    thin_where = "<"

    @property
    def limits(self):
        """0 and infinity."""
        return 0.0, math.inf

    def thin_bound(self, threshold, descriptors):
        """The threshold: thinner walls count."""
        return threshold

    def error(self, descriptors, area_floor):
        """float or None: also by what other samples may find, the wall which twice the floor reaches, or one in between, and
        by what the search for it left open."""
        known = super().error(descriptors, area_floor)
        farther = self.compute(descriptors, 2.0 * area_floor, *self.bounds)
        if known is None or farther is None or descriptors.precision is None:
            return known
        value = self.evaluate(descriptors, area_floor)
        # For other angles and floors the distance is that of the samples, whatever the search found.
        ended = descriptors.precision.slanted if value == descriptors.min_nonparallel else 0.0
        return known + max(farther + 1.0 / BINS - value, ended)

    def _error(self, descriptors, precision, value):
        return (precision.wall_mm + precision.chord_mm) / descriptors.box.diagonal


@dataclass(frozen=True)
class RidgeRatio(Quantity):
    """The thickness of what stands on a solid core, in units of D2."""

    thin_where = "<"

    @property
    def limits(self):
        """0 and 1."""
        return 0.0, 1.0

    def thin_bound(self, threshold, descriptors):
        """The threshold, in diagonals."""
        return threshold * middle_by_diagonal(descriptors.box)

    def _error(self, descriptors, precision, value):
        # What equal regions may differ by.
        return SAME * value
