# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker does in the test of the pool on a simulated Windows: modules that workers import are files."""

import os
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import simulated_system as simulated


def start(parent):
    """The limits of a worker, on Windows."""
    if sys.platform != "win32":
        simulated.use("win32")
    from thinpart_workbench.system.parent_death import end_with_parent
    from thinpart_workbench.system.process_limits import crash_quietly, limit_memory

    simulated.KERNEL.processes.add(parent)
    end_with_parent(parent)
    limit_memory(700 << 20)
    crash_quietly()


def do(task):
    """Begin, and end as the task says."""
    if task.file == "die":
        os._exit(3)
    if task.file == "sleep":
        time.sleep(60)
    return task.file
