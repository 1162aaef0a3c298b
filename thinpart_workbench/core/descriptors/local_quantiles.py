# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantiles of the local thickness, apart from its distribution for what has to do without numpy."""

QUANTILES = {"T05": 0.05, "T50": 0.5, "T75": 0.75, "T99": 0.99}
"""Shares of the surface at which the local thickness is recorded."""
