"""A pool of worker processes by pebble."""

import multiprocessing
from concurrent.futures import Future
from concurrent.futures.process import BrokenProcessPool

from pebble import ProcessExpired
from pebble import ProcessPool as Pool

from ..system.interruption import without_ctrl_c
from .process_pool import WorkerDied


class PebblePool:
    """Does what `process_pool.ProcessPool` does, with the same outcomes.

    Notes
    -----
    pebble gives a pool up when a worker dies that had, as far as it knew, no task: one that could not start,
    that was killed while it waited, or that died in the moment in which it took a task. Tasks that were in
    such a pool never end; pebble before 5.1 has it like that, later ones end them with BrokenProcessPool.
    """

    def __init__(self, count, start, arguments):
        self._pool = Pool(max_workers=count, initializer=start, initargs=arguments,
                          context=multiprocessing.get_context("spawn"))

    @property
    def active(self):
        """See `ProcessPool.active`."""
        return self._pool.active

    def schedule(self, work, arguments, seconds):
        """See `ProcessPool.schedule`."""
        future = Future()
        with without_ctrl_c():
            inner = self._pool.schedule(work, args=arguments, timeout=seconds)
        inner.add_done_callback(lambda ended: _pass_on(ended, future))
        return future

    def stop(self):
        """See `ProcessPool.stop`."""
        self._pool.stop()
        self._pool.join()


def _pass_on(ended, future):
    if ended.cancelled():
        return  # by stopping the pool
    error = ended.exception()
    if error is None:
        future.set_result(ended.result())
    elif isinstance(error, ProcessExpired):
        future.set_exception(WorkerDied(str(error)))
    elif not isinstance(error, BrokenProcessPool):
        future.set_exception(error)
