# SPDX-License-Identifier: LGPL-2.1-or-later
"""Area of the surface by local thickness."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from ..tolerances import TOLERANCES
from .bins import MIDDLE_BINS
from .local_quantiles import QUANTILES


@dataclass(frozen=True)
class LocalDistribution:
    """Shares of the surface by local thickness, in units of D2, the middle side of the box.

    Attributes
    ----------
    bins : ndarray of shape (k,), int64
        Non-empty bins, ascending; bin b covers ``[b / 100, (b + 1) / 100)``. The local thickness is at most D3.
    area : ndarray of shape (k,)
        Share of the whole surface in each.
    quantiles : Mapping of str to float
        By the names of `QUANTILES`: the local thickness which that share of the surface is below, exactly.
    """

    bins: np.ndarray
    area: np.ndarray
    quantiles: Mapping

    def share(self, low, high):
        """L[low; high]: share of the surface between two bounds; a bin that a bound cuts counts in part."""
        covered = np.minimum(self.bins + 1.0, high * MIDDLE_BINS) - np.maximum(self.bins, low * MIDDLE_BINS)
        return float((self.area * np.clip(covered, 0.0, 1.0)).sum())

    def quantile(self, share):
        """The local thickness which a share of the surface is below, float: areas are taken as spread over their bins."""
        reached = np.cumsum(self.area)
        first = min(int(np.searchsorted(reached, share)), len(reached) - 1)
        over = max(reached[first] - share, 0.0)
        return float((self.bins[first] + 1.0 - over / self.area[first]) / MIDDLE_BINS)


def local_distribution(thickness, area, middle):
    """Tabulate local thicknesses: LocalDistribution.

    Parameters
    ----------
    thickness : ndarray of shape (m,), mm
    area : ndarray of shape (m,), mm2
    middle : float, mm
        D2.
    """
    x, share = np.minimum(thickness / middle, 1.0), area / area.sum()  # a ball fits in the box, apart from rounding
    number = np.floor((x + TOLERANCES.bin_edge) * MIDDLE_BINS).astype(np.int64)
    per_bin = np.bincount(np.minimum(number, MIDDLE_BINS - 1), share, MIDDLE_BINS)
    order = np.argsort(x, kind="stable")
    reached = np.searchsorted(np.cumsum(share[order]), list(QUANTILES.values()))
    values = x[order[np.minimum(reached, len(x) - 1)]]
    used = np.flatnonzero(per_bin)
    return LocalDistribution(used, per_bin[used], dict(zip(QUANTILES, map(float, values))))
