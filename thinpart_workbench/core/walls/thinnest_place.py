# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place where a part is thinnest, whatever the angle of its walls."""

from dataclasses import dataclass, replace
from typing import NamedTuple, Optional

import numpy as np
from scipy.sparse.csgraph import connected_components

from ..descriptors.wall_kinds import EDGE, PARALLEL, TAPERED
from ..number_text import rounded_up
from ..tolerances import TOLERANCES
from .face_thickness import NEARLY, Witness
from .thin_places import LEAST, MAY_BE_THINNER, ends_in_sharp_edge

MOST_TRIED = 12
"""Places that are looked for in the part's own geometry, from the thinnest on."""

_MOST_IN_VAIN = 5
"""Such places, one after the other, none of which is much thinner than what is known: then the others are not either."""

_MOST_COUNTED = 1000
"""Pairs of faces that are told apart as places."""


@dataclass(frozen=True)
class ThinnestPlace:
    """Where a part is thinnest.

    Attributes
    ----------
    witness : Witness
    kind : str
        One of `WALL_KINDS`: between parallel sides, in a taper, or `depth` beside a sharp edge.
    depth : float, mm
        Depth beside sharp edges at which they are told.
    edges_mm : float, mm
        Length of all sharp edges.
    wall : Witness or None
        The thinnest apart from sharp edges.
    below_mm : float, mm
        A round length, about a quarter more than the thinnest.
    places : int
        Places thinner than that.
    """

    witness: Witness
    kind: str
    depth: float
    edges_mm: float
    wall: Optional[Witness]
    below_mm: float
    places: int


class WallErrors(NamedTuple):
    """How far thicknesses may be off.

    Attributes
    ----------
    parallel, thinnest, walls : float, mm
        Of the thinnest parallel wall, of the thinnest place, and of the thinnest wall apart from sharp edges.
    """

    parallel: float
    thinnest: float
    walls: float


def thinnest_place(parallel, places, confirmed=None, equal_faces=None):
    """Find where a part is thinnest: ThinnestPlace or None, and the places without those that it does not have: ThinPlaces.

    Parameters
    ----------
    parallel : Witness or None
        The thinnest wall between parallel sides.
    places : ThinPlaces
    confirmed : callable, optional
        Called with a `Witness`, its kind, its number among the places and the thickness, mm, under which it would be the
        thinnest; returns the wall as the geometry of the part has it, None where there is none, and its kind. Without it,
        what `ThinPlaces.is_narrow` has for a chamfer is none.
    equal_faces : ndarray of shape (f,), int64, optional
        For each face, the first one equal to it.
    """
    best, kind, apart = parallel, PARALLEL, parallel
    kept, at_edge, width = np.ones(len(places.samples), dtype=bool), places.is_at_edge.copy(), places.width.copy()
    turn = np.where(places.is_at_edge, 2, places.is_narrow)
    tried, in_vain = np.zeros(3, dtype=int), np.zeros(3, dtype=int)
    for number in np.argsort(turn, kind="stable"):
        found, own, own_turn = places.witness(number), _kind(places, number), turn[number]
        least = best if places.is_at_edge[number] else apart
        if tried[own_turn] == MOST_TRIED or in_vain[own_turn] == _MOST_IN_VAIN or (
                least is not None and places.may_be[number] >= least.distance):
            continue
        if confirmed is None and places.is_narrow[number]:
            continue
        tried[own_turn] += 1
        in_vain[own_turn] += 1
        wall, own = (found, own) if confirmed is None else confirmed(
            found, own, number, np.inf if least is None else least.distance)
        at_edge[number] = own == EDGE
        if confirmed is not None:
            width[number] = np.inf
        kept[number] = wall is not None and (own == EDGE or wall.distance > LEAST * places.depth)
        if not kept[number]:
            continue
        known = best if own == EDGE else apart
        if known is None or wall.distance < (1.0 - NEARLY) * known.distance:
            in_vain[own_turn] = 0
        if own != EDGE and (apart is None or wall.distance < apart.distance):
            apart = wall
        if best is None or wall.distance < best.distance:
            best, kind = wall, own
    places = replace(places, is_at_edge=at_edge, width=width)
    if best is None:
        return None, places
    left = places.chosen(kept & (places.is_narrow | (places.distance >= best.distance * (1.0 - NEARLY))))
    below = rounded_up(TOLERANCES.alike * best.distance)
    count = max(1, _count(left.chosen(~left.is_narrow), below, equal_faces))
    return ThinnestPlace(best, kind, places.depth, places.edges_mm, apart, below, count), left


def _kind(places, number):
    if places.is_at_edge[number] and ends_in_sharp_edge(places.distance[number], places.depth):
        return EDGE
    return TAPERED if places.is_tapered[number] else PARALLEL


def _count(places, below, equal_faces):
    """How many places are thinner than a length: walls between faces that go over into each other are one."""
    thin = places.chosen(places.distance < below)
    if not len(thin.samples):
        return 0
    pairs = _face_pairs(thin.field, thin.samples)
    if equal_faces is not None:
        pairs = np.concatenate([pairs, _equal_tapers(thin, pairs, equal_faces)])
    pairs = np.unique(pairs, axis=0)[:_MOST_COUNTED]
    mesh = thin.field.mesh
    faces, own = np.unique(pairs, return_inverse=True)
    here, there = own.reshape(pairs.shape).T
    touching = np.eye(len(faces), dtype=bool)
    sides = mesh.face_of_triangle[np.stack(mesh.shared_sides) // 3]
    sides = sides[:, sides[0] != sides[1]]
    place = np.minimum(np.searchsorted(faces, sides), len(faces) - 1)
    first, second = place[:, (faces[place] == sides).all(axis=0)]
    touching[first, second] = touching[second, first] = True
    straight = touching[np.ix_(here, here)] & touching[np.ix_(there, there)]
    crosswise = touching[np.ix_(here, there)] & touching[np.ix_(there, here)]
    count, _ = connected_components(straight | crosswise, directed=False)
    return int(count)


def _face_pairs(field, samples):
    """The two faces of the wall under each of some samples, the lower number first: ndarray of shape (k, 2)."""
    there = field.mesh.face_of_triangle[field.opposite[samples]]
    return np.sort(np.column_stack([field.face[samples], there]), axis=1)


def _equal_tapers(thin, pairs, equal_faces):
    """Pairs of faces that are equal to those of thin tapers, and have a wall that may be as thin: ndarray of shape (k, 2).

    Equal tapers, such as the teeth of a gear, are met by samples at other distances from where they are thinnest.
    """
    field = thin.field
    kinds, own = np.unique(np.sort(equal_faces[pairs[thin.is_tapered]], axis=1), axis=0, return_inverse=True)
    least = np.full(len(kinds), np.inf)
    np.minimum.at(least, own.ravel(), thin.distance[thin.is_tapered])
    found = [np.zeros((0, 2), dtype=pairs.dtype)]
    is_thin = field.distance < MAY_BE_THINNER * least.max(initial=0.0)
    samples = np.flatnonzero((field.parallel | field.nonparallel) & is_thin)
    others = _face_pairs(field, samples)
    of_others = np.sort(equal_faces[others], axis=1)
    for kind, thinnest in zip(kinds, least):
        is_equal = (of_others == kind).all(axis=1) & (field.distance[samples] < MAY_BE_THINNER * thinnest)
        found.append(np.unique(others[is_equal], axis=0))
    return np.concatenate(found)
