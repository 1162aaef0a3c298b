# SPDX-License-Identifier: LGPL-2.1-or-later
"""The measured quantities of a part, and the one table of them.

    python3 -m thinpart_workbench.core.descriptors.descriptor_table

prints it as docs/info-file.md has it.

Types that are only used in annotations are not imported: the command line, which classifies and lists what the
workers measured, starts in half the time without numpy and scipy.
"""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

from ..errors import ThinPartError
from ..message import message
from ..tolerances import TOLERANCES
from .bins import BINS
from .descriptor_types import SampledShares
from .local_quantiles import QUANTILES
from .precision import EXACT, Precision
from .quantity import (
    AreaShare,
    BoxFill,
    BoxRatio,
    LocalQuantile,
    LocalShare,
    MiddleShare,
    Quantity,
    RidgeRatio,
    WallDistance,
    middle_by_diagonal,
)
from .region_kinds import BAR, BLOCK, PLATE, TAPER, TOOTH, TUBE

if TYPE_CHECKING:
    from ..mesh.bounds import OrientedBox
    from .distribution import Distribution
    from .local_distribution import LocalDistribution

STATED_FLOOR = TOLERANCES.floor

STATED_ANGLES = (10, 55)
"""Wedge angles, degrees, between which `min_nonparallel` is recorded (Giannini et al. 2012, 5.2)."""

REPORTED_SHARES = tuple(tuple(map(float, key.split(":"))) for key in SampledShares.__annotations__)
"""The ranges of x of `SampledShares`."""


def body_thickness(volume, area):
    """Twice the volume divided by the area: the thickness of a plate, the radius of a rod, two thirds of a ball's.

    The relative error of the volume is the error of a length divided by this length, and that of the area is no larger,
    because facets lie no farther than the chord error from the surface. Returns a float or None, mm.

    Parameters
    ----------
    volume : float or None, mm3
    area : float, mm2
    """
    return None if volume is None else 2.0 * volume / area


@dataclass(frozen=True)
class Descriptors:
    """What was measured on a part, independent of any threshold.

    Attributes
    ----------
    volume : float or None, mm3
        None where the surface is not watertight.
    area : float, mm2
    box : OrientedBox
    distribution : Distribution
    min_nonparallel : float or None
        Least distance between slanted walls, in diagonals, at `STATED_FLOOR` and `STATED_ANGLES`.
        For others it is read from the distribution, to 0.001.
    plate_share : float or None
        Share of the surface over plates and tubes; None in records of versions that did not measure it.
    regions : Mapping or None
        Of the wall regions: ``thinnest_mm``, the least median, ``count``, the number of each of
        `REGION_KINDS`, and ``ridge_ratio``; None in records of versions that did not find them.
    hazards : Mapping or None
        What makes it hard to mesh, `HazardsRecord`; None for triangles without faces, and in records of versions that did
        not measure it.
    length_error : float, mm
        Error of every length where the surface mesh could not be made fine enough for the part; 0 where it is fine
        enough.
    precision : Precision or None
        None in records of versions that did not estimate it.
    local : LocalDistribution or None
        The surface by local thickness; None in records of versions that did not measure it, and for measurements by pairs.
    """

    volume: Optional[float]
    area: float
    box: "OrientedBox"
    distribution: "Distribution"
    min_nonparallel: Optional[float]
    plate_share: Optional[float] = None
    regions: Optional[Mapping] = None
    hazards: Optional[Mapping] = None
    length_error: float = 0.0
    precision: Optional[Precision] = None
    local: Optional["LocalDistribution"] = None

    @property
    def unmet(self):
        """float: share of the area about which nothing is known; see `Distribution.unmet`."""
        return self.distribution.unmet

    @property
    def body_thickness(self):
        """float or None, mm: see `body_thickness`."""
        return body_thickness(self.volume, self.area)

    @property
    def is_unresolved(self):
        """bool: whether lengths may be off by more than half of the body, so that nothing is known."""
        body = self.body_thickness
        return body is not None and self.length_error > 0.5 * min(body, float(self.box.dimensions[2]))

    @property
    def resolved_precision(self):
        """Precision or None: `precision`, and where lengths may be off by `length_error`, that of such lengths."""
        if not self.length_error:
            return self.precision
        return (self.precision or EXACT).with_blurred_lengths(self.length_error, self.body_thickness)

    @property
    def median_thickness(self):
        """float or None, mm: median of the local thickness; of the walls where that was not measured, to 0.001 diagonals."""
        if self.local is not None:
            return self.local.quantiles["T50"] * float(self.box.dimensions[1])
        median = self.distribution.median()
        return None if median is None else median * self.box.diagonal

    def middle_share(self, low, high, slanted=True):
        """Share of the area over walls between two bounds in units of D2; see `Distribution.middle_share`."""
        return self.distribution.middle_share(low, high, middle_by_diagonal(self.box), slanted)

    def value(self, quantity, area_floor=STATED_FLOOR):
        """Value of a named quantity: float, or None where it could not be measured.

        Raises KeyError when there is no such quantity.

        Parameters
        ----------
        quantity : str
            A name or symbol of `QUANTITIES`, with its bounds where it has some: ``F[0;0.25]``.
        area_floor : float
            Area share below which non-parallel walls are stray.
        """
        return quantity_named(quantity).evaluate(self, area_floor)

    def named_value(self, quantity):
        """As `value`, for quantities that a user names: float, or None where it could not be measured.

        Raises ThinPartError, kind ``usage`` if there is no such quantity.
        """
        try:
            return self.value(quantity)
        except KeyError:
            raise ThinPartError(
                message("There is no quantity {quantity!r}: there are {known}.",
                        quantity=quantity, known=quantity_symbols()), "usage") from None


