"""A pool of worker processes that takes nothing but the standard library."""

import os
import pickle
import subprocess
import sys
import threading
from concurrent.futures import Future
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import suppress
from queue import SimpleQueue

from ..system.interruption import DEAF_TO_CTRL_C, without_ctrl_c
from ..system.python_process import CHECKOUT, module_command
from .pool_messages import DONE, FAILED, GREETING, READY, TAKEN, read_message, write_message

_MODULE = "thinpart_workbench.workflow.pool_worker"

_MOST_TRIES = 3
"""Workers that a task is offered to: one may be killed while it waits."""


class WorkerDied(Exception):
    """A worker process ended in the middle of a task."""


class ProcessPool:
    """Processes that each take one task after the other.

    One that dies costs the task that it was at, and is replaced. See `pebble_pool` for the same by a library.

    Parameters
    ----------
    count : int
    start : callable
        Runs in each new worker.
    arguments : tuple

    Notes
    -----
    A thread of this process keeps each worker, which is asked through a pipe. Linux ends a process with the
    thread that has started it, and threads can wait for pipes on every system.
    """

    def __init__(self, count, start, arguments):
        self._count = count
        self._first = pickle.dumps(sys.path), pickle.dumps((start, arguments))
        self._tasks = SimpleQueue()
        self._keepers = []
        self._lock = threading.Lock()
        self._stopped = self._broken = False

    @property
    def active(self):
        """Whether tasks are begun: not after `stop`, and not where no worker can start."""
        return not (self._stopped or self._broken)

    def schedule(self, work, arguments, seconds):
        """Have a worker call a function.

        Parameters
        ----------
        work : callable
            By its name in its module, which workers import.
        arguments : tuple
        seconds : float
            What that may take, from when a worker has taken it.

        Returns
        -------
        Future
            Ends with the result; with what the function raised; with `concurrent.futures.TimeoutError`; with
            WorkerDied. Never, where the pool is stopped or breaks down before.

        Raises
        ------
        RuntimeError
            Where the pool is not active.
        """
        if not self.active:
            raise RuntimeError("the pool takes no tasks any more")
        future = Future()
        self._tasks.put(_Task(future, pickle.dumps((work, arguments)), seconds))
        with self._lock:
            if len(self._keepers) < self._count:
                self._keepers.append(_Keeper(self._first, self._tasks, self._gave_up))
                self._keepers[-1].start()
        return future

    def stop(self):
        """End all workers, whatever they are at, and wait for that."""
        self._stopped = True
        with self._lock:
            keepers = list(self._keepers)
        for keeper in keepers:
            keeper.stop()
            self._tasks.put(None)
        for keeper in keepers:
            keeper.join()

    def _gave_up(self, keeper, task):
        """A worker cannot start. Its task is left to the others where there are any."""
        with self._lock:
            self._keepers.remove(keeper)
            self._broken = not self._keepers
        self._tasks.put(task)


class _Task:
    def __init__(self, future, content, seconds):
        self.future, self.content, self.seconds = future, content, seconds


class _Keeper(threading.Thread):
    """The thread that has one worker and gives it tasks."""

    def __init__(self, first, tasks, gave_up):
        super().__init__(name="thinpart-worker", daemon=True)
        self._first, self._tasks, self._gave_up = first, tasks, gave_up
        self._process = None
        self._lock = threading.Lock()
        self._stopped = False
        self._timed = None  # the task whose time runs
        self._is_late = False

    def run(self):
        with without_ctrl_c():
            while (task := self._tasks.get()) is not None and not self._stopped:
                try:
                    can_start = self._do(task)
                except Exception as error:  # whoever waits for this task has to hear of it, and of the next ones
                    self._end_worker()
                    task.future.set_exception(error)
                    continue
                if not can_start:
                    self._gave_up(self, task)
                    break
        self._end_worker()

    def stop(self):
        """End the worker, whatever it is at, and take no further task; from another thread."""
        with self._lock:
            self._stopped = True
            if self._process is not None:
                self._process.kill()

    def _do(self, task):
        """Have a task done; False where no worker can start."""
        for _ in range(_MOST_TRIES):
            if self._process is None and not self._start_worker():
                return self._stopped
            if self._hand_over(task):
                self._take_outcome(task)
                return True
            self._end_worker()  # it was killed while it waited
            if self._stopped:
                return True
        task.future.set_exception(WorkerDied())
        return True

    def _start_worker(self):
        command, variables = module_command(_MODULE)
        path = os.pathsep.join(filter(None, (os.fspath(CHECKOUT), os.environ.get("PYTHONPATH"))))
        with self._lock:
            if self._stopped:
                return False
            try:
                self._process = subprocess.Popen(
                    command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, creationflags=DEAF_TO_CTRL_C,
                    env={**os.environ, **variables, "PYTHONPATH": path})
            except OSError:
                return False  # no memory for one more process, or too many of them
        try:
            for part in self._first:
                write_message(self._process.stdin, READY, part)
            while line := self._process.stdout.readline():
                if line == GREETING:  # FreeCADCmd introduces itself first
                    break
        except OSError:
            pass  # it has ended
        if self._answer()[0] == READY:
            return True
        self._end_worker()
        return False

    def _hand_over(self, task):
        try:
            write_message(self._process.stdin, TAKEN, task.content)
        except OSError:
            return False
        return self._answer()[0] == TAKEN

    def _take_outcome(self, task):
        with self._lock:
            self._timed, self._is_late = task, False
        timer = threading.Timer(task.seconds, self._end_late, (task,))
        timer.start()
        kind, content = self._answer()
        timer.cancel()
        with self._lock:
            self._timed = None
        if kind == DONE:
            task.future.set_result(pickle.loads(content))
            return
        if kind == FAILED:
            task.future.set_exception(pickle.loads(content))
            return
        self._end_worker()
        if self._is_late:
            task.future.set_exception(TaskTimeout())
        elif not self._stopped:
            task.future.set_exception(WorkerDied())

    def _end_late(self, task):
        with self._lock:
            if self._timed is task:
                self._is_late = True
                self._process.kill()

    def _answer(self):
        """Kind and content of what the worker says; None and None where it has ended."""
        try:
            return read_message(self._process.stdout)
        except (OSError, EOFError):
            return None, None

    def _end_worker(self):
        with self._lock:
            process, self._process = self._process, None
        if process is None:
            return
        process.kill()
        for pipe in (process.stdin, process.stdout):
            with suppress(OSError):
                pipe.close()
        process.wait()
