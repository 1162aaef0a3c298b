"""Lower the priority of processes in favour of the window."""

import os
import sys

from . import windows


def lower_priority(process):
    """Lower the priority of a process, so that others go first if there are few processors.

    Parameters
    ----------
    process : int
        Process id.

    Raises
    ------
    OSError
        If the process has ended.
    """
    if sys.platform == "win32":
        windows.lower_priority(process)
    else:
        os.setpriority(os.PRIO_PROCESS, process, 10)
