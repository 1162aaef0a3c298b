"""The ``descriptors`` of a part record: its keys, each with the kind of its value and how to compute it.

Quantities come from `descriptor_table`; only keys that are not quantities are defined here.
"""

from dataclasses import asdict, replace
from typing import Callable, NamedTuple

from ..analysis_settings import ACCURACIES
from ..kinds.compound_kinds import ListOf, Record, Row
from ..kinds.value_kinds import LARGEST, Flag, Kind, Number, OneOf, OrNull, Text, Whole
from .bins import ANGLE_STEP, BINS, MIDDLE_BINS
from .descriptor_table import QUANTITIES, REPORTED_SHARES, STATED_FLOOR, Descriptors, quantity_named

_LEAST_ANGLE, _GREATEST_ANGLE = 10, 60 - ANGLE_STEP
"""Lower edges of the first and the last angle bin."""

_LENGTH, _NUMBER = Number(0, LARGEST), Number()
_BIN, _AREAS = Whole(0, BINS - 1), ListOf(Number(-LARGEST, LARGEST), most=BINS * 100)


class MeasuredPart(NamedTuple):
    """What the values are computed from.

    Attributes
    ----------
    descriptors : Descriptors
    wall_range : tuple of float or None, mm
        Least, median and greatest thickness of parallel walls.
    error_bound : float, mm
    has_teeth, is_watertight : bool
    """

    descriptors: Descriptors
    wall_range: tuple
    error_bound: float
    has_teeth: bool
    is_watertight: bool


class Entry(NamedTuple):
    """A key of ``descriptors``, the kind of its value, and a function that computes it from a `MeasuredPart`."""

    key: str
    kind: Kind
    value: Callable


def _of_quantities(key, about=""):
    """Make the entry of one quantity, or of several in a list or an object."""
    group = [quantity for quantity in QUANTITIES if quantity.keys[:1] == (key,)]
    values = [lambda part, quantity=quantity: quantity.evaluate(part.descriptors, STATED_FLOOR) for quantity in group]
    inner = [quantity.keys[1:] for quantity in group]
    if inner == [()]:
        return Entry(key, replace(group[0].kind, about=about) if about else group[0].kind, values[0])
    if inner == [(index,) for index in range(len(group))]:
        return Entry(key, Row(tuple(quantity.kind for quantity in group), about=about),
                     lambda part: [value(part) for value in values])
    names = [name for name, in inner]
    return Entry(key, Record({name: quantity.kind for name, quantity in zip(names, group)}, about=about),
                 lambda part: {name: value(part) for name, value in zip(names, values)})


ENTRIES = (
    _of_quantities("volume_mm3", about="null where the surface is not watertight"),
    _of_quantities("area_mm2"),
    _of_quantities("box_mm", about="D1 >= D2 >= D3"),
    Entry("box_axes", ListOf(ListOf(_NUMBER, 3, 3), 3, 3, about="row k is the direction of dimension k"),
          lambda part: part.descriptors.box.axes.tolist()),
    _of_quantities("diagonal_mm"),
    _of_quantities("volume_ratio"),
    _of_quantities("d1_d2"),
    _of_quantities("d2_d3"),
    Entry("F", Record({f"{low:g}:{high:g}": _NUMBER for low, high in REPORTED_SHARES}),
          lambda part: {f"{low:g}:{high:g}": part.descriptors.distribution.share(low, high)
                        for low, high in REPORTED_SHARES}),
    Entry("teeth", OneOf((0, 1)), lambda part: int(part.has_teeth)),
    _of_quantities("min_nonparallel"),
    Entry("thickness_mm", Record({
        "min": OrNull(_LENGTH), "median": OrNull(_LENGTH), "max": OrNull(_LENGTH), "error_bound": _LENGTH,
    }), lambda part: dict(zip(("min", "median", "max", "error_bound"), (*part.wall_range, part.error_bound)))),
    _of_quantities("shares"),
    Entry("distribution", Record(
        {"bins": ListOf(_BIN, most=BINS), "area": _AREAS}, alike=("bins", "area"),
        about="bin k covers x in [k/1000, (k+1)/1000)"),
        lambda part: {"bins": part.descriptors.distribution.bins.tolist(),
                      "area": part.descriptors.distribution.area.tolist()}),
    Entry("nonparallel", Record({
        "bins": ListOf(_BIN, most=BINS * 100),
        "angles": ListOf(Whole(_LEAST_ANGLE, _GREATEST_ANGLE), most=BINS * 100),
        "area": _AREAS,
    }, alike=("bins", "angles", "area")), lambda part: {
        "bins": part.descriptors.distribution.nonparallel_bins.tolist(),
        "angles": part.descriptors.distribution.nonparallel_angles.tolist(),
        "area": part.descriptors.distribution.nonparallel_area.tolist(),
    }),
    Entry("watertight", Flag(), lambda part: part.is_watertight),
)
"""Entries that every info file has."""

_WITH_ERRORS = (*(quantity for quantity in QUANTITIES if quantity.has_error and quantity.keys),
                *(quantity_named(f"F[{low:g};{high:g}]") for low, high in REPORTED_SHARES))

LATER_ENTRIES = (Entry("precision", OrNull(Record({
    "accuracy": OneOf(tuple(ACCURACIES)), "samples": Whole(1), "wall_mm": _LENGTH, "chord_mm": _LENGTH,
    "mean_chord_mm": _LENGTH, "area_share": _LENGTH, "plate_share": Number(0, 1),
    "errors": ListOf(Record({"quantity": Text(), "error": OrNull(_LENGTH)}), most=1000, distinct="quantity"),
}, about="how precisely the part was measured, and how far quantities may be off, with a probability of 95 %")),
    lambda part: _precision(part.descriptors)), Entry("middle", OrNull(Record({
    "bins": ListOf(Whole(0, MIDDLE_BINS - 1), most=MIDDLE_BINS), "parallel": _AREAS, "nonparallel": _AREAS,
}, alike=("bins", "parallel", "nonparallel"), about="bin k covers thicknesses in [k/100, (k+1)/100) D2")),
    lambda part: _middle(part.descriptors.distribution.middle)), *(
    _of_quantities(key) for key in dict.fromkeys(quantity.keys[0] for quantity in QUANTITIES if quantity.keys)
    if key not in {entry.key for entry in ENTRIES}))
"""Quantities that were added later. Files of earlier versions lack them; readers compute them from the other keys."""

DESCRIPTORS = Record({entry.key: entry.kind for entry in ENTRIES},
                     later={entry.key: entry.kind for entry in LATER_ENTRIES})
"""Kind of ``descriptors``."""


def _precision(descriptors):
    if descriptors.precision is None:
        return None
    return {**asdict(descriptors.precision),
            "errors": [{"quantity": quantity.symbol, "error": quantity.error(descriptors, STATED_FLOOR)}
                       for quantity in _WITH_ERRORS]}


def _middle(middle):
    if middle is None:
        return None
    return {"bins": middle.bins.tolist(), "parallel": middle.parallel.tolist(), "nonparallel": middle.nonparallel.tolist()}


def recorded_descriptors(part):
    """Compute the ``descriptors`` of a part record.

    Parameters
    ----------
    part : MeasuredPart

    Returns
    -------
    dict
    """
    return {entry.key: entry.value(part) for entry in (*ENTRIES, *LATER_ENTRIES)}
