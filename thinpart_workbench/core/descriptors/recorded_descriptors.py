# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ``descriptors`` of a part record, computed from what was measured.

Quantities come from `descriptor_table`; only keys that are not quantities are computed here.
"""

import math
from dataclasses import asdict, replace

from ..kinds.typed_kinds import kind_of
from .descriptor_table import QUANTITIES, REPORTED_SHARES, STATED_FLOOR, quantity_named
from .descriptor_types import DescriptorsRecord
from .local_quantiles import QUANTILES

_TYPED = kind_of(DescriptorsRecord)

DESCRIPTORS = replace(_TYPED, later={**_TYPED.later, **{
    quantity.keys[0]: quantity.kind for quantity in QUANTITIES if quantity.keys and quantity.keys[0] not in _TYPED.kinds}})
"""Kind of ``descriptors``. Files of earlier versions lack its later keys; readers compute them from the others."""

_WITH_ERRORS = (*(quantity for quantity in QUANTITIES if quantity.has_error and quantity.keys),
                *(quantity_named(f"F[{low:g};{high:g}]") for low, high in REPORTED_SHARES))


def recorded_descriptors(descriptors, wall_range, error_bound, has_teeth, is_watertight):
    """Compute the ``descriptors`` of a part record: DescriptorsRecord.

    Parameters
    ----------
    descriptors : Descriptors
    wall_range : tuple of float or None, mm
        Least thickness of all walls, median and greatest of parallel ones.
    error_bound : float, mm
    has_teeth, is_watertight : bool
    """
    shares, middle = descriptors.distribution, descriptors.distribution.middle
    others = {
        "box_axes": descriptors.box.axes.tolist(),
        "F": {f"{low:g}:{high:g}": shares.share(low, high) for low, high in REPORTED_SHARES},
        "teeth": int(has_teeth),
        "thickness_mm": dict(zip(("min", "median", "max", "error_bound"), (*wall_range, error_bound))),
        "distribution": {"bins": shares.bins.tolist(), "area": shares.area.tolist()},
        "nonparallel": {"bins": shares.nonparallel_bins.tolist(), "angles": shares.nonparallel_angles.tolist(),
                        "area": shares.nonparallel_area.tolist()},
        "watertight": is_watertight,
        "precision": None if descriptors.precision is None else {
            **asdict(descriptors.precision),
            "errors": [{"quantity": quantity.symbol, "error": None if error is None or math.isinf(error) else error}
                       for quantity in _WITH_ERRORS for error in [quantity.error(descriptors, STATED_FLOOR)]]},
        "local": _local(descriptors.local),
        "middle": None if middle is None else {
            "bins": middle.bins.tolist(), "parallel": middle.parallel.tolist(), "nonparallel": middle.nonparallel.tolist()},
    }
    values = {quantity.keys: quantity.evaluate(descriptors, STATED_FLOOR) for quantity in QUANTITIES if quantity.keys}
    return {key: others[key] if key in others else _of_quantities(key, values) for key in DESCRIPTORS.kinds}


def _local(local):
    if local is None:
        return {"bins": [], "area": [], **dict.fromkeys(QUANTILES)}
    return {"bins": local.bins.tolist(), "area": local.area.tolist(), **local.quantiles}


def _of_quantities(key, values):
    """The value of one quantity, or of several in a list or an object."""
    found = {keys[1:]: value for keys, value in values.items() if keys[0] == key}
    if () in found:
        return found[()]
    inner = {last: value for (last,), value in found.items()}
    return list(inner.values()) if 0 in inner else inner
