"""How much of the surface lies over which thickness: the paper's normalized distance distribution."""

from dataclasses import dataclass

import numpy as np

from .tolerances import TOLERANCES

BINS = 1000
"""Bins of x = distance / diagonal: 0.05, 0.25, 0.29, 0.3 and 0.7 are bin edges."""

ANGLE_STEP = 5
"""Width of the wedge angle bins, degrees."""


@dataclass(frozen=True)
class Distribution:
    """Area shares by thickness, from which every later threshold is evaluated without geometry.

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
        The part of `unmeasured` that met nothing at all, as happens on an open surface: what is
        there is not known. (A wall at 60 degrees or more is known not to be thin.)
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

    def share(self, low, high):
        """F[low; high]: share of the surface over parallel walls with low <= x < high.

        Breakpoints are rounded to whole bins; 1 closes the last bin.
        """
        inside = (self.bins >= round(low * BINS)) & (self.bins < round(high * BINS))
        return float(self.area[inside].sum())

    def nonparallel_minimum(self, floor, from_angle=10, to_angle=55):
        """Smallest x at which non-parallel walls reach an area share.

        Parameters
        ----------
        floor : float
            Area share that must be reached.
        from_angle, to_angle : int
            Wedge angles, degrees.

        Returns
        -------
        float or None
            Lower edge of the bin; None where the floor is never reached.
        """
        chosen = (self.nonparallel_angles >= from_angle) & (self.nonparallel_angles < to_angle)
        per_bin = np.bincount(
            self.nonparallel_bins[chosen], self.nonparallel_area[chosen], minlength=BINS
        )
        reached = np.flatnonzero(np.cumsum(per_bin) >= max(floor, np.finfo(float).tiny))
        return float(reached[0]) / BINS if len(reached) else None


def distribution(field, diagonal):
    """Distribution of a thickness field.

    Parameters
    ----------
    field : ThicknessField
    diagonal : float, mm
        Diagonal of the part's bounding box.

    Returns
    -------
    Distribution
    """
    share = field.area / field.area.sum()
    parallel, nonparallel = field.parallel, field.nonparallel
    keys = np.concatenate([
        table_key(field.distance[parallel] / diagonal),
        table_key(field.distance[nonparallel] / diagonal, field.wedge_angle[nonparallel]),
    ])
    area = np.concatenate([share[parallel], share[nonparallel]])
    shares = (share[parallel].sum(), share[nonparallel].sum())
    return tabulate(keys, area, *shares, share[field.opposite < 0].sum())


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
    if unmeasured < 1e-12:  # the rounding of a sum, which must not look like a finding
        parallel = min(parallel, 1.0)
        unmeasured, nonparallel = 0.0, 1.0 - parallel
    return Distribution(
        used[~slanted], total[~slanted], bins[order], angle[order] * ANGLE_STEP,
        total[slanted][order], parallel, nonparallel, unmeasured, min(unmet, unmeasured),
    )


def table_key(x, wedge_angle=None):
    """One number per cell of both tables: the bin of x, after 1000 the angle bin times 1000."""
    if wedge_angle is None:
        return bin_of(x)
    angle = (np.degrees(wedge_angle + TOLERANCES.angle) / ANGLE_STEP).astype(np.int64)
    return BINS + angle * BINS + bin_of(x)


def bin_of(x):
    """Bin of each x, ndarray of int64; what lies a rounding error under an edge lies on it."""
    index = np.floor((x + TOLERANCES.bin_edge) * BINS).astype(np.int64)
    return np.clip(index, 0, BINS - 1)