def _ratio(numerator, denominator):
    if numerator is None or denominator <= 0.0:
        return None
    return float(numerator / denominator)


def _nonparallel_minimum(descriptors, floor, low, high):
    if floor == STATED_FLOOR and (low, high) == STATED_ANGLES:
        return descriptors.min_nonparallel
    return descriptors.distribution.nonparallel_minimum(floor, low, high)


def _of_side(descriptors, precision, value):
    return precision.side_mm


def _of_share(descriptors, precision, value):
    return precision.of_share(value)


def _plate_ratio_error(descriptors, precision, value):
    of_volume = precision.volume_mm3(descriptors.area) / abs(descriptors.volume)
    of_median = 1.0 / BINS * descriptors.box.diagonal if descriptors.local is None else \
        quantity_named("T50").error(descriptors, STATED_FLOOR) * float(descriptors.box.dimensions[1])
    return value * (of_volume + precision.area_share + of_median / descriptors.median_thickness)


def _local_share(descriptors, floor, low, high):
    return None if descriptors.local is None else descriptors.local.share(low, high)


def _local_quantile(name):
    return lambda descriptors: None if descriptors.local is None else descriptors.local.quantiles[name]


def _of_regions(key):
    return lambda descriptors: None if descriptors.regions is None else descriptors.regions[key]


def _of_hazards(key):
    return lambda descriptors: None if descriptors.hazards is None else descriptors.hazards.get(key)


