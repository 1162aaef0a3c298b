# SPDX-License-Identifier: LGPL-2.1-or-later
"""The check of walls on what the index of a library stores of a part."""

import json
import struct

from .wall_check import MeasuredWalls, judged_walls
from .wall_limits import WallLimits


def packed_walls_pass(thinnest, error, volume, area, diagonal, unmeasured, unmet, wall_bins, wall_area, slanted_bins,
                      slanted_area, limited, ball, middle, least, most):
    """Whether the walls of a part lie within limits, and faces with limits of their own within these: see `judged_walls`.

    Returns an int or None: 1 or 0; None where it cannot be told.

    Parameters
    ----------
    thinnest, error, volume, area, diagonal, unmeasured, unmet : float or None
        As in `MeasuredWalls`.
    wall_bins, wall_area, slanted_bins, slanted_area : bytes
        See `packed_walls`.
    limited : str or None
        JSON of `limited_part`.
    ball : float or None
        ``T99`` of a part record, a share of the middle side of its box.
    middle : float, mm
        That side.
    least, most : float or None, mm
    """
    walls, slanted = (_unpacked(*table) for table in ((wall_bins, wall_area), (slanted_bins, slanted_area)))
    measured = MeasuredWalls(thinnest, error, volume, area, diagonal, walls, slanted, unmeasured, unmet,
                             ball and ball * middle)
    holds = judged_walls({} if limited is None else json.loads(limited), measured, WallLimits("", "", least, most)).holds
    return holds if holds is None else int(holds)


def _unpacked(bins, area):
    return struct.unpack(f"<{len(bins) // 2}H", bins), struct.unpack(f"<{len(area) // 4}f", area)
