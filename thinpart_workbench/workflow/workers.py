"""The worker processes of a run: tasks go in a few at a time, what ended comes out."""

import importlib.util
import os
import sys
from concurrent.futures import Future
from queue import Empty, SimpleQueue

from ..core.errors import ThinPartError
from ..system.python_process import is_freecadcmd
from .process_pool import ProcessPool, WorkerDied

_TASKS_PER_WORKER = 4
"""At work and waiting: enough that none is idle while the parent prints."""

_TICK = 0.1
"""Seconds after which whoever waits may look what else there is to do."""

_MOST_BREAKS = 5
"""Times that the pool may break down in a row before anything has ended."""


class Workers:
    """A pool of processes that each take one task after the other.

    Parameters
    ----------
    count : int
    seconds : float
        What one task may take, from when a worker has taken it.
    folder : str
        For the logs of the workers.
    work : callable
        ``work(task, log, hold)`` runs in a worker. It returns None at once when there is a file
        `hold`: the task waited in the pool while the run was paused. Else it first makes the file
        `log`.
    start : callable
        Runs in each new worker.
    start_arguments : tuple
    pool_class : type, optional
        `ProcessPool` or `PebblePool`; see `chosen_pool`.
    """

    def __init__(self, count, seconds, folder, work, start, start_arguments, pool_class=None):
        self._count = count
        self._seconds = seconds
        self._folder = folder
        self._work = work
        self._start = start, start_arguments
        self._pool_class = pool_class or chosen_pool()
        self._hold = os.path.join(folder, "hold")
        self._pool = None
        self._ended = SimpleQueue()
        self._handed = {}
        self._number = 0
        self._breaks = 0
        self._charged = set()

    @property
    def busy(self):
        """Whether any task is in the pool."""
        return bool(self._handed)

    @property
    def has_room(self):
        """Whether another task may be handed over."""
        return len(self._handed) < _TASKS_PER_WORKER * self._count and not self._is_broken()

    def hold(self, held):
        """Have workers begin nothing more, or go on."""
        if held != os.path.exists(self._hold):
            if held:
                open(self._hold, "wb").close()
            else:
                os.unlink(self._hold)

    def begin(self, task):
        """Hand over a task."""
        log = os.path.join(self._folder, f"{self._number}.log")
        self._number += 1
        if self._pool is None:
            self._pool = self._pool_class(self._count, *self._start)
        try:
            future = self._pool.schedule(self._work, (task, log, self._hold), self._seconds)
        except RuntimeError:
            future = Future()  # the pool has just broken down; this one is lost with it
        self._handed[future] = task, log
        future.add_done_callback(self._ended.put)

    def next_ended(self):
        """A task that has ended, as (future, task, log); None when none did for a moment."""
        try:
            future = self._ended.get(timeout=_TICK)
        except Empty:
            return None
        if future not in self._handed:
            return None  # of a pool that broke down
        self._breaks = 0
        return future, *self._handed.pop(future)

    def lost_tasks(self):
        """Tasks that were in a pool which broke down; there is a new pool for them.

        Raises
        ------
        ThinPartError
            When every pool breaks down.

        Notes
        -----
        Of what a pool breaks down depends on the library that it comes from: see `pebble_pool`.
        A task that was begun twice when that happened is taken for the reason, and ends as one that
        killed its worker.
        """
        if not self._is_broken():
            return []
        if not any(os.path.exists(log) for _, log in self._handed.values()):
            self._breaks += 1
        if self._breaks > _MOST_BREAKS:
            raise ThinPartError(
                "The worker processes end as soon as they start: try a larger --memory, or fewer "
                "--jobs.", "crash",
            )
        self.stop()
        lost = []
        for future, (task, log) in list(self._handed.items()):
            if future.done():
                continue
            del self._handed[future]
            if not os.path.exists(log):
                lost.append(task)
            elif task.file not in self._charged:
                self._charged.add(task.file)
                lost.append(task)
            else:
                self._ended_by_death(task, log)
        return lost

    def stop(self):
        """End all workers, whatever they are at."""
        if self._pool is not None:
            pool, self._pool = self._pool, None
            pool.stop()

    def _is_broken(self):
        return self._pool is not None and not self._pool.active

    def _ended_by_death(self, task, log):
        future = Future()
        self._handed[future] = task, log
        future.add_done_callback(self._ended.put)
        future.set_exception(WorkerDied("the pool broke down"))


def chosen_pool():
    """Class of the pool to take: pebble's where there is one, else our own.

    pebble starts processes by multiprocessing, for which this process has to run in a Python.
    """
    if is_freecadcmd(sys.executable) or importlib.util.find_spec("pebble") is None:
        return ProcessPool
    from .pebble_pool import PebblePool

    return PebblePool
