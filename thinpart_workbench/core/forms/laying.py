# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lays one form upon another, and tells where they are the same."""

from itertools import product
from typing import NamedTuple

import numpy as np

from .alignment import fitted, likely_turns, partners
from .motion import Motion

SAME = 2e-3
"""Distance of two surfaces up to which outlines tell them to be one, as a share of the extent: they are points only."""

LAST_LIMIT = 0.006
"""Distance up to which points count at last when two forms are fitted, as a share of the extent."""

SAME_POINTS = 1e-4
"""Greatest distance, as a share of the extent, of outlines that are made of the same points: records round them."""

_TURNS = 6
_FIRST_LIMIT = 0.03
_TRIED_POINTS, _TRIED = 64, 3
_FITTED = 160
_SURELY_LESS = 0.8  # share of the fitted points under which that of all is not the same form's
_MOST_APART = 4.0
_AT_ONCE = 5e-6


class Laid(NamedTuple):
    """A form laid upon another.

    Attributes
    ----------
    motion : Motion
    distance : ndarray of shape (k,), mm
        Of each point of the form from the surface of the other, which it has nothing like near by where that is inf.
    other_distance : ndarray of shape (m,), mm
        The same of each point of the other from the form.
    share, other_share : float
        Shares of the two surfaces that are the same.
    """

    motion: Motion
    distance: np.ndarray
    other_distance: np.ndarray
    share: float
    other_share: float

    @property
    def least_share(self):
        """float: the less of the two shares."""
        return min(self.share, self.other_share)

    def apart(self, most):
        """Mean distance of the points of both, mm, each of which counts as `most` at most."""
        return float(np.concatenate([np.minimum(self.distance, most), np.minimum(self.other_distance, most)]).mean())


def laid_whole(form, other, scale, is_mirrored):
    """The form laid upon another of the same form, in the likeliest ways: list of `Laid`, the best one first.

    Parameters
    ----------
    form, other : Form
    scale : float
    is_mirrored : bool
    """
    return sorted(each_laid(form, other, scale, is_mirrored),
                  key=lambda each: each.apart(_MOST_APART * SAME * other.extent))


def each_laid(form, other, scale, is_mirrored):
    """Yield what `laid_whole` puts into order, in the order of how likely a way is by few points; parameters as there.

    The last is one that lies as near as can be, if there is such a way. Ways after which the points that are fitted show
    that the forms are not the same are left out.
    """
    found = _laid_in_order(form, other, Motion(np.diag([1.0, 1.0, -1.0 if is_mirrored else 1.0]), scale))
    if found is not None:
        yield found
        return
    motions = [Motion(turn, scale) for turn in likely_turns(form, other, scale, is_mirrored, _TURNS, whole=True)]
    # A copy is found much sooner by its own points, in whatever way it is turned: about an axis after fitting only.
    found = next(filter(None, (_laid_on_same_points(form, other, motion) for motion in motions)), None)
    if found is not None:
        yield found
        return
    for motion in motions:
        laid = _laid(form, other, motion, _SURELY_LESS)
        if laid is None:
            continue
        found = _laid_on_same_points(form, other, laid.motion)
        yield found or laid
        if found or laid.apart(_MOST_APART * SAME * other.extent) <= _AT_ONCE * other.extent:
            return


def is_exact(laid, extent):
    """Whether a form lies upon another, of an extent in mm, as exactly as outlines can say: no other way is nearer."""
    return max(laid.distance.max(), laid.other_distance.max()) <= SAME_POINTS * extent


def laid_partly(form, other, least_share):
    """The form laid upon another that is like it in places only: `Laid`, the one in which most is the same.

    Besides centroid on centroid, their ends are laid upon each other along each principal axis. None where no way has a
    share of both surfaces that is the same.
    """
    motions = []
    axes = other.axes
    ends = _ends(other.outline.points @ axes)
    for turn in likely_turns(form, other, 1.0, False, _TURNS, any_axes=True):
        own = _ends(form.outline.points @ turn.T @ axes)
        choices = [sorted({0.0, *(float(there[axis] - here[axis]) for here, there in zip(own, ends))}) for axis in range(3)]
        motions += [Motion(turn, 1.0, axes @ np.array(shift)) for shift in product(*choices)]
    found = [_laid(form, other, motions[number], _SURELY_LESS * least_share) for number in _nearest(form, other, motions)]
    return min((each for each in found if each is not None and each.least_share >= least_share),
               key=lambda each: each.apart(_MOST_APART * SAME * other.extent), default=None)


