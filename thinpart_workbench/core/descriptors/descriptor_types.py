# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ``descriptors`` of a part record: the types of their values, from which checks and the schema are derived.

A quantity of `descriptor_table` that is not here is a number or null under its own key.
"""

from typing import Annotated, Optional, TypedDict

from ..analysis_settings import ACCURACIES
from ..kinds.compound_kinds import Row
from ..kinds.key_presence import NotRequired
from ..kinds.typed_kinds import LATER, Restricted
from ..kinds.value_kinds import LARGEST, Number, OneOf, Whole
from .bins import ANGLE_STEP, BINS, MIDDLE_BINS

Share = Annotated[float, Number(0, 1)]
Length = Annotated[float, Number(0, LARGEST)]
"""mm"""

_MOST_PAIRS = BINS * 100
_POSITIVE = Number(1 / LARGEST, LARGEST)
_LENGTH = Number(0, LARGEST)
_RATIO = Optional[Annotated[float, Number(-LARGEST, LARGEST)]]
_Areas = Annotated[list[Annotated[float, Number(-LARGEST, LARGEST)]], Restricted(most=_MOST_PAIRS)]
_Bin = Annotated[int, Whole(0, BINS - 1)]
_Axis = Annotated[list[float], Restricted(least=3, most=3)]


class ThicknessRecord(TypedDict):
    """Least thickness of all walls, and its error bound; median by area and greatest of parallel ones; mm."""

    min: Optional[Length]
    median: Optional[Length]
    max: Optional[Length]
    error_bound: Length


class SharesRecord(TypedDict):
    """Shares of the area: over parallel walls, over non-parallel walls, unmeasured, and where rays hit nothing."""

    parallel: Share
    nonparallel: Share
    unmeasured: Share
    unmet: Share


class DistributionRecord(TypedDict):
    """Area by thickness."""

    bins: Annotated[list[_Bin], Restricted(most=BINS)]
    area: _Areas


class MiddleRecord(TypedDict):
    """Shares of the surface by thickness in units of the middle side of the box."""

    bins: Annotated[list[Annotated[int, Whole(0, MIDDLE_BINS - 1)]], Restricted(most=MIDDLE_BINS)]
    parallel: _Areas
    nonparallel: _Areas


class LocalRecord(TypedDict):
    """Shares of the surface by local thickness in units of the middle side of the box, and its quantiles."""

    bins: Annotated[list[Annotated[int, Whole(0, MIDDLE_BINS - 1)]], Restricted(most=MIDDLE_BINS)]
    area: _Areas
    T05: Optional[Share]
    T50: Optional[Share]
    T75: Optional[Share]
    T99: Optional[Share]


class NonparallelRecord(TypedDict):
    """Area by distance and angle of walls that are not parallel; the angle is the lower edge of its bin, degrees."""

    bins: Annotated[list[_Bin], Restricted(most=_MOST_PAIRS)]
    angles: Annotated[list[Annotated[int, Whole(10, 60 - ANGLE_STEP)]], Restricted(most=_MOST_PAIRS)]
    area: _Areas


SampledShares = TypedDict("SampledShares", {"0:0.05": float, "0:0.25": float, "0.05:0.29": float, "0.3:0.7": float})
SampledShares.__doc__ = """F[a;b] for the ranges of x whose area shares the paper stores in its info file (section 6)."""


class RegionCounts(TypedDict):
    """Median thickness of the thinnest wall region, number of all, and of each kind among those that are listed; and the
    thinnest ridge, see `ridges.ridge_ratio`."""

    thinnest_mm: Optional[Length]
    count: Optional[int]
    plate: Optional[int]
    tube: Optional[int]
    bar: Optional[int]
    block: Optional[int]
    taper: Optional[int]
    tooth: Optional[int]
    ridge_ratio: NotRequired[Annotated[Optional[Share], LATER]]


class HazardsRecord(TypedDict):
    """What makes a part hard to mesh at the size of the automatic mesh; None for a part that has no faces and edges."""

    faces: Optional[Annotated[int, Whole(0)]]
    shortest_edge_mm: Optional[Length]
    short_edges: Optional[Annotated[int, Whole(0)]]
    narrowest_face_mm: Optional[Length]
    narrow_faces: Optional[Annotated[int, Whole(0)]]
    knife_edges: Optional[Length]
    tight_share: Optional[Share]
    flattened_share: Optional[Share]
    thin_x: NotRequired[Annotated[Optional[Share], LATER]]


class QuantityError(TypedDict):
    """How far a quantity may be off; None where that is not known."""

    quantity: str
    error: Optional[Length]


class PrecisionRecord(TypedDict):
    """How precisely a part was measured; see `precision.Precision`."""

    accuracy: Annotated[str, OneOf(tuple(ACCURACIES))]
    samples: Annotated[int, Whole(1)]
    wall_mm: Length
    chord_mm: Length
    mean_chord_mm: Length
    area_share: Length
    plate_share: Share
    slanted: NotRequired[Annotated[Length, LATER]]
    errors: Annotated[list[QuantityError], Restricted(most=1000, distinct="quantity")]


class DescriptorsRecord(TypedDict):
    """What was measured on a part; docs/info-file.md explains the keys."""

    volume_mm3: Annotated[Optional[float], Restricted(about="null where the surface is not watertight")]
    area_mm2: float
    # The third side of a flat open surface is 0.
    box_mm: Annotated[list[float], Row((_POSITIVE, _LENGTH, _LENGTH), about="D1 >= D2 >= D3")]
    box_axes: Annotated[list[_Axis], Restricted(least=3, most=3, about="row k is the direction of dimension k")]
    diagonal_mm: Annotated[float, _POSITIVE]
    volume_ratio: _RATIO
    d1_d2: Optional[float]
    d2_d3: Optional[float]
    F: SampledShares
    teeth: Annotated[int, OneOf((0, 1))]
    min_nonparallel: Optional[float]
    thickness_mm: ThicknessRecord
    shares: SharesRecord
    distribution: Annotated[DistributionRecord, Restricted(
        alike=("bins", "area"), about="bin k covers x in [k/1000, (k+1)/1000)")]
    nonparallel: Annotated[NonparallelRecord, Restricted(alike=("bins", "angles", "area"))]
    watertight: bool
    precision: NotRequired[Annotated[Optional[Annotated[PrecisionRecord, Restricted(about=(
        "how precisely the part was measured, and how far quantities may be off, with a probability of 95 %"))]], LATER]]
    middle: NotRequired[Annotated[Optional[Annotated[MiddleRecord, Restricted(
        alike=("bins", "parallel", "nonparallel"), about="bin k covers thicknesses in [k/100, (k+1)/100) D2")]], LATER]]
    local: NotRequired[Annotated[LocalRecord, Restricted(alike=("bins", "area"), about=(
        "bin k covers local thicknesses in [k/100, (k+1)/100) D2; empty for measurements by pairs")), LATER]]
    plate_share: NotRequired[Annotated[Optional[Share], LATER]]
    regions: NotRequired[Annotated[RegionCounts, LATER]]
    hazards: NotRequired[Annotated[HazardsRecord, LATER]]
