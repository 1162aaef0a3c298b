# SPDX-License-Identifier: LGPL-2.1-or-later
"""Area of the surface by wall thickness: the paper's normalized distance distribution."""

from dataclasses import dataclass, replace
from typing import Optional

import numpy as np

from ..tolerances import TOLERANCES
from .bins import ANGLE_STEP, BINS, MIDDLE_BINS


@dataclass(frozen=True)
class MiddleDistribution:
    """Area shares by thickness in units of D2.

    Attributes
    ----------
    bins : ndarray of shape (m,), int64
        Non-empty bins, ascending; bin b covers ``[b / 100, (b + 1) / 100)``. Thicker walls than D2 are in none.
    parallel, nonparallel : ndarray of shape (m,)
        Share of the whole surface in each.
    """

    bins: np.ndarray
    parallel: np.ndarray
    nonparallel: np.ndarray


@dataclass(frozen=True)
class Distribution:
    """Area shares by thickness; any threshold can be evaluated from them without geometry.

    Attributes
    ----------
    bins : ndarray of shape (k,), int64
        Non-empty bins of x, ascending; bin b covers ``[b / 1000, (b + 1) / 1000)``.
    area : ndarray of shape (k,)
        Share of the whole surface in each, parallel walls only.
    nonparallel_bins, nonparallel_angles, nonparallel_area : ndarray of shape (j,)
        Bin of x, lower edge of the wedge angle bin in degrees, share of the whole surface.
    parallel, nonparallel, unmeasured : float
        Shares of the surface over parallel walls, over non-parallel walls, and over no wall or only
        one at 60 degrees or more. They sum to 1.
    unmet : float
        The part of `unmeasured` whose rays hit nothing, as on an open surface: nothing is known about the wall
        there. (A wall at 60 degrees or more is known not to be thin.)
    middle : MiddleDistribution or None
        None in records of earlier versions, and of measurements by pairs.
    """

    bins: np.ndarray
    area: np.ndarray
    nonparallel_bins: np.ndarray
    nonparallel_angles: np.ndarray
    nonparallel_area: np.ndarray
    parallel: float
    nonparallel: float
    unmeasured: float
    unmet: float
    middle: Optional[MiddleDistribution] = None

    def share(self, low, high):
        """F[low; high]: share of the surface over parallel walls with low <= x < high.

        The bounds are rounded to the nearest bin edges. A bound of 1 includes the last bin.
        """
        chosen = (self.bins >= round(low * BINS)) & (self.bins < round(high * BINS))
        return float(self.area[chosen].sum())

    def spread_share(self, low, high):
        """As `share`, with bins that the bounds cut counted in part, as if their area were spread evenly over them."""
        return _within(self.bins, self.area, low * BINS, high * BINS)

    def middle_share(self, low, high, unit, slanted=True):
        """Share of the surface over walls between two bounds in units of D2.

        Parallel ones, and where `slanted` is true those at less than 60 degrees too. A bin that a bound cuts counts in
        part, as if its area were spread evenly over it.

        Parameters
        ----------
        low, high : float
        unit : float
            D2 in diagonals.
        slanted : bool
        """
        count, (bins, area), nonparallel = self._middle_bins(high, unit)
        share = _within(bins, area, low * count, high * count)
        if not slanted:
            return share
        bins, area = nonparallel
        return share + _within(bins, area, low * count, high * count)

    def middle_quantile(self, share, unit, slanted=True):
        """The thickness, in units of D2, under which a share of the surface lies over walls; inf where walls cover less.

        Areas are taken as spread evenly over their bins, and walls are those that `middle_share` takes.
        """
        count, parallel, nonparallel = self._middle_bins(1.0, unit)
        bins, area = parallel
        if slanted:
            bins, area = np.concatenate([bins, nonparallel[0]]), np.concatenate([area, nonparallel[1]])
        per_bin = np.bincount(bins, area, 1)
        reached = np.cumsum(per_bin)
        first = int(np.searchsorted(reached, share))
        if first >= len(reached):
            return float("inf")
        return (first + 1.0 - (reached[first] - share) / per_bin[first]) / count

    def median(self):
        """The thickness, in diagonals, of the middle wall by area, parallel ones and others: float or None, to 0.001."""
        per_bin = np.bincount(np.concatenate([self.bins, self.nonparallel_bins]),
                              np.concatenate([self.area, self.nonparallel_area]), 1)
        reached = np.cumsum(per_bin)
        if not reached[-1] > 0.0:
            return None
        half = 0.5 * float(reached[-1])
        first = int(np.searchsorted(reached, half))
        return (first + 1.0 - float(reached[first] - half) / float(per_bin[first])) / BINS

    def _middle_bins(self, high, unit):
        """Bins per D2, and bins with areas of parallel and of other walls: the finest that reach up to `high`."""
        if self.middle is not None and high <= 1.0:
            return MIDDLE_BINS, (self.middle.bins, self.middle.parallel), (self.middle.bins, self.middle.nonparallel)
        return BINS * unit, (self.bins, self.area), (self.nonparallel_bins, self.nonparallel_area)

    def nonparallel_minimum(self, floor, from_angle=10, to_angle=55):
        """Smallest x at which non-parallel walls reach an area share: float or None.

        Lower edge of the bin; None where the floor is never reached.

        Parameters
        ----------
        floor : float
            Area share that must be reached.
        from_angle, to_angle : int
            Wedge angles, degrees.
        """
        chosen = (self.nonparallel_angles >= from_angle) & (self.nonparallel_angles < to_angle)
        per_bin = np.bincount(
            self.nonparallel_bins[chosen], self.nonparallel_area[chosen], minlength=BINS
        )
        reached = np.flatnonzero(np.cumsum(per_bin) >= max(floor, np.finfo(float).tiny))
        return float(reached[0]) / BINS if len(reached) else None


