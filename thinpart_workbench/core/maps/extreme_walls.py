# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thinnest and the thickest wall of thickness maps, as they are labelled in the view."""

from dataclasses import dataclass

import numpy as np

from ..analysis_settings import RAY
from ..rays.ray_casting import INNER, OUTER
from ..record.thinnest_sentence import thinnest_kind
from ..rigid_transform import transform_points
from .map_search import MapSearch

_REACH = 0.01
"""How far a facet may lie from where the record has the thinnest wall, as a share of the diagonal of the map."""

_MOST_PLACES = 32
"""Places at which a wall is labelled, the first one of them that can be seen."""

_EQUAL = 0.005
"""Walls that differ by no more than this share are equally thin, or thick: the label stands where one of them is seen."""

_CANDIDATES, _BATCH = 200, 100
"""Facets looked at for the thickest wall, and how many at once, the thickest first."""

_SLENDER = 3.0
"""A wall seen along its length is that many times longer than it is wide: the rim of a cup, the end of a rod."""

_SIDES = 4
"""Lines through the middle of a wall along which its width is measured."""


@dataclass(frozen=True)
class ExtremeWall:
    """A wall that is labelled.

    Attributes
    ----------
    value : float, mm
    places : ndarray of shape (p, 2, 3), mm
        Both ends of this wall and of others that are as thick, at the occurrences of the part, in the coordinates of the
        document when it was measured.
    kind : str
        What the thinnest wall of a record is, see `thinnest_kind`.
    """

    value: float
    places: np.ndarray
    kind: str = ""


def thinnest_wall(parts):
    """Find the thinnest wall.

    Returns an ExtremeWall or None: the wall that the records name, which has some extent and is confirmed; a map of balls
    tells the ball there, because balls shrink to nothing towards every sharp edge. Without a record, the least thickness of
    a map. None where nothing was measured.
    """
    found = [wall for part in parts for wall in [_thinnest_of(part)] if wall is not None]
    return min(found, key=lambda wall: wall.value, default=None)


def thickest_wall(parts, sight):
    """Find the thickest wall: ExtremeWall, or None where nothing was measured.

    Rays from a rim run along the wall, and tell its length. So the width of the material is measured half-way along each
    ray, and walls more than `_SLENDER` times thicker than wide are passed over while there are others.

    Parameters
    ----------
    parts : list of MappedPart
    sight : MapSight
        Of these parts.
    """
    found = [wall for part, scene in zip(parts, sight.scenes) for wall in [_thickest_of(part, scene)] if wall is not None]
    return max(found, key=lambda wall: wall.value, default=None)


def _thinnest_of(part):
    shown = part.map
    if shown.ends is None:
        return None
    witnesses = [face["witness"] for face in part.record.get("faces", ()) if face["witness"] is not None]
    if not witnesses:
        order = np.argsort(shown.thickness, kind="stable")  # nan comes last
        least = shown.thickness[order[0]]
        return _walls_of(part, order[:np.searchsorted(shown.thickness[order], (1.0 + _EQUAL) * least, side="right")])
    witnesses.sort(key=lambda each: each["distance"])
    least = witnesses[0]["distance"]
    if shown.measure == RAY:
        return ExtremeWall(least, _placed(part, [
            each["points"] for each in witnesses if each["distance"] <= (1.0 + _EQUAL) * least]), thinnest_kind(part.record))
    extent = float(np.linalg.norm(np.ptp(shown.points, axis=0)))
    facet = MapSearch(shown).nearest_facet(np.asarray(witnesses[0]["points"][0]), _REACH * extent)
    value = float(shown.thickness[facet]) if facet >= 0 else np.nan
    return ExtremeWall(value, _placed(part, [witnesses[0]["points"]])) if np.isfinite(value) else None


def _thickest_of(part, scene):
    shown = part.map
    if shown.ends is None:
        return None
    if shown.measure != RAY:
        return _walls_of(part, _as_thick(shown, np.flatnonzero(shown.measured), shown.ends[1]))
    facets = _candidates(shown)
    for first in range(0, len(facets), _BATCH):
        batch = facets[first:first + _BATCH]
        walls = np.array([_ends(shown, facet) for facet in batch])
        compact = batch[_are_compact(scene, walls)]
        if len(compact):
            return _walls_of(part, _as_thick(shown, compact, shown.thickness[compact[0]]))
    return _walls_of(part, _as_thick(shown, facets, shown.thickness[facets[0]]))


def _as_thick(shown, facets, most):
    """Those facets that are about as thick as the thickest, which comes first."""
    facets = facets[shown.thickness[facets] >= (1.0 - _EQUAL) * most]
    return facets[np.argsort(-shown.thickness[facets], kind="stable")]


def _candidates(shown):
    """Facets in descending order of thickness: the thickest of each face, and others spread over all thicknesses."""
    order = np.flatnonzero(shown.measured)
    order = order[np.argsort(-shown.thickness[order], kind="stable")]
    _, first = np.unique(shown.face[order], return_index=True)
    spread = np.linspace(0, len(order) - 1, min(len(order), _CANDIDATES)).astype(int)
    return order[np.unique(np.concatenate([np.sort(first)[:_CANDIDATES], spread]))]


def _are_compact(scene, walls):
    """Whether the material half-way along lines through walls is wide enough: ndarray of shape (k,), bool."""
    middles = walls.mean(axis=1)
    along = walls[:, 1] - walls[:, 0]
    length = np.maximum(np.linalg.norm(along, axis=1), np.finfo(float).tiny)
    along /= length[:, None]
    across = np.cross(along, np.eye(3)[np.argmin(np.abs(along), axis=1)])
    across /= np.maximum(np.linalg.norm(across, axis=1), np.finfo(float).tiny)[:, None]
    other = np.cross(along, across)
    angles = np.pi * np.arange(_SIDES) / _SIDES
    lines = (np.cos(angles)[:, None, None] * across + np.sin(angles)[:, None, None] * other).reshape(-1, 3)
    starts, limits = np.tile(middles, (_SIDES, 1)), np.tile(length / _SLENDER, _SIDES)
    width, is_inside = np.zeros(len(lines)), np.ones(len(lines), dtype=bool)
    for way in (1.0, -1.0):
        found, entered = (scene.distances_within(starts, way * lines, limits, side) for side in (INNER, OUTER))
        width += found
        is_inside &= entered >= found  # half-way along a curved wall, a line may have left the material
    wide = is_inside & (width >= limits * (1.0 - 1e-6))
    return wide.reshape(_SIDES, -1).all(axis=0)


def _ends(shown, facet):
    middle = shown.corners[facet].mean(axis=0) + shown.origin
    _, opposite = shown.wall_at(facet, middle)
    return middle, opposite


def _walls_of(part, facets):
    """The wall under the first of some facets, and places of it under the others."""
    value = float(part.map.thickness[facets[0]])
    chosen = facets[np.unique(np.linspace(0, len(facets) - 1, min(len(facets), _MOST_PLACES)).astype(int))]
    return ExtremeWall(value, _placed(part, [_ends(part.map, facet) for facet in chosen]))


def _placed(part, walls):
    """Both ends of walls at the occurrences of their part: ndarray of shape (p, 2, 3), mm."""
    walls = np.asarray(walls, dtype=np.float64)
    points = np.concatenate([transform_points(matrix, walls.reshape(-1, 3)) for matrix in part.matrices[:_MOST_PLACES]])
    return points.reshape(-1, 2, 3)[:_MOST_PLACES]
