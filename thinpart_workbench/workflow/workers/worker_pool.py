# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse files in worker processes, so that a file which kills its reader is one failed row."""

from contextlib import contextmanager
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.run_control import RunControl
from ..analysis.analysis_outcome import checked_outcome
from ..analysis.result_files import write_results
from .reading import analysed
from .task_run import run_tasks, task_workers


def analyse_files(tasks, limits, control=None):
    """Analyse files, each in a worker process with time and memory limits.

    Yields a dict: per file, as they finish: the outcome of `analyse_file`, after its files were written, and ``confinement``
    (see `confinement.confine`); or ``{"file", "error": {"kind", "message"}}``, with ``seconds`` if they are known. Raises
    ThinPartError, Cancelled: as `run_tasks`.

    Parameters
    ----------
    tasks : list of FileTask
    limits : Limits
    control : RunControl, optional
        Pauses and stops the run.
    """
    control = control or RunControl()
    yield from _written(run_tasks(tasks, analysed, _storable, limits, control=control), control)


@contextmanager
def file_analyser(limits):
    """For a ``with`` block: a function that analyses one file after the other.

    Yields a callable: ``analyse(task, control)``, which returns an outcome as from `analyse_files`.

    Parameters
    ----------
    limits : Limits
        `jobs` is ignored: there is one worker process.
    """
    with task_workers(1, analysed, _storable, limits) as run:
        def analyse(task, control):
            outcome, = _written(run([task], control), control)
            return outcome

        yield analyse


def _storable(task, answer):
    try:
        return checked_outcome(task, answer)
    except ValueError as fault:
        raise ThinPartError(message("{file} failed: its result cannot be stored ({problem}).", file=Path(task.file).name,
                                    problem=str(fault)), "failed") from None


def _written(finished, control):
    """Yield the outcome of each task after writing its files."""
    for done in finished:
        control.check()
        yield write_results(done.task, {**(done.failure or done.result), "confinement": done.confinement})