QUANTITIES = (
    Quantity("volume_mm3", "V", "mm3", "Volume of the part", lambda d: d.volume,
             error_of=lambda d, precision, value: precision.volume_mm3(d.area)),
    Quantity("area_mm2", "A", "mm2", "Area of its surface", lambda d: d.area,
             error_of=lambda d, precision, value: value * precision.area_share),
    Quantity("d1_mm", "D1", "mm", "Longest side of the bounding box", lambda d: float(d.box.dimensions[0]),
             keys=("box_mm", 0), error_of=_of_side),
    Quantity("d2_mm", "D2", "mm", "Middle side of the bounding box", lambda d: float(d.box.dimensions[1]),
             keys=("box_mm", 1), error_of=_of_side),
    # The third side of a flat open surface is 0.
    Quantity("d3_mm", "D3", "mm", "Shortest side of the bounding box", lambda d: float(d.box.dimensions[2]),
             keys=("box_mm", 2), error_of=_of_side),
    Quantity("diagonal_mm", "diag", "mm", "Diagonal of the bounding box", lambda d: d.box.diagonal,
             in_table=False, error_of=_of_side),
    BoxFill("volume_ratio", "V/VBB", "", "Share of the bounding box that the part fills",
            lambda d: _ratio(d.volume, d.box.volume)),
    BoxRatio("d1_d2", "D1/D2", "", "Longest to middle side of the bounding box",
             lambda d: _ratio(*d.box.dimensions[:2]), sides=(0, 1), in_table=False),
    BoxRatio("d2_d3", "D2/D3", "", "Middle to shortest side of the bounding box",
             lambda d: _ratio(*d.box.dimensions[1:]), sides=(1, 2), in_table=False),
    AreaShare("F", "F", "", "Share of the area with walls that are a to b diagonals thick",
              lambda d, floor, low, high: d.distribution.share(low, high), bounds=(0.0, 1.0),
              keys=(), in_table=False),
    MiddleShare("K", "K", "", "Share of the area over walls, parallel or under 60 degrees, from a to b of the middle side",
                lambda d, floor, low, high: d.middle_share(low, high), bounds=(0.0, 1.0), keys=(), in_table=False),
    MiddleShare("P", "P", "", "Share of the area over parallel walls from a to b of the middle side",
                lambda d, floor, low, high: d.middle_share(low, high, slanted=False), bounds=(0.0, 1.0), keys=(),
                in_table=False, slanted=False),
    LocalShare("L", "L", "", "Share of the area whose local thickness is from a to b of the middle side", _local_share,
               bounds=(0.0, 1.0), keys=(), in_table=False),
    LocalQuantile("t05", "T05", "", "Local thickness, by the middle side, that 5 % of the area is below",
                  _local_quantile("T05"), keys=("local", "T05"), share=QUANTILES["T05"]),
    LocalQuantile("t50", "T50", "", "Median of the local thickness, by the middle side",
                  _local_quantile("T50"), keys=("local", "T50"), share=QUANTILES["T50"]),
    LocalQuantile("t75", "T75", "", "Local thickness, by the middle side, that 75 % of the area is below",
                  _local_quantile("T75"), keys=("local", "T75"), share=QUANTILES["T75"]),
    LocalQuantile("t99", "T99", "", "Local thickness, by the middle side, that 99 % of the area is below",
                  _local_quantile("T99"), keys=("local", "T99"), share=QUANTILES["T99"]),
    # An open surface has no volume: its walls count as plates.
    Quantity("plate_ratio", "plate_ratio", "",
             "Twice the volume by the area and the median local thickness: 1 of a plate, 1/2 of a wire or square bar",
             lambda d: _ratio(d.body_thickness, d.median_thickness or 0.0), absent_means=1.0,
             error_of=_plate_ratio_error),
    Quantity("plate_share", "plate_share", "", "Share of the area over plates and tubes: walls that are wider than thick",
             lambda d: d.plate_share,
             error_of=lambda d, precision, value: min(1.0, precision.of_share(value) + precision.plate_share)),
    Quantity("region_mm", "region_mm", "mm", "Median thickness of the thinnest wall region",
             _of_regions("thinnest_mm"), keys=("regions", "thinnest_mm")),
    Quantity("regions", "regions", "", "Number of wall regions, connected walls of like thickness",
             _of_regions("count"), keys=("regions", "count")),
    Quantity("plate_regions", "plate_regions", "", "Number of wall regions that are plates, flat, bent or shells",
             _of_regions(PLATE), keys=("regions", PLATE), in_table=False),
    Quantity("tube_regions", "tube_regions", "", "Number of wall regions that are tubes",
             _of_regions(TUBE), keys=("regions", TUBE), in_table=False),
    Quantity("bar_regions", "bar_regions", "", "Number of wall regions that are bars, shafts, wires or rings",
             _of_regions(BAR), keys=("regions", BAR), in_table=False),
    Quantity("block_regions", "block_regions", "", "Number of wall regions that are blocks",
             _of_regions(BLOCK), keys=("regions", BLOCK), in_table=False),
    Quantity("taper_regions", "taper_regions", "", "Number of wall regions that are tapers",
             _of_regions(TAPER), keys=("regions", TAPER), in_table=False),
    Quantity("tooth_regions", "tooth_regions", "", "Number of wall regions that are teeth, of gears or threads",
             _of_regions(TOOTH), keys=("regions", TOOTH), in_table=False),
    RidgeRatio("ridge_ratio", "ridge_ratio", "",
               "Median thickness of the thinnest ribs, pins, teeth or thread on a solid core, by the middle side; "
               "1 without any",
               _of_regions("ridge_ratio"), keys=("regions", "ridge_ratio")),
    Quantity("face_count", "faces", "", "Number of faces", _of_hazards("faces"), keys=("hazards", "faces")),
    Quantity("edge_mm", "edge_mm", "mm", "Length of the shortest edge",
             _of_hazards("shortest_edge_mm"), keys=("hazards", "shortest_edge_mm")),
    Quantity("short_edges", "short_edges", "", "Number of edges shorter than 0.3 elements of the automatic mesh",
             _of_hazards("short_edges"), keys=("hazards", "short_edges")),
    Quantity("face_width_mm", "face_width_mm", "mm", "Least width of a face: twice its area by the length of its border",
             _of_hazards("narrowest_face_mm"), keys=("hazards", "narrowest_face_mm")),
    Quantity("narrow_faces", "narrow_faces", "", "Number of faces narrower than 0.3 elements of the automatic mesh",
             _of_hazards("narrow_faces"), keys=("hazards", "narrow_faces")),
    Quantity("knife_edges", "knife_edges", "", "Length of knife's edges, faces that meet at under 30 degrees, in diagonals",
             _of_hazards("knife_edges"), keys=("hazards", "knife_edges")),
    Quantity("tight_share", "tight_share", "", "Share of the area with a radius below 0.25 elements of the automatic mesh",
             _of_hazards("tight_share"), keys=("hazards", "tight_share")),
    Quantity("flattened_share", "flattened_share", "",
             "Share of the area over curved walls that elements of the automatic mesh change by a twentieth",
             _of_hazards("flattened_share"), keys=("hazards", "flattened_share")),
    Quantity("thin_x", "thin_x", "", "Local thickness below which 5 % of the area is, in diagonals",
             _of_hazards("thin_x"), keys=("hazards", "thin_x"), in_table=False),
    WallDistance("min_nonparallel", "min_nonparallel", "",
                 "Least distance, in diagonals, between walls at a to b degrees",
                 _nonparallel_minimum, bounds=STATED_ANGLES, absent_means=math.inf, in_table=False),
    Quantity("parallel", "parallel", "", "Share of the area with parallel walls", lambda d: d.distribution.parallel,
             keys=("shares", "parallel"), in_table=False, error_of=_of_share),
    Quantity("nonparallel", "nonparallel", "", "Share of the area with non-parallel walls",
             lambda d: d.distribution.nonparallel,
             keys=("shares", "nonparallel"), in_table=False,
             error_of=lambda d, precision, value: 1.5 * precision.of_share(value)),
    Quantity("unmeasured", "unmeasured", "", "Share of the area with no wall opposite",
             lambda d: d.distribution.unmeasured,
             keys=("shares", "unmeasured"), in_table=False,
             error_of=lambda d, precision, value: 2.3 * precision.of_share(value)),
    Quantity("unmet", "unmet", "", "Share of the area whose rays met nothing at all", lambda d: d.distribution.unmet,
             keys=("shares", "unmet"), in_table=False, error_of=_of_share),
)
"""Records, the definition of info files, the search index, tables, conditions and docs/info-file.md are derived from
this table. A new quantity gets its own key in records; existing files lack it. `descriptor_types` has its limits."""

