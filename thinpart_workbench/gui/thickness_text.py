"""Thicknesses as people read them."""

from .qt import translate


def number_text(value):
    """A number with as many digits as can be told apart on a scale."""
    return f"{value:.4g}"


def thickness_text(value):
    """A thickness in mm with its unit."""
    return translate("ThinPart", "{} mm").format(number_text(value))
