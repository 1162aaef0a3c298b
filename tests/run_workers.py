# SPDX-License-Identifier: LGPL-2.1-or-later
"""Workers as every run that reads files has them, but for what they do: limited and started like those."""

from contextlib import contextmanager
from unittest import mock

from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.workflow.workers import task_run
from thinpart_workbench.workflow.workers.process_pool import ProcessPool
from thinpart_workbench.workflow.workers.worker_pool import file_analyser


@contextmanager
def run_workers(do, folder, seconds, confine=True):
    """For a ``with`` block: one worker with the limits of a run.

    Parameters
    ----------
    do : callable
        ``do(task)`` runs in the worker.
    folder : Path
        For what it prints and writes.
    seconds : float
        What one task may take.
    confine : bool

    Yields
    ------
    ProcessPool
    """
    made = []

    def workers(count, _seconds, _folder, _work, *start, **_options):
        made.append(ProcessPool(count, seconds, str(folder), do, *start, confine=confine))
        return made[0]

    with mock.patch.object(task_run, "ProcessPool", workers), file_analyser(Limits()):
        yield made[0]
