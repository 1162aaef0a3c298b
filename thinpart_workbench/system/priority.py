"""Processes that step back behind the window."""

import os
import sys

from . import windows


def step_back(process):
    """Let others go first where there are few processors.

    Parameters
    ----------
    process : int
        Number of a process.

    Raises
    ------
    OSError
        Where it has ended.
    """
    if sys.platform == "win32":
        windows.lower_priority(process)
    else:
        os.setpriority(os.PRIO_PROCESS, process, 10)
