# SPDX-License-Identifier: LGPL-2.1-or-later
"""Facets of a thickness map, and lines of a section, cut where colours change in steps."""

from dataclasses import dataclass, replace

import numpy as np

EVEN = 1e-4
"""Share of a level within which a wall is as thick as the level: maps have points in float32. Such facets stay whole."""

_INSIDE = 1e-6
"""Share by which a value at the end of a step is moved into it, so that it has the colour of the step after rounding."""


@dataclass(frozen=True)
class LevelCuts:
    """Pieces of the facets on which the thickness passes a level.

    Attributes
    ----------
    facet : ndarray of shape (k,), int64
        The facet that each piece is a part of.
    weights : ndarray of shape (k, 3, 3)
        Corner of the piece, and its shares of the corners of the facet.
    thickness : ndarray of shape (k, 3), mm
        At the corners of the piece.
    """

    facet: np.ndarray
    weights: np.ndarray
    thickness: np.ndarray

    def at_corners(self, values):
        """What is linear on facets, at the corners of the pieces: from (m, 3, n) to ndarray of shape (k, 3, n)."""
        return np.einsum("kij,kjn->kin", self.weights, values[self.facet])


def cut_at_levels(shown, levels):
    """Cut the facets of a map along lines of equal thickness: LevelCuts.

    Parameters
    ----------
    shown : ThicknessMap
    levels : sequence of float, mm
        Ascending.
    """
    values = shown.corner_thickness.astype(np.float64)
    facet = np.flatnonzero(_passed(values, levels)[1] > 0)
    pieces = facet, np.broadcast_to(np.eye(3), (len(facet), 3, 3)), values[facet]
    done = []
    for level in levels if len(facet) else ():
        values = pieces[2]
        low, high = values.min(axis=1), values.max(axis=1)
        across = (low < level * (1.0 - EVEN)) & (high > level * (1.0 + EVEN))
        below = ~across & (values.mean(axis=1) < level)
        done.append(_chosen(pieces, below))
        lower, upper = _cut(_chosen(pieces, across), level)
        done.append(lower)
        pieces = tuple(np.concatenate(both) for both in zip(_chosen(pieces, ~across & ~below), upper))
    return LevelCuts(*(np.concatenate(each) for each in zip(*done, pieces)))


def _passed(values, levels):
    """Of each row of values, the number of the first level that lies between them, and how many do."""
    levels = np.asarray(levels, dtype=np.float64)
    first = np.searchsorted(levels, values.min(axis=1) / (1.0 - EVEN), "right")
    # Where nothing was measured, both are behind all levels.
    return first, np.searchsorted(levels, values.max(axis=1) / (1.0 + EVEN), "left") - first


def _chosen(pieces, rows):
    return tuple(each[rows] for each in pieces)


def _cut(pieces, level):
    """What lies below a level and what lies above it, each as (facet, weights, thickness)."""
    facet, weights, values = pieces
    above = values > level
    # Turn each piece so that its first corner is alone on its side.
    is_one_above = above.sum(axis=1) == 1
    alone = np.where(is_one_above, above.argmax(axis=1), (~above).argmax(axis=1))
    turn, rows = (alone[:, None] + np.arange(3)) % 3, np.arange(len(facet))[:, None]
    weights, values = weights[rows, turn], values[rows, turn]
    share = (level - values[:, :1]) / (values[:, 1:] - values[:, :1])
    ends = weights[:, :1] + share[..., None] * (weights[:, 1:] - weights[:, :1])
    at_level = np.full(len(facet), level)

    def piece(corners, thicknesses):
        return facet, np.stack(corners, axis=1), np.stack(thicknesses, axis=1)

    tip = piece([weights[:, 0], ends[:, 0], ends[:, 1]], [values[:, 0], at_level, at_level])
    rest = [piece([ends[:, 0], weights[:, 1], weights[:, 2]], [at_level, values[:, 1], values[:, 2]]),
            piece([ends[:, 0], weights[:, 2], ends[:, 1]], [at_level, values[:, 2], at_level])]
    lower = [_chosen(tip, ~is_one_above), *(_chosen(each, is_one_above) for each in rest)]
    upper = [_chosen(tip, is_one_above), *(_chosen(each, ~is_one_above) for each in rest)]
    return tuple(tuple(np.concatenate(each) for each in zip(*side)) for side in (lower, upper))


def section_at_levels(cut, levels):
    """Cut the lines of a section where the thickness passes a level: MapSection.

    Parameters
    ----------
    cut : MapSection
    levels : sequence of float, mm
        Ascending.
    """
    first, count = _passed(cut.thickness, levels)
    line = np.repeat(np.arange(len(count)), count + 1)
    number = np.arange(len(line)) - np.repeat(np.cumsum(count + 1) - count - 1, count + 1)
    is_falling = cut.thickness[:, 0] > cut.thickness[:, 1]
    values = np.where(is_falling[:, None], cut.thickness[:, ::-1], cut.thickness)[line]
    ends = np.where(is_falling[:, None, None], cut.ends[:, ::-1], cut.ends)[line]
    known = np.append(np.asarray(levels, dtype=np.float64), np.nan)
    at_start = np.where(number == 0, values[:, 0], known[np.minimum(first[line] + number - 1, len(levels))])
    at_end = np.where(number == count[line], values[:, 1], known[np.minimum(first[line] + number, len(levels))])
    thickness = np.stack([at_start, at_end], axis=1)
    span = values[:, 1:] - values[:, :1]
    share = np.divide(thickness - values[:, :1], span, out=np.broadcast_to([0.0, 1.0], thickness.shape).copy(),
                      where=span > 0.0)
    ends = ends[:, :1] + share[..., None] * (ends[:, 1:] - ends[:, :1])
    return replace(cut, ends=ends, facet=cut.facet[line], thickness=thickness)


def within_steps(thickness, levels):
    """The values at corners of pieces, moved into the step that the middle of their piece is in.

    A colour that changes at a level is then the same all over a piece that ends there. Returns an ndarray of shape (k, n),
    mm.

    Parameters
    ----------
    thickness : ndarray of shape (k, n), mm
    levels : sequence of float, mm
        Ascending.
    """
    ends = np.concatenate([[-np.inf], levels, [np.inf]])
    # In float32, as `are_between` compares: a wall of 2.1 mm is not thinner than 2.1 mm.
    middle = thickness.astype(np.float64).mean(axis=1).astype(np.float32)
    step = np.searchsorted(np.asarray(levels, dtype=np.float32), middle, "right")
    low, high = ends[step] * (1.0 + _INSIDE), ends[step + 1] * (1.0 - _INSIDE)
    return np.clip(thickness, low[:, None], high[:, None])
