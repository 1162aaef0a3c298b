"""Runs tasks in worker processes: submits a few at a time and returns them as they finish."""

import time
from concurrent.futures import Future
from queue import Empty, SimpleQueue

from ...core.errors import ThinPartError
from ...core.message import message
from .process_pool import ProcessPool

_TASKS_PER_WORKER = 4
"""Running and queued tasks: enough that no worker is idle while the parent prints."""

_TICK = 0.1
"""Seconds after which `next_finished` returns without a task, so that the caller can do other work."""

_MEANWHILE = 0.05
"""Longest time without looking for finished tasks, in which other work may start, in seconds."""

_MAX_POOL_FAILURES = 5
"""Pools in a row in which no worker could start, after which the run fails."""


class PoolSupervisor:
    """A pool of worker processes that each process one task after the other.

    Parameters
    ----------
    count : int
    seconds : float
        Time limit of a task, from when a worker has received it.
    folder : str
        Folder for the output and the files of workers.
    work : callable
        ``work(task)`` runs in a worker; its result must be JSON values.
    start : callable
        Runs in each new worker.
    start_arguments : tuple
    confine, with_programs : bool
        See `ProcessPool`.
    """

    def __init__(self, count, seconds, folder, work, start, start_arguments=(), confine=False, with_programs=False):
        self._count = count
        self._seconds = seconds
        self._work = work
        self._pool_arguments = count, folder, start, start_arguments, confine, with_programs
        self._pool = None
        self._paused = False
        self._finished: SimpleQueue[Future] = SimpleQueue()
        self._submitted = {}
        self._pool_failures = 0

    @property
    def busy(self):
        """Whether any task is running or queued."""
        return bool(self._submitted)

    @property
    def has_room(self):
        """Whether another task can be submitted."""
        return len(self._submitted) < _TASKS_PER_WORKER * self._count and not self._is_broken()

    @property
    def confinement(self):
        """dict or None: see `confinement.confine`; None before the first worker was needed."""
        return None if self._pool is None else self._pool.confinement

    def set_paused(self, paused):
        """Pause: workers start no further task. Or resume."""
        self._paused = paused
        if self._pool is not None:
            self._pool.set_paused(paused)

    def run(self, pending, control, may_start=lambda task: True, meanwhile=()):
        """Run tasks until none are left.

        Parameters
        ----------
        pending : deque
            Tasks in the order in which they are started. More may be added during the run.
        control : RunControl
            Pauses and stops the run.
        may_start : callable, optional
            Whether the first pending task may be started yet.
        meanwhile : iterable, optional
            Work for this process while all workers are busy: it is done by taking the items, one after the other.

        Yields
        ------
        future : Future
        task : object
            In the order in which they finish.

        Raises
        ------
        Cancelled
            When `control` was asked to stop.
        ThinPartError
            If no worker can be started.
        """
        meanwhile = iter(meanwhile)
        while pending or self.busy:
            control.check()
            self.set_paused(control.paused)
            control.set_state("paused" if control.paused else "running")
            while pending and not control.paused and self.has_room and may_start(pending[0]):
                self.submit(pending.popleft())
            finished = self.next_finished()
            if finished is None:
                pending.extendleft(reversed(self.lost_tasks()))
                until = time.monotonic() + _MEANWHILE
                while time.monotonic() < until and next(meanwhile, self) is not self:
                    pass
            else:
                control.check()  # a signal to all processes of a terminal ends workers too: no failure of their tasks
                yield finished

    def submit(self, task):
        """Submit a task to the pool."""
        if self._pool is None:
            self._pool = ProcessPool(*self._pool_arguments)
            self._pool.set_paused(self._paused)
        try:
            future = self._pool.schedule(self._work, (task,), self._seconds)
        except RuntimeError:
            future = Future()  # the pool has just failed: `lost_tasks` returns this task too
        self._submitted[future] = task
        future.add_done_callback(self._finished.put)

    def next_finished(self):
        """The next finished task as (future, task); None if none finishes within `_TICK`."""
        try:
            future = self._finished.get(timeout=_TICK)
        except Empty:
            return None
        self._pool_failures = 0
        return future, self._submitted.pop(future)

    def lost_tasks(self):
        """Take back the tasks of a pool in which no worker can start; the next `submit` creates a new pool.

        Raises
        ------
        ThinPartError
            If that has happened too often in a row.
        """
        if not self._is_broken():
            return []
        self._pool_failures += 1
        if self._pool_failures > _MAX_POOL_FAILURES:
            raise ThinPartError(
                message("The worker processes end as soon as they start: try a larger --memory, or fewer --jobs."),
                "crash",
            )
        self.stop()
        lost = [future for future in self._submitted if not future.done()]
        return [self._submitted.pop(future) for future in lost]

    def stop(self):
        """Kill all workers."""
        if self._pool is not None:
            pool, self._pool = self._pool, None
            pool.stop()

    def _is_broken(self):
        return self._pool is not None and not self._pool.active
