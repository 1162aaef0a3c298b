# SPDX-License-Identifier: LGPL-2.1-or-later
"""The check of a thickness map: its limits, and the result for some of its parts in words."""

import numpy as np

from ...api.window.limits import checked, limits_of_map
from ...core.analysis_settings import RAY
from ...core.judging.limit_bands import FAILS, JUST_ABOVE, PASSES, TOO_THICK
from ...core.maps.map_summary import between, share_of
from ...freecad_adapter.objects.thickness_object import OWN_CHECK
from ..application.numbers import percent
from ..application.qt import translate
from ..colour_bar.colours import BAND_COLOURS
from ..record.wall_checks import check_line


def checked_limits(thickness):
    """The limits that a map is checked against: WallLimits, or None."""
    return limits_of_map(thickness, translate("ThinPart", "Own limit"))


def map_check_text(records, limits, unit, measure):
    """The result of a check of a list of PartRecord: str.

    A sentence for one part, how many fail for several; empty without limits. Checks do not depend on what the colours show,
    by the one of `SHOWN_MEASURES`: where that is not the thickness across, another sentence says so.
    """
    if limits is None:
        return ""
    checks = [checked(record, limits) for record in records]
    if len(checks) == 1:
        result = check_line(checks[0], unit)
    else:
        failed = sum(check.holds is False for check in checks)
        result = translate("ThinPart", "{} of {} parts fail").format(failed, len(checks))
    if measure == RAY:
        return result
    if limits.name == OWN_CHECK:
        return f"{result}\n" + translate(
            "ThinPart", "Colours and shares are of the largest balls inside, which shrink to nothing towards sharp edges; "
            "the line above is of the thickness across the wall.")
    return f"{result}\n" + translate(
        "ThinPart", "Checks compare the least wall with the thickness across the wall, and the greatest with the largest "
        "balls inside: choose the thickness across the wall under 'Colours show' to see where the limits are broken.")


def band_texts(numbered, colours):
    """The share of the surface of parts in each colour of a check: list of (tuple, str).

    Colour of each LimitBand, red, green and blue from 0 to 255, and its share of all area in words.

    Parameters
    ----------
    numbered : dict of int to MappedPart
        By part number.
    colours : ThicknessColours
    """
    parts, found = list(numbered.values()), []
    for band in colours.bands:
        chosen = [_are_in(band, colours.compared(number, part.map), colours, colours.are_thick(number))
                  for number, part in numbered.items()]
        found.append((BAND_COLOURS[band.name], _band_words(band.name).format(percent(share_of(parts, chosen)))))
    return found


def _are_in(band, shown, colours, thick):
    """Which facets of a map have the colour of a band: ndarray of bool."""
    over = np.zeros(shown.count, bool) if thick is None else thick & ~colours.are_failing(shown.thickness)
    return over if band.name == TOO_THICK else between(shown, band.low, band.high) & ~over


def _band_words(name):
    if name == FAILS:
        return translate("ThinPart", "{} fails")
    if name == JUST_ABOVE:
        return translate("ThinPart", "{} just above")
    if name == PASSES:
        return translate("ThinPart", "{} passes")
    return translate("ThinPart", "{} too thick")
