"""Thicknesses as people read them."""

from ..core.number_text import number
from .qt import translate


def tick_text(value):
    """A number at a tick of a scale, with as many digits as tell it from the next."""
    return f"{value:.4g}"


def thickness_text(value):
    """A thickness in mm with its unit, as exact as everywhere else in the window."""
    return translate("ThinPart", "{} mm").format(number(value))