_BY_NAME = {key: quantity for quantity in QUANTITIES for key in (quantity.name, quantity.symbol)}
_BOUNDED = re.compile(r"^\s*([A-Za-z_]+)\s*\[\s*([0-9.]+)\s*[;:,]\s*([0-9.]+)\s*\]\s*$")


def quantity_named(text):
    """Find the `Quantity` that a text names, such as ``V/VBB``, ``d2_d3`` or ``F[0;0.25]``.

    Raises KeyError when there is no such quantity or its bounds are not in order.
    """
    bounded = _BOUNDED.match(text)
    quantity = _BY_NAME.get(bounded.group(1) if bounded else text.strip())
    if quantity is None or (bounded is not None) != bool(quantity.bounds):
        raise KeyError(text)
    if bounded is None:
        return quantity
    try:
        low, high = float(bounded.group(2)), float(bounded.group(3))
    except ValueError:  # two points in one number
        raise KeyError(text) from None
    if not low < high:
        raise KeyError(text)
    return quantity.bounded(text.strip(), low, high)


def quantity_symbols():
    """str: the symbols of all quantities, separated by commas."""
    return ", ".join(f"{quantity.symbol}[a;b]" if quantity.bounds else quantity.symbol for quantity in QUANTITIES)


def listing():
    """str: the table as Markdown, a line per quantity."""
    return "\n".join(f"| `{quantity.name}` | {quantity.symbol} | {quantity.unit or '-'} | {quantity.meaning} |"
                     for quantity in QUANTITIES)


if __name__ == "__main__":
    print(listing())
