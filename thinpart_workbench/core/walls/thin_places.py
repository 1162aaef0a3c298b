# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a part is thinnest, over walls of any angle: the wall between each two faces, as far as it is one."""

from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from typing import Optional

import numpy as np

from ..mesh.sampling import corner_samples
from ..rays.ray_casting import INNER
from .depth_samples import depth_samples
from .face_thickness import Witness, witness_of
from .thickness_field import ThicknessField, likely_thinnest
from .thinnest_wall import first_of_extent
from .walls import NONPARALLEL_BELOW, PARALLEL_BELOW, walls_under

DEPTH = 1.0 / 200.0
"""Depth beside a sharp edge at which the thickness is told, as a share of the middle side of the box: half a millimetre
of a part that is 100 mm wide. What is no longer and no wider than that is not looked for."""

WALL_BELOW = np.radians(45.0)
"""Angle from which on an edge is no wall: at every depth beside it, the part is as thick as that is deep, or thicker."""

LEAST = 0.1
"""Thickness, in depths, below which faces touch, or one runs out into the other, rather than enclose a wall."""

LEAST_AT_EDGE = 1e-3
"""The same at the depth beside an edge in which they end, at however small an angle."""

SURELY_NARROW, SEEN_WELL = 0.25, 16
"""Width, in thicknesses, under which a taper that so many samples have seen is a broken edge, however they lie."""

BESIDE_EDGE = 4.0
"""Depths from a sharp edge within which two faces that meet there have a wall that ends in it, however short it is."""

MAY_BE_THINNER = 1.5
"""How many times as thick as where it is thinnest a tapered wall may be at a sample that represents no area."""

_MOST_STEEP = np.tan(NONPARALLEL_BELOW)

_ROUNDING = np.radians(0.2)
"""Facets and their normals turn angles by less."""


@dataclass(frozen=True)
class ThinPlaces:
    """The walls between pairs of faces, the thinnest first.

    Attributes
    ----------
    field : ThicknessField or None
        With the samples that were added to find them.
    samples : ndarray of shape (k,), int64
        Of that field, where each wall is thinnest.
    is_tapered, is_at_edge : ndarray of shape (k,), bool
        Whether the two sides are at 10 to 60 degrees there; and whether they meet in a sharp edge, so that the wall is told
        from `depth` beside it on.
    width : ndarray of shape (k,)
        Of a taper, in its thicknesses, as far as samples show; inf for others.
    depth : float, mm
    edges_mm : float, mm
        Length of the sharp edges, at which faces meet under less than `WALL_BELOW`.
    exact : tuple of Witness
        Those walls that were looked for in the part's own geometry, as it has them.
    """

    field: Optional[ThicknessField] = None
    samples: np.ndarray = dataclass_field(default_factory=lambda: np.zeros(0, dtype=np.int64))
    is_tapered: np.ndarray = dataclass_field(default_factory=lambda: np.zeros(0, dtype=bool))
    is_at_edge: np.ndarray = dataclass_field(default_factory=lambda: np.zeros(0, dtype=bool))
    width: np.ndarray = dataclass_field(default_factory=lambda: np.zeros(0))
    depth: float = 0.0
    edges_mm: float = 0.0
    exact: tuple = ()

    @property
    def distance(self):
        """ndarray of shape (k,), mm."""
        return np.zeros(0) if self.field is None else self.field.distance[self.samples]

    @property
    def is_narrow(self):
        """ndarray of shape (k,), bool: what is narrower than it is thick, such as a chamfer, is no wall."""
        return self.width < 1.0

    @property
    def may_be(self):
        """ndarray of shape (k,), mm: how thin each may be near its sample, where it is a taper."""
        if self.field is None:
            return np.zeros(0)
        slope = np.tan(self.field.wedge_angle[self.samples])
        thinner = np.minimum(self.distance / MAY_BE_THINNER, self.distance - slope * np.sqrt(self.field.area[self.samples]))
        return np.where(self.is_tapered, thinner, self.distance)

    def chosen(self, which):
        """Some of them, by a mask or numbers: ThinPlaces."""
        return replace(self, samples=self.samples[which], is_tapered=self.is_tapered[which],
                       is_at_edge=self.is_at_edge[which], width=self.width[which])

    def witness(self, number) -> Witness:
        """Where one of them is thinnest: Witness."""
        return witness_of(self.field, int(self.samples[number]))


