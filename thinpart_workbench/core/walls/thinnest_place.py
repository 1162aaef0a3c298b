# SPDX-License-Identifier: LGPL-2.1-or-later
"""The one place where a part is thinnest, whatever the angle of its walls."""

from dataclasses import dataclass, replace
from typing import NamedTuple, Optional

import numpy as np
from scipy.sparse.csgraph import connected_components

from ..descriptors.wall_kinds import EDGE, PARALLEL, TAPERED
from ..number_text import rounded_up
from ..tolerances import TOLERANCES
from .face_thickness import NEARLY, Witness, witness_of
from .near_faces import neighbours
from .near_walls import EQUALLY_THIN, NearWalls, near_walls
from .thin_places import LEAST, MAY_BE_THINNER, ends_in_sharp_edge

MOST_TRIED = 12
"""Places that are looked for in the part's own geometry, from the thinnest on."""

_MOST_IN_VAIN = 5
"""Such places, one after the other, none of which is much thinner than what is known: then the others are not either."""

_MOST_EQUAL = 24
"""Tapers equal to a thin one, such as the teeth of a gear, that are looked for in the part's own geometry too."""

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


def thinnest_place(parallel, places, confirmed=None, equal_faces=None, near=None):
    """Find where a part is thinnest: ThinnestPlace or None, and the places without those that it does not have: ThinPlaces.

    Parameters
    ----------
    parallel : Witness or None
        The thinnest wall between parallel sides.
    places : ThinPlaces
    confirmed : callable, optional
        Called with a `Witness`, its kind, the size, mm, of the facets there, its width in thicknesses, and the thickness,
        mm, under which it would be the thinnest; the kind is None for two faces that are only known to be near each other.
        Returns the wall as the geometry of the part has it, None where there is none, and its kind. Without it, what
        `ThinPlaces.is_narrow` has for a chamfer is none.
    equal_faces : ndarray of shape (f,), int64, optional
        For each face, the first one equal to it.
    near : callable, optional
        As of `near_walls`: what yields pairs of faces that are near each other, whether samples met them or not. Those that
        are walls are found by `confirmed`.
    """
    best, kind, apart = parallel, PARALLEL, parallel
    exact, kinds = [], _kinds_of_pairs(places, equal_faces)
    seen = _near_walls(parallel, places, confirmed, equal_faces, near)
    for wall, own in seen.walls:
        exact.append((wall, own))
        best, kind, apart = wall, own, wall
    no_walls: dict = {}  # how thick those are, by their kind
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
        if near is not None and least is not None and found.distance >= least.distance and seen.has_seen(found):
            continue
        # Such as the chamfers of equal holes.
        if seen.is_no_wall(found) or found.distance <= EQUALLY_THIN * no_walls.get(kinds[number], 0.0):
            kept[number] = False
            continue
        tried[own_turn] += 1
        in_vain[own_turn] += 1
        wall, own = (found, own) if confirmed is None else confirmed(
            found, own, _facet_size(places.field, places.samples[number]), places.width[number],
            np.inf if least is None else least.distance)
        at_edge[number] = own == EDGE
        if confirmed is not None:
            width[number] = np.inf
        kept[number] = wall is not None and (own == EDGE or wall.distance > LEAST * places.depth)
        if not kept[number]:
            no_walls[kinds[number]] = found.distance
            continue
        if confirmed is not None:
            exact.append((wall, own))
        known = best if own == EDGE else apart
        if known is None or wall.distance < (1.0 - NEARLY) * known.distance:
            in_vain[own_turn] = 0
        if own != EDGE and (apart is None or wall.distance < apart.distance):
            apart = wall
        if best is None or wall.distance < best.distance:
            best, kind = wall, own
    if exact and equal_faces is not None:
        thin = [wall for wall, own in exact if own == TAPERED and wall.distance < TOLERANCES.alike * best.distance]
        exact += _equal_to(thin, places, equal_faces, confirmed) if thin else []
    places = replace(places, is_at_edge=at_edge, width=width, exact=tuple(wall for wall, _ in exact))
    if best is None:
        return None, places
    left = places.chosen(kept & (places.is_narrow | (places.distance >= best.distance * (1.0 - NEARLY))))
    below = rounded_up(TOLERANCES.alike * best.distance)
    thin = [wall for wall, _ in exact if wall.distance < below]
    count = max(1, _count(left.chosen(~left.is_narrow), thin, below, equal_faces))
    return ThinnestPlace(best, kind, places.depth, places.edges_mm, apart, below, count), left


