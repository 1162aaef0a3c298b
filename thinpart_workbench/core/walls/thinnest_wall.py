# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a part is thinnest: a wall of some extent, not a stray ray."""

import numpy as np

from ..descriptors.descriptor_table import STATED_FLOOR
from ..tolerances import TOLERANCES

_ROUNDING = 1e-9
"""Of the logarithm of a thickness: walls of 4 and of 5 mm are just alike."""

def thinnest_walls(field):
    """Samples over the thinnest walls, the thinnest first.

    Returns an ndarray of shape (k,), int64: at most one for each pair of faces that enclose a wall, and one for the whole
    surface. Empty where no parallel walls cover `STATED_FLOOR` of the surface.

    The least distance of all rays is noise on real parts: beside an edge, in a run-out of a fillet, on a sliver. A wall has
    an extent. Of each pair of faces, and of all together since a wall may have many small faces, the sample counts from
    which on walls that are no more than a quarter thicker cover the floor.
    """
    parallel = np.flatnonzero(field.parallel & (field.distance > _touching_below(field)))
    floor = STATED_FLOOR * field.area.sum()
    faces = field.mesh.face_of_triangle
    pair = faces[field.samples.triangle[parallel]] * (int(faces.max()) + 1) + faces[field.opposite[parallel]]
    _, group = np.unique(pair, return_inverse=True)
    found = [first_of_extent(field, parallel, which, floor) for which in (np.zeros_like(group), group)]
    samples = np.unique(np.concatenate(found))
    samples = samples[samples >= 0]
    return samples[np.argsort(field.distance[samples], kind="stable")]


def first_of_extent(field, samples, group, floor):
    """Of each group of samples, the one over the thinnest wall that covers an area: ndarray of shape (k,), int64.

    -1 for a group that has none.

    Parameters
    ----------
    field : ThicknessField
    samples : ndarray of shape (m,), int64
    group : ndarray of shape (m,), int64
        From 0 on.
    floor : float or ndarray of shape (k,), mm2
        Area that walls up to `TOLERANCES.alike` times as thick have to cover, of all or of each group.
    """
    count = len(floor) if np.ndim(floor) else int(group.max(initial=-1)) + 1
    first = np.full(count, -1)
    if not len(samples):
        return first
    order = np.lexsort([field.distance[samples], group])
    samples, group = samples[order], group[order]
    covered = np.concatenate([[0.0], np.cumsum(_even_area(field, samples))])
    # One search for all groups: of a group, all logarithms are beyond those of the group before.
    thickness = np.log(np.maximum(field.distance[samples], np.finfo(float).tiny))
    alike = np.log(TOLERANCES.alike) + _ROUNDING
    place = thickness - thickness.min() + group * (np.ptp(thickness) + 2.0 * alike)
    last = np.searchsorted(place, place + alike, side="right")
    enough = np.flatnonzero(covered[last] - covered[:-1] >= np.broadcast_to(floor, count)[group])
    # The first of each group is written last.
    first[group[enough[::-1]]] = samples[enough[::-1]]
    return first


def _even_area(field, samples):
    """Area, mm2, that samples represent and over which their walls change by `alike` at most: ndarray of shape (m,).

    On a taper that is only a strip of what a sample represents, and beside its edge a narrow one.
    """
    area, slope = field.area[samples], np.tan(field.wedge_angle[samples])
    strip = (TOLERANCES.alike - 1.0) * field.distance[samples] / np.maximum(slope, np.finfo(float).eps)
    return np.minimum(area, np.sqrt(area) * strip)


def touching_sample(field):
    """Number of a sample where surfaces touch or cross over some area; None where they do not."""
    near = np.flatnonzero(field.parallel & (field.distance <= _touching_below(field)))
    if field.area[near].sum() < STATED_FLOOR * field.area.sum():
        return None
    return int(near[np.argmax(field.area[near])])


def _touching_below(field):
    """Distance, mm, up to which surfaces touch rather than enclose a wall."""
    walls = np.flatnonzero(field.parallel)
    if not len(walls):
        return 0.0
    order = walls[np.argsort(field.distance[walls], kind="stable")]
    covered = np.cumsum(field.area[order])
    return TOLERANCES.touching * float(field.distance[order[np.searchsorted(covered, 0.5 * covered[-1])]])
