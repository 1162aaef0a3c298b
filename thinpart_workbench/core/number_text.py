# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers as text for people: with a decimal point, which `with_decimal_mark` replaces for other languages."""

import math

_NOTHING = 1e-6
"""Percent up to which a sum of shares is only rounding."""


def rounded_up(value):
    """A positive number rounded up to two digits."""
    digit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f"{math.ceil(value / digit - 1e-9) * digit:.6g}")


def percent(share):
    """Format a share as a percentage; empty for None. What is there, but too small to be written, is less than 0.1 %."""
    if share is None:
        return ""
    value = 100.0 * share
    if abs(value) >= 1000.0:
        return ">999\u00a0%" if value > 0 else "<\u2212999\u00a0%"
    if _NOTHING < value < 0.05:
        return "<\u00a00.1\u00a0%"
    # Rounding may leave sums of shares slightly below 0.
    value = 0.0 if abs(value) < 0.05 else value
    digits = 0 if abs(value) >= 9.95 or value == 0.0 else 1
    return f"{value:.{digits}f}\u00a0%".replace("-", "\u2212")


def bound_text(millimetres):
    """Format an error bound, mm, with two significant digits."""
    return number(millimetres, 2) if millimetres >= 0.001 else "<\u00a00.001"


def number(value, digits=3):
    """Format a quantity with some significant digits, without an exponent unless it is tiny."""
    if value is None:
        return "\u2013"
    return f"{value:.0f}" if abs(value) >= 10.0 ** digits - 0.5 else f"{value:.{digits}g}"


def with_decimal_mark(text, mark):
    """A text of numbers, and of nothing that may be a name or a version, with another mark in place of the decimal point."""
    return text.replace(".", mark)