def _near_walls(parallel, places, confirmed, equal_faces, near):
    """Walls between faces near each other that are thinner than the thinnest parallel one: NearWalls."""
    if near is None or places.field is None or parallel is None and not len(places.samples):
        return NearWalls()
    thinnest = float(places.distance[0]) if parallel is None else parallel.distance
    return near_walls(near, confirmed, thinnest, set(zip(*neighbours(places.field.mesh).tolist())), equal_faces)


def _facet_size(field, sample):
    """Square root of twice the area, mm, of the facet under a sample."""
    return float(np.sqrt(2.0 * field.mesh.areas[field.samples.triangle[sample]]))


def _kind(places, number):
    if places.is_at_edge[number] and ends_in_sharp_edge(places.distance[number], places.depth):
        return EDGE
    return TAPERED if places.is_tapered[number] else PARALLEL


def _kinds_of_pairs(places, equal_faces):
    """What the faces of each place are equal to and whether it is tapered; its number where that is not known: list."""
    if equal_faces is None or not len(places.samples):
        return list(range(len(places.samples)))
    faces = np.sort(equal_faces[_face_pairs(places.field, places.samples)], axis=1)
    return list(map(tuple, np.column_stack([faces, places.is_tapered]).tolist()))


def _equal_to(tapers, places, equal_faces, confirmed):
    """Walls that are equal to some thin tapers by their faces, as the geometry has them: list of (Witness, kind)."""
    known = np.sort([[wall.face, wall.opposite_face] for wall in tapers], axis=1)
    least = min(wall.distance for wall in tapers)
    samples, pairs = _of_equal_faces(places.field, known, least, equal_faces)
    is_new = ~(pairs[:, None] == known).all(axis=2).any(axis=1)
    samples, pairs = samples[is_new], pairs[is_new]
    order = np.argsort(places.field.distance[samples], kind="stable")
    _, first = np.unique(pairs[order], axis=0, return_index=True)
    found = (confirmed(witness_of(places.field, int(sample)), TAPERED, _facet_size(places.field, sample), np.inf, least)
             for sample in samples[order[np.sort(first)]][:_MOST_EQUAL])
    return [(wall, own) for wall, own in found if wall is not None and own == TAPERED]


def _of_equal_faces(field, pairs, least, equal_faces):
    """Samples over walls that may be as thin as the thinnest between some pairs of faces, on faces equal to these.

    Samples meet equal tapers, such as the teeth of a gear, at other distances from where they are thinnest. The sides of
    equal teeth may be of two kinds, of which any two meet. Returns the samples and their pairs of faces, shapes (k,) and
    (k, 2).
    """
    samples = np.flatnonzero((field.parallel | field.nonparallel) & (field.distance < MAY_BE_THINNER * least))
    found = _face_pairs(field, samples)
    equal = np.isin(equal_faces[found], np.unique(equal_faces[pairs])).all(axis=1)
    return samples[equal], found[equal]


def _count(places, exact, below, equal_faces):
    """How many places are thinner than a length: walls between faces that go over into each other are one.

    They are those of samples, and walls that the geometry has, a list of Witness.
    """
    thin = places.chosen(places.distance < below)
    pairs = np.sort(np.array([[wall.face, wall.opposite_face] for wall in exact], dtype=np.int64).reshape(-1, 2), axis=1)
    if len(thin.samples):
        pairs = np.concatenate([pairs, _face_pairs(thin.field, thin.samples)])
    if not len(pairs):
        return 0
    if equal_faces is not None and thin.is_tapered.any():
        least = float(thin.distance[thin.is_tapered].min())
        tapers = _face_pairs(thin.field, thin.samples[thin.is_tapered])
        pairs = np.concatenate([pairs, _of_equal_faces(thin.field, tapers, least, equal_faces)[1]])
    pairs = np.unique(pairs, axis=0)[:_MOST_COUNTED]
    mesh = places.field.mesh
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
