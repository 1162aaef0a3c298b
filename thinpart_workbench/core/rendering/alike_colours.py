# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether one colour may be taken for another."""

import colorsys

_PALE, _DARK = 0.3, 0.15
"""Saturation and value below which a colour is seen as grey or black."""

_HUES = 40.0 / 360.0
"""Hues that are called by one name, or by that of a neighbour: red and crimson, orange and brass."""


def is_alike(colour, other):
    """Whether a colour may be taken for another one, as brown for orange: both as red, green and blue from 0 to 1.

    Light and shade change how bright a surface is seen, so that only the hue tells.

    Examples
    --------
    >>> is_alike((0.6, 0.4, 0.2), (0.96, 0.60, 0.11)), is_alike((0.1, 0.4, 0.9), (0.96, 0.60, 0.11))
    (True, False)
    """
    (hue, saturation, value), (other_hue, _, _) = colorsys.rgb_to_hsv(*colour), colorsys.rgb_to_hsv(*other)
    if saturation < _PALE or value < _DARK:
        return False
    apart = abs(hue - other_hue)
    return min(apart, 1.0 - apart) < _HUES
