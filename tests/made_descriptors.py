# SPDX-License-Identifier: LGPL-2.1-or-later
"""Descriptors with values as wanted, without geometry."""

import numpy as np

from thinpart_workbench.core.descriptors.descriptor_table import STATED_ANGLES, STATED_FLOOR, Descriptors
from thinpart_workbench.core.descriptors.distribution import Distribution
from thinpart_workbench.core.descriptors.local_distribution import local_distribution
from thinpart_workbench.core.descriptors.region_kinds import PLATE, REGION_KINDS
from thinpart_workbench.core.mesh.bounds import OrientedBox

ONE_PLATE = {"thinnest_mm": 0.1, "count": 1, **dict.fromkeys(REGION_KINDS, 0), PLATE: 1, "ridge_ratio": 1.0}

A_BLOCK = {"faces": 6, "shortest_edge_mm": 0.5, "short_edges": 0, "narrowest_face_mm": 0.3,
           "narrow_faces": 0, "knife_edges": 0.0, "tight_share": 0.0, "flattened_share": 0.0, "thin_x": 0.3}
"""Hazards of a part that is easy to mesh."""


def part(box=(1.0, 1.0, 1.0), fill=0.5, walls=(), slanted=(), unmet=0.0, plates=0.5, ratio=1.0):
    """Descriptors as wanted: walls are (x, share), slanted are (x, degrees, share); the local thickness is that of walls.

    The area is 1, or that of the plate ratio that is wanted where there are walls.
    """
    box = np.array(box, dtype=float)
    parallel = sum(share for _, share in walls)
    nonparallel = sum(share for *_, share in slanted)
    shares = Distribution(
        np.array([int(round(x * 1000)) for x, _ in walls], int),
        np.array([share for _, share in walls], float),
        np.array([int(round(x * 1000)) for x, *_ in slanted], int),
        np.array([angle for _, angle, _ in slanted], int),
        np.array([share for *_, share in slanted], float),
        parallel, nonparallel, 1.0 - parallel - nonparallel, unmet,
    )
    volume = None if fill is None else fill * box.prod()
    least = shares.nonparallel_minimum(STATED_FLOOR, *STATED_ANGLES)
    own, area, local = OrientedBox(box, np.eye(3)), 1.0, None
    if walls:
        thickness, share = np.array(walls, float).T
        local = local_distribution(thickness * own.diagonal, share, box[1])
        area = area if volume is None else 2.0 * volume / (ratio * local.quantiles["T50"] * box[1])
    return Descriptors(volume, area, own, shares, least, plates, ONE_PLATE, A_BLOCK, local=local)
