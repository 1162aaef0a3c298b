# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where labels stand in a picture: beside what they name, clear of each other and, if there is room, of the part."""

import numpy as np

_ANGLES = 2.0 * np.pi * np.arange(16) / 16
_DISTANCES = np.array([1.2, 2.2, 3.6, 5.5, 8.0, 11.0, 15.0])
"""Length of a leader, in heights of a label."""

_ROUNDS = 2
"""How often every label is placed, the others being where they are."""

_BESIDE = 0.35
"""How far a label stays off any named place, in heights of a label."""

_ON_OBSTACLE, _ON_LABEL, _ON_PLACE, _CROSSING, _LEADER_UNDER, _ON_PART, _LENGTH, _MOVED = (
    90.0, 90.0, 60.0, 12.0, 40.0, 7.0, 0.4, 1.5)
"""Costs: of lying all on an obstacle, on another label, on a named place, of two leaders that cross, of a leader that runs
all under another label, of lying all over the part, of a height of leader, and of another place than before."""

_ALONG = np.linspace(0.0, 1.0, 12)
"""Points of a leader at which is looked whether it runs under a label."""


def label_places(anchors, sizes, area, obstacles=(), crowd=None, before=None):
    """Place labels.

    Returns `places` (ndarray of shape (k, 2), pixels; left and top of each label, always within the area as far as it is
    large enough) and `chosen` (ndarray of shape (k,), int).

    Parameters
    ----------
    anchors : ndarray of shape (k, 2), pixels, downwards
        What each label names. The first labels choose first.
    sizes : ndarray of shape (k, 2), pixels
        Width and height of each label.
    area : (float, float, float, float)
        Left, top, right and bottom of where labels may stand.
    obstacles : sequence of (float, float, float, float)
        Left, top, right and bottom of what is not to be covered.
    crowd : ndarray of shape (n, 2), pixels, optional
        Points spread over the picture of the part, which is covered only where there is no better place.
    before : sequence of int, optional
        What was returned as chosen in the picture before, so that labels do not jump; -1 where there was none.
    """
    anchors, sizes = np.asarray(anchors, dtype=float).reshape(-1, 2), np.asarray(sizes, dtype=float).reshape(-1, 2)
    count = len(anchors)
    if not count:
        return np.empty((0, 2)), np.empty(0, dtype=int)
    options = [_options(anchor, size, area) for anchor, size in zip(anchors, sizes)]
    margin = _BESIDE * sizes[:, 1].min()
    crowded = None if crowd is None or not len(crowd) else _Crowd(crowd, area, 0.5 * sizes[:, 1].min())
    own = [_own_cost(rects, length, anchors, obstacles, crowded, margin) for rects, length in options]
    if before is not None:
        for cost, last in zip(own, before):
            if last >= 0:
                cost += _MOVED
                cost[last] -= _MOVED
    chosen, beside = np.full(count, -1), margin * np.array([-0.5, -0.5, 0.5, 0.5])
    for _ in range(_ROUNDS):
        for number, (rects, _) in enumerate(options):
            others = [other for other in range(count) if other != number and chosen[other] >= 0]
            cost = own[number].copy()
            for other in others:
                taken = options[other][0][chosen[other]]
                cost += _ON_LABEL * _covered(rects + beside, taken[None])[:, 0]
                cost += _LEADER_UNDER * _share_under(anchors[other], _middles(taken[None]), taken, rects)
                cost += _LEADER_UNDER * _share_under(anchors[number], _middles(rects), rects, taken[None])
                cost += _CROSSING * _crosses(anchors[number], _middles(rects), anchors[other], _middles(taken[None])[0])
            chosen[number] = int(np.argmin(cost))
    return np.array([options[number][0][chosen[number], :2] for number in range(count)]), chosen


