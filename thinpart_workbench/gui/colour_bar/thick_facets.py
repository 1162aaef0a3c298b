# SPDX-License-Identifier: LGPL-2.1-or-later
"""The facets of a shown map that are too thick for the process that is checked; they are the same until that changes."""

from ...api.document_maps import map_version, parts_of
from ...api.window.limits import limits_of_map, too_thick_facets
from ...core.analysis_settings import RAY
from ...core.errors import ThinPartError
from ..application import lifelong


class ThickFacets:
    """Facets that are too thick; equal only to itself, which is quick to compare.

    Attributes
    ----------
    of_parts : list of ndarray of shape (m,), bool
        By part number.
    """

    def __init__(self, of_parts):
        self.of_parts = of_parts


def thick_facets(thickness):
    """ThickFacets of a thickness object; None where no greatest wall is checked, or balls are shown.

    Limits for single faces count as soon as they are known to the window.
    """
    if not (thickness.Check and thickness.CheckMost > 0.0 and thickness.Measure == RAY):
        return None
    face_limits = (lifelong.face_limits and lifelong.face_limits.known(thickness.Document.FileName)) or {}
    depends = (map_version(thickness), thickness.Check, thickness.Threshold, thickness.CheckMost, repr(face_limits))
    known = thickness.Proxy.cached_thick
    if known is None or known[0] != depends:
        try:
            parts = parts_of(thickness)
        except ThinPartError:  # the view has said that the map cannot be read
            return None
        found = ThickFacets(too_thick_facets(parts, limits_of_map(thickness, thickness.Check), face_limits))
        thickness.Proxy.cached_thick = known = depends, found
    return known[1]