def _laid_in_order(form, other, motion):
    """The form laid upon one whose outline is made of the same points in the same order: `Laid`, None otherwise.

    So is that of a copy which was turned as a whole; `motion` says the scale and whether it is mirrored.
    """
    points, others = form.outline.points, other.outline.points
    if len(points) != len(others):
        return None
    motion = motion.between(points, others)
    distance = np.linalg.norm(motion.points(points) - others, axis=1)
    if distance.max() > SAME_POINTS * max(motion.scale * form.extent, other.extent):
        return None
    return Laid(motion, distance, distance, 1.0, 1.0)


def _laid_on_same_points(form, other, motion):
    """The form laid upon one whose outline is made of the same points, such as that of a copy: `Laid`, None otherwise."""
    if form.outline.count != other.outline.count:
        return None
    size = max(motion.scale * form.extent, other.extent)
    few = form.outline.chosen(slice(None, None, max(1, form.outline.count // _TRIED_POINTS)))
    if _directed(few, other, motion)[0].max() > SAME * size:
        return None
    away, place = _directed(form.outline, other, motion)
    if away.max() > SAME * size or len(np.unique(place)) < 0.9 * len(place):
        return None
    motion = motion.between(form.outline.points, other.outline.points[place])
    distance = np.linalg.norm(motion.points(form.outline.points) - other.outline.points[place], axis=1)
    if distance.max() > SAME_POINTS * size:
        return None
    other_distance = np.zeros(other.outline.count)
    other_distance[place] = distance
    return Laid(motion, distance, other_distance, 1.0, 1.0)


def _directed(outline, other, motion):
    """Distance and number of the point of another form that is nearest with its normal, of points of an outline."""
    return other.directed_tree.query(np.hstack([
        motion.points(outline.points), other.normal_length * motion.directions(outline.normals)]))


def _nearest(form, other, motions):
    """The numbers of the motions that bring most points of a form near those of another with their normals."""
    step = max(1, form.outline.count // _TRIED_POINTS)
    points, normals = form.outline.points[::step], form.outline.normals[::step]
    turn, shift = np.array([each.turn for each in motions]), np.array([each.shift for each in motions])
    moved = np.einsum("rij,pj->rpi", turn, points) + shift[:, None]
    directed = np.concatenate([moved, other.normal_length * np.einsum("rij,pj->rpi", turn, normals)], axis=2)
    distance = other.directed_tree.query(directed.reshape(-1, 6))[0].reshape(len(motions), -1)
    return np.argsort(np.minimum(distance, other.normal_length).mean(axis=1), kind="stable")[:_TRIED]


def _ends(points):
    return points.min(axis=0), points.max(axis=0)


def _laid(form, other, motion, least_share):
    """A form laid upon another: `Laid`; None where less than a share of the points that are fitted is the same."""
    size = max(motion.scale * form.extent, other.extent)
    few = form.thinned(_FITTED)
    motion = fitted(few, other, motion, (_FIRST_LIMIT * size, LAST_LIMIT * size))
    if least_share and share_of(few, np.abs(partners(few, other, motion)[0]) <= SAME * size) < least_share:
        return None
    distance, _ = partners(form, other, motion)
    other_distance, _ = partners(other, form, motion.inverse())
    distance, other_distance = np.abs(distance), np.abs(other_distance) * motion.scale
    return Laid(motion, distance, other_distance, share_of(form, distance <= SAME * size),
                share_of(other, other_distance <= SAME * size))


def share_of(form, is_same):
    """Share of the surface of a form at chosen points of its outline."""
    return float(form.outline.area[is_same].sum() / form.outline.area.sum())
