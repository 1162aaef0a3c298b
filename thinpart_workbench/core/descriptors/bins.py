# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bins of the distribution, apart from it for what has to do without numpy."""

BINS = 1000
"""Bins of x = distance / diagonal: 0.05, 0.25, 0.29, 0.3 and 0.7 are bin edges."""

MIDDLE_BINS = 100
"""Bins of thickness / D2, the middle side of the box: 0.06, 0.08 and 0.12 are bin edges. Of a slender part, one bin of x is
as wide as the part."""

ANGLE_STEP = 5
"""Width of the wedge angle bins, degrees."""