def _options(anchor, size, area):
    """Rectangles where a label could stand: ndarray of shape (m, 4), and the length of the leader of each in its heights."""
    angle, distance = (part.ravel() for part in np.meshgrid(_ANGLES, _DISTANCES, indexing="ij"))
    directions = np.stack([np.cos(angle), -np.sin(angle)], axis=1)
    reach = distance * size[1] + np.abs(directions) @ (0.5 * size)
    corner = anchor + reach[:, None] * directions - 0.5 * size
    left, top, right, bottom = area
    corner = np.maximum(np.minimum(corner, np.array([right, bottom]) - size), (left, top))
    rects = np.concatenate([corner, corner + size], axis=1)
    off = np.maximum(np.maximum(rects[:, :2] - anchor, anchor - rects[:, 2:]), 0.0)
    return rects, np.linalg.norm(off, axis=1) / size[1]


def _own_cost(rects, length, anchors, obstacles, crowded, margin):
    """Cost of each rectangle without other labels: ndarray of shape (m,)."""
    cost = _LENGTH * length
    if len(obstacles):
        cost = cost + _ON_OBSTACLE * _covered(rects, np.asarray(obstacles, dtype=float).reshape(-1, 4)).sum(axis=1)
    near = (anchors > rects[:, None, :2] - margin) & (anchors < rects[:, None, 2:] + margin)
    cost = cost + _ON_PLACE * near.all(axis=2).sum(axis=1)
    if crowded is not None:
        cost = cost + _ON_PART * crowded.shares(rects)
    return cost


def _covered(rects, others):
    """Share of each rectangle that each of others covers: ndarray of shape (m, n)."""
    low = np.maximum(rects[:, None, :2], others[None, :, :2])
    high = np.minimum(rects[:, None, 2:], others[None, :, 2:])
    common = np.maximum(high - low, 0.0).prod(axis=2)
    return common / np.maximum((rects[:, 2:] - rects[:, :2]).prod(axis=1), 1e-9)[:, None]


class _Crowd:
    """A grid of cells, some of which hold a point."""

    def __init__(self, points, area, cell):
        self._low, self._cell = np.array(area[:2], dtype=float), cell
        size = np.maximum(np.ceil((np.array(area[2:]) - self._low) / cell).astype(int), 1)
        cells = np.floor((points - self._low) / cell).astype(int)
        cells = cells[((cells >= 0) & (cells < size)).all(axis=1)]
        grid = np.zeros(size)
        grid[cells[:, 0], cells[:, 1]] = 1.0
        self._sums = np.zeros(size + 1)
        self._sums[1:, 1:] = grid.cumsum(axis=0).cumsum(axis=1)

    def shares(self, rects):
        """Share of the cells under each rectangle that hold a point: ndarray of shape (m,)."""
        last = np.array(self._sums.shape) - 1
        low = np.clip(np.floor((rects[:, :2] - self._low) / self._cell).astype(int), 0, last)
        high = np.clip(np.ceil((rects[:, 2:] - self._low) / self._cell).astype(int), 0, last)
        total = (self._sums[high[:, 0], high[:, 1]] - self._sums[low[:, 0], high[:, 1]]
                 - self._sums[high[:, 0], low[:, 1]] + self._sums[low[:, 0], low[:, 1]])
        return total / np.maximum((high - low).prod(axis=1), 1)


def _middles(rects):
    return 0.5 * (rects[:, :2] + rects[:, 2:])


def _share_under(anchor, ends, own, rects):
    """Share of leaders, from a named place to labels, that runs under rectangles: ndarray of shape (m,)."""
    points = anchor + _ALONG[:, None, None] * (ends - anchor)
    under = (points > rects[:, :2]) & (points < rects[:, 2:])
    within = (points > own[..., :2]) & (points < own[..., 2:])
    return (under.all(axis=2) & ~within.all(axis=2)).mean(axis=0)


def _crosses(start, ends, other_start, other_end):
    """Whether lines from one point to each of some others cross a line: ndarray of shape (m,), bool."""
    def side(one, two, point):
        return (two[..., 0] - one[..., 0]) * (point[..., 1] - one[..., 1]) - (
            two[..., 1] - one[..., 1]) * (point[..., 0] - one[..., 0])

    return (side(start, ends, other_start) * side(start, ends, other_end) < 0.0) & (
        side(other_start, other_end, start) * side(other_start, other_end, ends) < 0.0)