def thin_places(field, rays, width):
    """Find the walls between pairs of faces, and where each is thinnest: ThinPlaces.

    Walls are at less than `NONPARALLEL_BELOW`. A wall that ends in a sharp edge is as thin as it is `DEPTH` beside it: at
    the edge itself, every one is 0 mm thick. Where a wall only rounds off or has its edge broken, it is not thinner. So
    these are not counted: two faces whose wall goes on getting thinner at steeper angles, such as a side and the fillet at
    its border; a taper that is narrower than its least thickness, such as a chamfer; an edge from `WALL_BELOW` on. A wall
    covers an area of `DEPTH` by `DEPTH`.

    Parameters
    ----------
    field : ThicknessField
    rays : InwardRays
    width : float, mm
        Middle side of the box of the part.
    """
    mesh, depth = field.mesh, DEPTH * width
    edges = field.sharp_edges
    whole, at_depth = _probed(field, rays, depth)
    pair, faces = _pairs(whole)
    lengths = _edge_lengths(mesh, edges, faces)
    counted, width = _counted(whole, edges, at_depth, pair, lengths, depth)
    ends_in_edge = lengths >= 2.0 * depth
    over = np.flatnonzero(counted & ~at_depth)
    least = first_of_extent(whole, over, pair[over], np.full(len(faces), depth * depth))
    beside = np.flatnonzero(counted & at_depth & ends_in_edge[pair])
    least = _thinner(whole, least, _first_of_pairs(whole, beside, pair, len(faces)))
    is_edge = is_blunt_edge(whole.wedge_angle[least], np.where(ends_in_edge, 0.0, whole.distance[least]), depth)
    samples = least[(least >= 0) & ~is_edge]
    if not mesh.has_faces:
        whole = _between_facets(whole, rays, samples)
    samples = samples[np.argsort(whole.distance[samples], kind="stable")]
    # However short the edge is at which two faces meet, just beside it their wall is no thicker than it is told there.
    at_edge = ends_in_edge[pair[samples]] | (
        (lengths[pair[samples]] > 0.0) & edges.are_near(whole.samples.points[samples], BESIDE_EDGE * depth))
    return ThinPlaces(whole, samples, ~whole.parallel[samples], at_edge, width[pair[samples]], depth,
                      float(edges.under(WALL_BELOW - _ROUNDING).lengths.sum()))


def is_blunt_edge(angle, distance, depth):
    """Whether a taper is only an edge, broken or not, that is no wall: ndarray of bool, or bool.

    Parameters
    ----------
    angle : ndarray or float, radians
        Between its sides.
    distance : ndarray or float, mm
        How thin it is.
    depth : float, mm
    """
    return (angle >= WALL_BELOW - _ROUNDING) & (distance < depth)


def ends_in_sharp_edge(distance, depth):
    """Whether what is so thick, mm, at a depth beside an edge ends in that edge, under less than `WALL_BELOW`: bool."""
    return distance <= depth * np.tan(WALL_BELOW + _ROUNDING)


def _probed(field, rays, depth):
    """The field with samples where tapered walls may be thinnest, and which of its samples lie `depth` beside an edge.

    The latter is an ndarray of shape (m,), bool.
    """
    corners = corner_samples(field.mesh, likely_thinnest(field.mesh, field.samples, field, field.nonparallel))
    beside = depth_samples(field.mesh, field.sharp_edges, depth)
    whole = _with_samples(field, rays, corners.followed_by(beside))
    return whole, np.arange(len(whole.distance)) >= len(whole.distance) - beside.count


def _counted(field, edges, at_depth, pair, lengths, depth):
    """Which samples lie over a wall, and no nearer than `depth` to a sharp edge: ndarray of shape (m,), bool.

    And how wide tapers are, in their thicknesses: ndarray of shape (p,), inf for those that end in a sharp edge.
    """
    wall = (field.parallel | field.nonparallel) & (field.distance > np.where(at_depth, LEAST_AT_EDGE, LEAST) * depth)
    counted = wall.copy()
    close = np.flatnonzero(wall & ~at_depth & (field.distance < _MOST_STEEP * depth))
    counted[close[edges.are_near(field.samples.points[close], 0.99 * depth)]] = False
    round_off, width = _shapes(field, pair, wall, counted)
    width = np.where(lengths > 0.0, np.inf, width)
    is_broken = (width < SURELY_NARROW) & (np.bincount(pair[wall], minlength=len(width)) >= SEEN_WELL)
    return counted & (at_depth | ~round_off[pair]) & ~is_broken[pair], width