def distribution(field, diagonal, middle):
    """Compute the distribution of a thickness field: Distribution.

    Parameters
    ----------
    field : ThicknessField
    diagonal, middle : float, mm
        Diagonal of the part's bounding box, and its middle side.
    """
    share = field.area / field.area.sum()
    parallel, nonparallel = field.parallel, field.nonparallel
    keys = np.concatenate([
        table_key(field.distance[parallel] / diagonal),
        table_key(field.distance[nonparallel] / diagonal, field.wedge_angle[nonparallel]),
    ])
    area = np.concatenate([share[parallel], share[nonparallel]])
    shares = (share[parallel].sum(), share[nonparallel].sum())
    found = tabulate(keys, area, *shares, share[field.opposite < 0].sum())
    return replace(found, middle=_by_middle(field, share, middle))


def _by_middle(field, share, middle):
    in_middle = np.floor((field.distance / middle + TOLERANCES.bin_edge) * MIDDLE_BINS)
    parallel, nonparallel = (
        np.bincount(in_middle[chosen].astype(np.int64), share[chosen], MIDDLE_BINS)
        for chosen in (each & (in_middle < MIDDLE_BINS) for each in (field.parallel, field.nonparallel)))
    used = np.flatnonzero(parallel + nonparallel)
    return MiddleDistribution(used, parallel[used], nonparallel[used])


def _within(bins, area, low, high):
    """Area in bins between two bounds, both counted in bins; cut bins in part: float."""
    covered = np.minimum(bins + 1.0, high) - np.maximum(bins, low)
    return float((area * np.clip(covered, 0.0, 1.0)).sum())


def tabulate(keys, area, parallel, nonparallel, unmet):
    """Sum area shares by `table_key` into a `Distribution`."""
    used, which = np.unique(keys, return_inverse=True)
    total = np.bincount(which.ravel(), area, minlength=len(used))
    used, total = used[total > 0.0], total[total > 0.0]
    slanted = used >= BINS
    angle, bins = np.divmod(used[slanted] - BINS, BINS)
    order = np.lexsort([angle, bins])
    parallel, nonparallel, unmet = float(parallel), float(nonparallel), float(unmet)
    unmeasured = 1.0 - parallel - nonparallel
    if unmeasured < 1e-12:  # rounding of a sum, which must not look like a result
        parallel = min(parallel, 1.0)
        unmeasured, nonparallel = 0.0, 1.0 - parallel
    return Distribution(
        used[~slanted], total[~slanted], bins[order], angle[order] * ANGLE_STEP,
        total[slanted][order], parallel, nonparallel, unmeasured, min(unmet, unmeasured),
    )


def table_key(x, wedge_angle=None):
    """Key of a cell of both tables: the bin of x; for slanted walls plus 1000 times one more than the angle bin."""
    if wedge_angle is None:
        return bin_of(x)
    angle = (np.degrees(wedge_angle + TOLERANCES.angle) / ANGLE_STEP).astype(np.int64)
    return BINS + angle * BINS + bin_of(x)


def bin_of(x):
    """ndarray of int64: bin of each x; an x that is a rounding error below an edge counts as on the edge."""
    index = np.floor((x + TOLERANCES.bin_edge) * BINS).astype(np.int64)
    return np.clip(index, 0, BINS - 1)
