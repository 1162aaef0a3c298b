# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a shown map beside the limits that are checked; they are the same until these change."""

from ...api.document_maps import map_version, parts_of
from ...api.window.limits import checked_facets, limits_of_map
from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ...freecad_adapter.objects.thickness_object import OWN_CHECK
from ..application import lifelong


class CheckedMaps:
    """Facets as they are compared with limits; equal only to itself, which is quick to compare.

    Attributes
    ----------
    of_parts : list of CheckedFacets
        By part number.
    has_thick : bool
        Whether a greatest wall is checked, and not balls are shown.
    """

    def __init__(self, of_parts, has_thick):
        self.of_parts, self.has_thick = of_parts, has_thick

    def are_thick(self, number):
        """Which facets of a part are too thick: ndarray of shape (m,), bool, or None where that is not checked."""
        return self.of_parts[number].too_thick if self.has_thick else None


def is_checked(thickness):
    """Whether a thickness object is coloured by limits: those of a process are of the wall across, and not of balls."""
    return bool(thickness.Check) and (thickness.Measure == RAY or thickness.Check == OWN_CHECK)


def checked_maps(thickness):
    """CheckedMaps of a thickness object; None where its thicknesses alone say how it is coloured.

    Limits for single faces count as soon as they are known to the window.
    """
    if not is_checked(thickness):
        return None
    face_limits = (lifelong.face_limits and lifelong.face_limits.known(thickness.Document.FileName)) or {}
    has_thick = thickness.CheckMost > 0.0 and thickness.Measure == RAY
    if not has_thick and not face_limits:
        return None
    depends = (map_version(thickness), thickness.Check, thickness.Threshold, thickness.CheckMost, repr(face_limits))
    known = thickness.Proxy.cached_check
    if known is None or known[0] != depends:
        try:
            parts = parts_of(thickness)
        except ThinPartError:  # the view has said that the map cannot be read
            return None
        found = CheckedMaps(checked_facets(parts, limits_of_map(thickness, thickness.Check), face_limits), has_thick)
        thickness.Proxy.cached_check = known = depends, found
    return known[1]
