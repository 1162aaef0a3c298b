# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of walls to choose from, and parts checked against them."""

from dataclasses import replace
from typing import Any, NamedTuple, Optional

import numpy as np

from ...core.errors import ThinPartError
from ...core.judging.limit_bands import least_ratios, too_thick
from ...core.judging.wall_check import check_sentence, check_walls
from ...core.judging.wall_limits import SHIPPED, WallLimits, limits_content, shipped_limits
from ...freecad_adapter.objects.thickness_object import OWN_CHECK
from ...freecad_adapter.preferences import preference
from ...storage.user_limits import known_limits, limits_named


class CheckedFacets(NamedTuple):
    """Of a map, which facets are ``too_thick``, ndarray of shape (m,), bool, and a ThicknessMap to be ``compared`` with the
    limits of the process: where faces have a least wall of their own, thicknesses in proportion to that."""

    too_thick: Any
    compared: Any


class CheckedPart(NamedTuple):
    """Whether a part ``holds`` limits, None where that cannot be told, and a ``sentence`` that says why."""

    holds: Optional[bool]
    sentence: str


def offered_limits():
    """Limits to choose from: those that are known, or the shipped ones where the user's file cannot be used.

    A dict of WallLimits by their names.

    Examples
    --------
    >>> offered_limits()["FDM"].min_mm > 0.0
    True
    """
    try:
        return known_limits()
    except ThinPartError:
        return shipped_limits()  # the error is reported when they are used


def checked(record, limits):
    """Check the walls of a part: CheckedPart.

    Parameters
    ----------
    record : PartRecord
        May lack its faces.
    limits : WallLimits

    Examples
    --------
    >>> checked(record, offered_limits()["FDM"]).holds
    True
    """
    check = check_walls(record, limits)
    return CheckedPart(check.holds, check_sentence(check))


def checked_facets(parts, limits, face_limits=None):
    """Which facets of maps are thinner or thicker than a process allows, as `checked` says it: list of CheckedFacets.

    In maps of earlier versions, which have no balls, what is too thick is told by the thickness across.

    Parameters
    ----------
    parts : list of MappedPart
    limits : WallLimits
    face_limits : dict, optional
        Limits for single faces by the name of the part; see ``face_limits`` of a part record.

    Examples
    --------
    >>> part, = parts_of(thickness)
    >>> part.record.update(record)
    >>> [int(facets.too_thick.sum()) for facets in checked_facets([part], offered_limits()["FDM"])]
    [0]
    """
    return [_checked_facets(part.map, check_walls(limited(part.record, face_limits), limits)) for part in parts]


def _checked_facets(shown, check):
    compared, ratios = shown, least_ratios(check, shown.face, shown.opposite)
    if ratios is not None:
        compared = replace(shown, thickness=(shown.thickness * ratios).astype(np.float32),
                           corner_thickness=(shown.corner_thickness * ratios[:, None]).astype(np.float32))
    return CheckedFacets(too_thick(check, shown.thickness if shown.balls is None else shown.balls, shown.face), compared)


def limited(record, face_limits):
    """A record with the limits that are kept for its faces: see `checked_facets`.

    Examples
    --------
    >>> limited(record, None)["face_limits"]
    ()
    """
    return {**record, "face_limits": (face_limits or {}).get(record["name"], ())}


def preferred_checks(record):
    """The walls of a part checked against what the preferences name: list of CheckedPart, empty where that is nothing.

    Raises a ThinPartError, kind ``usage``, if there is no such process, or the user's own limits cannot be used.

    Examples
    --------
    >>> preferred_checks(record)
    []
    """
    return [checked(record, limits) for limits in limits_named(preference("Checks").split(","))]


def limits_of_map(thickness, own_title):
    """The limits that a map is checked against: WallLimits or None; `own_title` is that of a limit of no process.

    Examples
    --------
    >>> limits_of_map(thickness, "Own limit") is None  # nothing is checked
    True
    """
    name, least, most = thickness.Check, thickness.Threshold or None, thickness.CheckMost or None
    if not name or least is most is None:
        return None
    known = offered_limits().get(name)
    if known is not None and (known.min_mm, known.max_mm) == (least, most):
        return known
    # An own limit, or one of a process that has other limits by now than when it was chosen.
    return WallLimits(name, own_title if name == OWN_CHECK else name, least, most)


def shipped_processes() -> list[dict[str, Any]]:
    """The processes that come with ThinPart, as in the file.

    Examples
    --------
    >>> len(shipped_processes()) > 5
    True
    """
    return limits_content(SHIPPED)["processes"]