def _first_of_pairs(field, samples, pair, count):
    """Of each pair of faces, the sample over the thinnest wall: ndarray of shape (count,), -1 where it has none."""
    order = samples[np.argsort(-field.distance[samples], kind="stable")]
    first = np.full(count, -1)
    first[pair[order]] = order
    return first


def _thinner(field, one, other):
    """Of two samples for each pair, -1 for none, the one over the thinner wall: ndarray of shape (p,)."""
    is_thinner = (other >= 0) & ((one < 0) | (field.distance[other] < field.distance[one]))
    return np.where(is_thinner, other, one)


def _with_samples(field, rays, samples):
    walls, _ = walls_under(field.mesh, rays, samples)
    return ThicknessField(
        field.mesh, field.samples.followed_by(samples), np.concatenate([field.distance, walls.distance]),
        np.concatenate([field.wedge_angle, walls.wedge_angle]), np.concatenate([field.opposite, walls.opposite]),
        field.entered)


def _between_facets(field, rays, samples):
    """The field with some tapered walls as thick as the facets have them, where these are all that is known of the part.

    How far a smooth surface would lie above long facets is a guess, and a multiple of it on a slanted wall.
    """
    tapered = samples[field.nonparallel[samples]]
    reach, _ = rays.first_hits(field.samples.chosen(tapered), INNER)
    distance = field.distance.copy()
    distance[tapered] = np.where(np.isfinite(reach), reach, distance[tapered])
    return replace(field, distance=distance)


def _pairs(field):
    """Number of the pair of faces that each sample has, in either order, and these pairs: shapes (m,) and (p, 2)."""
    here, there = field.face, field.mesh.face_of_triangle[np.maximum(field.opposite, 0)]
    low, high = np.minimum(here, there), np.maximum(here, there)
    count = int(field.mesh.face_of_triangle.max()) + 1
    keys, number = np.unique(low * count + high, return_inverse=True)
    return number.ravel(), np.stack([keys // count, keys % count], axis=1)


def _shapes(field, pair, wall, counted):
    """Whether pairs of faces round off: ndarray of shape (p,), bool; and how wide tapers are, in thicknesses: shape (p,)."""
    count = int(pair.max(initial=-1)) + 1
    least, steep = np.full(count, np.inf), np.full(count, np.inf)
    np.minimum.at(least, pair[counted], field.distance[counted])
    beyond = (field.opposite >= 0) & (field.wedge_angle >= NONPARALLEL_BELOW) & (field.area > 0.0)
    np.minimum.at(steep, pair[beyond], field.distance[beyond])
    number = np.bincount(pair[wall], minlength=count)
    angle = np.bincount(pair[wall], field.wedge_angle[wall], count) / np.maximum(number, 1)
    # Across the one side and across the other one, the same wall is not as thick.
    side = 2 * pair + (field.face < field.mesh.face_of_triangle[np.maximum(field.opposite, 0)])
    thinnest, thickest = np.full(2 * count, np.inf), np.zeros(2 * count)
    np.minimum.at(thinnest, side[counted], field.distance[counted])
    np.maximum.at(thickest, side[wall], field.distance[wall])
    growth = np.maximum(thickest - thinnest, 0.0).reshape(-1, 2).max(axis=1)
    width = growth / np.tan(np.clip(angle, 1e-9, NONPARALLEL_BELOW))
    is_taper = (angle > PARALLEL_BELOW) & np.isfinite(least)
    return steep < least, np.divide(width, least, out=np.full(count, np.inf), where=is_taper)


def _edge_lengths(mesh, edges, faces):
    """Length of the sharp edges between pairs of faces: ndarray of shape (p,), mm."""
    count = int(mesh.face_of_triangle.max()) + 1
    own = edges.faces(mesh)
    keys = faces[:, 0] * count + faces[:, 1]
    place = np.minimum(np.searchsorted(keys, own[0] * count + own[1]), len(keys) - 1)
    fits = keys[place] == own[0] * count + own[1]
    return np.bincount(place[fits], edges.lengths[fits], len(keys))
