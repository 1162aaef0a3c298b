# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of an analysis: one set of defaults for the command line, the window and programs."""

from dataclasses import dataclass

LEAST_MEGABYTES = 700
"""Memory that FreeCAD and numpy need before reading a file."""


@dataclass(frozen=True)
class Limits:
    """Limits for the analysis of one file.

    Attributes
    ----------
    seconds : float
    megabytes : int
        Address space of a worker; not enforced where `MEMORY_CAN_BE_LIMITED` is false.
    jobs : int
        Number of workers.
    """

    seconds: float = 600.0
    megabytes: int = 6144
    jobs: int = 1
