# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lower the priority of processes in favour of the window."""

import os
import sys

from . import windows


def lower_priority(process):
    """Lower the priority of a process, by its id, so that others go first if there are few processors.

    Raises OSError if the process has ended.
    """
    if sys.platform == "win32":
        windows.lower_priority(process)
    else:
        os.setpriority(os.PRIO_PROCESS, process, 10)
