"""Numbers as text for people: with a decimal point, which `with_decimal_mark` replaces for other languages."""

import re

_POINT = re.compile(r"(?<![\w.])([<\u2212-]?\d+)\.(\d+)(?=$|[\s\u00a0%\u2013,;:)]|\.(?:\s|$))")


def percent(share):
    """Format a share as a percentage; empty for None, and 0 below a twentieth of a percent."""
    if share is None:
        return ""
    value = 100.0 * share
    if abs(value) >= 1000.0:
        return ">999\u00a0%" if value > 0 else "<\u2212999\u00a0%"
    # Rounding may leave sums of shares slightly below 0.
    value = 0.0 if abs(value) < 0.05 else value
    digits = 0 if abs(value) >= 9.95 or value == 0.0 else 1
    return f"{value:.{digits}f}\u00a0%".replace("-", "\u2212")


def bound_text(millimetres):
    """Format an error bound, mm, with two significant digits."""
    return f"{millimetres:.2g}" if millimetres >= 0.001 else "<\u00a00.001"


def number(value):
    """Format a quantity with three significant digits, without an exponent unless it is tiny."""
    if value is None:
        return "\u2013"
    return f"{value:.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"


def with_decimal_mark(text, mark):
    """Replace the decimal point of the numbers in a text by another mark. Names of files and versions are left alone."""
    return text if mark == "." else _POINT.sub(rf"\1{mark}\2", text)
