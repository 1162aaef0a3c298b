# SPDX-License-Identifier: LGPL-2.1-or-later
"""What becomes of tasks that are handed to workers."""

from collections import deque

from thinpart_workbench.core.run_control import RunControl
from thinpart_workbench.workflow.analysis.analyse_file import FileTask


def results(workers, tasks):
    """(task, result, or what was raised there, or the name of what became of it) in the order in which they end."""
    ended = []
    for future, task in workers.run(deque(map(FileTask, tasks)), RunControl()):
        error = future.exception()
        ended.append((task.file, future.result() if error is None else str(error) or type(error).__name__))
    return ended
