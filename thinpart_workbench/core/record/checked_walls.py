# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which walls of a record are compared with the limits of a process."""


def walls_of(record):
    """The thinnest wall of a part record apart from sharp edges, and how far it may be off: float or None, and float, mm."""
    place, wall = record.get("thinnest"), record["descriptors"]["thickness_mm"]
    if place is None:  # nothing was measured, or by an earlier version, which knew parallel walls only
        return wall["min"], wall["error_bound"]
    return place["walls_mm"], place["walls_error_mm"]
