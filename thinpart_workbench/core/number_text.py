"""Numbers as people read them, in whatever language."""


def percent(share):
    """A share as people read it; empty for None, and 0 below a twentieth of a percent."""
    if share is None:
        return ""
    value = 100.0 * share
    if abs(value) >= 1000.0:
        return ">999\u00a0%" if value > 0 else "<\u2212999\u00a0%"
    # Sums of shares may end a rounding below 0.
    value = 0.0 if abs(value) < 0.05 else value
    digits = 0 if abs(value) >= 9.95 or value == 0.0 else 1
    return f"{value:.{digits}f}\u00a0%".replace("-", "\u2212")


def bound_text(millimetres):
    """An error bound with two significant digits."""
    return f"{millimetres:.2g}" if millimetres >= 0.001 else "<\u00a00.001"


def number(value):
    """A quantity with three significant digits, never in powers of ten unless it is tiny."""
    if value is None:
        return "\u2013"
    return f"{value:.0f}" if abs(value) >= 1000.0 else f"{value:.3g}"
