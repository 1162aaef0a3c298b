# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a comparison of two parts found: where their surfaces are the same, and how far they are apart elsewhere."""

from typing import Any, NamedTuple

import numpy as np

from .alignment import LEAST_FITTED, partners
from .form import Form
from .laying import LAST_LIMIT, Laid, share_of

GEOMETRY_SAME = 2e-4
"""Distance of two surfaces up to which their geometry is the same, as a share of the extent: what formats keep is nearer."""

MOST_STEPS = 8
"""Steps of least squares."""

MOST_SEARCHED = 64
"""Points at a time that seem to lie apart for which the whole other geometry is searched, which takes long."""

_WRONGLY_FAR = 0.25
"""Share of these which lie on it after all from which on more are searched: all points that are left over count as apart."""

_ROUNDS = 5
"""How often at most."""

FITTED = 160
"""Points by which two forms are fitted."""

_LIMITS = tuple(LAST_LIMIT / 2 ** halved for halved in range(6))
"""Distances up to which points count, as shares of the extent: faces that are a little aside draw the rest less and less."""

_LIFTED = 0.1
_STILL = 1e-7


class Side(NamedTuple):
    """One of two parts that are compared.

    Attributes
    ----------
    form : Form
    nearest : object
        What finds nearest points of its geometry, in the coordinates of its document; see `NearestOnSolid`.
    """

    form: Form
    nearest: Any

    def placed(self, points):
        """Points in the coordinates of its document: ndarray of shape (k, 3), mm."""
        return points + self.form.moments.centroid

    def centred(self, points):
        """Points from its centroid: ndarray of shape (k, 3), mm."""
        return points - self.form.moments.centroid

    def asked(self):
        """Its form with the points that are looked at, on its geometry itself."""
        outline = self.nearest.quick(self.form.outline)
        found = self.centred(self.nearest.on_faces(self.placed(outline.points), outline.face))
        is_near = np.linalg.norm(found - outline.points, axis=1) <= _LIFTED * outline.spacing
        return Form(self.form.moments, outline._replace(points=np.where(is_near[:, None], found, outline.points)))


class Compared(NamedTuple):
    """Two parts whose geometry was compared.

    Attributes
    ----------
    laid : Laid
    form, other : Form
        With the points of their outlines that were looked at.
    """

    laid: Laid
    form: Form
    other: Form


def compared(side, other, motion):
    """Compare the geometry of two parts at points of their outlines: `Compared`.

    Parameters
    ----------
    side, other : Side
    motion : Motion
        That lays the first form upon the other, nearly.
    """
    same = GEOMETRY_SAME * other.form.extent
    asked, other_asked = side.asked(), other.asked()
    motion = laid_closely(asked, other, motion)
    distance = _distances(asked, other, motion, same)
    other_distance = motion.scale * _distances(other_asked, side, motion.inverse(), same / motion.scale)
    return Compared(Laid(motion, distance, other_distance, share_of(asked, distance <= same),
                         share_of(other_asked, other_distance <= same)), asked, other_asked)


def laid_closely(asked, other, motion, count=FITTED):
    """The `Motion` by which points of a form lie as close to the geometry of another as they can, from one that is near it.

    Parameters
    ----------
    asked : Form
        See `Side.asked`.
    other : Side
    motion : Motion
    count : int, optional
        About so many points are looked at.
    """
    few, extent = asked.thinned(count), other.form.extent
    for limit in _LIMITS:
        for _ in range(MOST_STEPS):
            before = motion
            motion, distance = _nearer(few, other, motion, limit * extent)
            if np.abs(motion.points(few.outline.points) - before.points(few.outline.points)).max() <= _STILL * extent:
                break
        # Where the two are the same, or nowhere, nothing draws the rest aside any more.
        if (np.minimum(distance, limit * extent) <= GEOMETRY_SAME * extent).all():
            break
    return motion


def _nearer(asked, other, motion, limit):
    """The motion after a step, and how far the points were before it, mm."""
    points, feet, partner = _feet(asked, other, motion)
    away = points - feet
    distance = np.linalg.norm(away, axis=1)
    # What only one of the two has must not draw the rest.
    fitting = distance <= limit
    if np.count_nonzero(fitting) < LEAST_FITTED:
        return motion, distance
    normals = other.form.outline.normals[partner[fitting]]
    return motion.nearer(points[fitting], np.einsum("kj,kj->k", away[fitting], normals), normals,
                         asked.outline.area[fitting]), distance


def _distances(asked, other, motion, same):
    points, feet, _ = _feet(asked, other, motion)
    distance = np.linalg.norm(points - feet, axis=1)
    far = np.flatnonzero(distance > same)
    far, greatest = far[np.argsort(-distance[far], kind="stable")], 0.0
    for _ in range(_ROUNDS):
        if not len(far):
            break
        chosen = np.linspace(0, len(far) - 1, min(len(far), MOST_SEARCHED)).astype(np.int64)
        chosen = np.union1d(chosen, np.arange(min(len(far), MOST_SEARCHED // 4)))  # the farthest say how far it is
        some, far = far[chosen], np.delete(far, chosen)
        nearest = other.centred(other.nearest.anywhere(other.placed(points[some])))
        distance[some] = np.linalg.norm(points[some] - nearest, axis=1)
        greatest = max(greatest, distance[some].max())
        if (distance[some] <= same).mean() < _WRONGLY_FAR and not (distance[far] > greatest).any():
            break  # the rest is no farther
    return distance


def _feet(asked, other, motion):
    """Moved points, the points of the other geometry that are near them, and the points of its outline nearest in kind."""
    across, partner = partners(asked, other.form, motion)
    points, reached = motion.points(asked.outline.points), np.isfinite(across)
    likest = other.form.outline.points[partner]
    # What the outlines say is taken where the geometry has no answer, or a worse one than a point that is known.
    mean = motion.directions(asked.outline.normals) + other.form.outline.normals[partner]
    length = np.maximum(np.linalg.norm(mean, axis=1), np.finfo(float).tiny)
    feet = np.where(reached[:, None], points - np.where(reached, across / length, 0.0)[:, None] * mean, likest)
    found = other.centred(other.nearest.on_faces(other.placed(points), other.form.outline.face[partner]))
    is_nearer = reached & (np.linalg.norm(points - found, axis=1) < np.linalg.norm(points - likest, axis=1))
    feet[is_nearer] = found[is_nearer]
    return points, feet, partner
