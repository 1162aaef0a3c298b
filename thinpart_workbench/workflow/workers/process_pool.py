# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pool of worker processes that may be confined, and that return JSON data only."""

import errno
import json
import os
import pickle
import sys
import threading
import time
from concurrent.futures import Future
from queue import Empty, SimpleQueue
from typing import Any, Optional

from ...core.errors import ThinPartError
from ...core.message import message
from ...freecad_adapter.python_beside_freecad import is_within_freecad, python_beside_freecad, python_environment
from ...system.confinement import NONE, UNCONFINED, chosen_confinement, confined_command
from ...system.linux.forked_process import FORKS
from ...system.python_process import CHECKOUT, module_command
from .pool_messages import (
    READY,
    write_message,
)
from .worker_thread import PoolTask, WorkerThread

_MODULE = "thinpart_workbench.workflow.workers.pool_worker"

_TEMPORARY = ("TMPDIR", "TEMP", "TMP", "FREECAD_USER_TEMP", "XDG_CACHE_HOME")
"""Environment variables with folders for temporary files. FreeCAD unpacks documents there. It reads the variables when
it starts, which has already happened if the worker runs in FreeCADCmd."""

_HEAP = ("glibc.malloc.hugetlb=1:glibc.malloc.top_pad=8388608:glibc.malloc.mmap_threshold=33554432:"
         "glibc.malloc.trim_threshold=268435456")
"""Settings of the memory of workers that fork, where the C library is glibc. A forked process starts with no free memory;
with these it asks the system for large pieces and keeps them, as a process would that has analysed files before."""

_TASKS_PER_WORKER = 4
"""Running and queued tasks: enough that no worker is idle while the parent prints."""

_TICK = 0.1
"""Seconds after which `next_finished` returns without a task, so that the caller can do other work."""

_MEANWHILE = 0.05
"""Longest time without looking for finished tasks, in which other work may start, in seconds."""

_MOST_FAILED_STARTS = 5
"""Times in a row that none of the workers could start, after which the run fails."""


class ProcessPool:
    """Worker processes that each do one task after the other; a worker that dies fails its task and is replaced.

    Each worker has a thread in this process that communicates with it through pipes. Linux ends a process with
    the thread that has started it, and threads can wait for pipes on every system. Workers respond in JSON: a
    malicious file may have taken over the worker, and unpickling its response would run code.

    Parameters
    ----------
    count : int
    seconds : float
        Time limit of a task, from when a worker has received it.
    folder : str
        Folder for the logs of workers and for a folder per worker for its files; both are removed with the worker.
    work : callable
        ``work(task)`` runs in a worker; its result must be JSON values. It is pickled by its name.
    start : callable
        Runs in each new worker.
    start_arguments : tuple
    confine : bool
        Whether to restrict workers to writing into their folder, without network, if the system supports that, and to let
        none process more than one task, if it can fork processes.
    with_programs : bool
        Whether confined workers may run programs.

    Attributes
    ----------
    confinement : dict
        Confinement during the task that finished last; see `confinement.confine`.
    """

    def __init__(self, count, seconds, folder, work, start, start_arguments=(), confine=False, with_programs=False):
        self._count, self.seconds, self._folder, self._work = count, seconds, folder, work
        self._confinement = chosen_confinement() if confine else NONE
        self._with_programs = with_programs
        self.forks = confine and FORKS
        self._setup_messages = pickle.dumps(sys.path), pickle.dumps((start, start_arguments))
        self._tasks: SimpleQueue[Optional[PoolTask]] = SimpleQueue()
        self._submitted: dict[Future, Any] = {}
        self._finished: SimpleQueue[Future] = SimpleQueue()
        self._threads: list[WorkerThread] = []
        self._lock = threading.Lock()
        self._may_start = threading.Event()
        self._may_start.set()
        self._stopped = False
        self._started = self._failed_starts = 0
        self.confinement = UNCONFINED

    def run(self, pending, control, meanwhile=()):
        """Do tasks until none are left.

        Yields `future` (Future; see `next_finished`) and `task` (object; in the order in which they finish). Raises
        Cancelled when `control` was asked to stop; ThinPartError if no worker can be started.

        Parameters
        ----------
        pending : deque
            Tasks in the order in which they are started.
        control : RunControl
            Pauses and stops the run.
        meanwhile : iterable, optional
            Work for this process while all workers are busy: it is done by taking the items, one after the other.
        """
        meanwhile = iter(meanwhile)
        while pending or self.busy:
            control.check()
            self.set_paused(control.paused)
            control.set_state("paused" if control.paused else "running")
            while pending and not control.paused and self.has_room:
                self.submit(pending.popleft())
            finished = self.next_finished()
            if finished is None:
                until = time.monotonic() + _MEANWHILE
                while time.monotonic() < until and next(meanwhile, self) is not self:
                    pass
            else:
                control.check()  # a signal to all processes of a terminal ends workers too: no failure of their tasks
                yield finished

    @property
    def busy(self):
        """Whether any task is running or queued."""
        return bool(self._submitted)

    @property
    def has_room(self):
        """Whether another task can be submitted without waiting long for a worker."""
        return len(self._submitted) < _TASKS_PER_WORKER * self._count

    def submit(self, task):
        """Have a worker do a task, as soon as one is free."""
        future: Future = Future()
        future.add_done_callback(self._finished.put)
        self._submitted[future] = task
        self._tasks.put(PoolTask(future, pickle.dumps((self._work, (task,)))))
        self._start_thread()

    def next_finished(self):
        """The next finished task.

        Returns a tuple of (Future, object), or None: the future and its task. Its result consists of JSON values; its
        exception is WorkerFault if the work raised one, `concurrent.futures.TimeoutError` or WorkerDied. None if no task
        finishes within `_TICK`. Raises ThinPartError if no worker could start, too often in a row.
        """
        try:
            future = self._finished.get(timeout=_TICK)
        except Empty:
            if self._submitted and not self._threads:
                self._failed_starts += 1
                if self._failed_starts > _MOST_FAILED_STARTS:
                    raise ThinPartError(
                        message("The worker processes end as soon as they start: try a larger --memory, or fewer --jobs."),
                        "crash") from None
                for _ in self._submitted:
                    self._start_thread()
            return None
        self._failed_starts = 0
        return future, self._submitted.pop(future)

    def set_paused(self, paused):
        """Pause: workers start no further task. Or resume."""
        if paused:
            self._may_start.clear()
        else:
            self._may_start.set()

    def stop(self):
        """Kill all workers, and wait until they have ended. Tasks that are not done never finish."""
        self._stopped = True
        self._may_start.set()
        with self._lock:
            threads = list(self._threads)
        for thread in threads:
            thread.stop()
            self._tasks.put(None)
        for thread in threads:
            thread.join()

    def _start_thread(self):
        """Start a further worker, if there may be one."""
        with self._lock:
            if len(self._threads) < self._count and not self._stopped:
                self._started += 1
                folder = os.path.join(self._folder, f"worker-{id(self):x}-{self._started}")
                self._threads.append(WorkerThread(self, folder))
                self._threads[-1].start()

    def command(self, folder):
        """The command that starts a worker, and its environment.

        Raises OSError if there is no program that can run a worker.

        Parameters
        ----------
        folder : str
            The folder into which it may write.
        """
        # FreeCAD's Python console starts workers too; there sys.executable is FreeCAD.
        program, environment = None, os.environ
        if is_within_freecad():
            program, environment = python_beside_freecad(), python_environment()
            if program is None:
                raise FileNotFoundError(errno.ENOENT, "python")  # FreeCAD itself would open another window
        command, variables = module_command(_MODULE, program=program)
        path = os.pathsep.join(filter(None, (os.fspath(CHECKOUT), environment.get("PYTHONPATH"))))
        temporary = dict.fromkeys(_TEMPORARY, folder)
        # Tasks run in parallel already; threads of the linear algebra library would compete for the processors.
        openblas = {"OPENBLAS_NUM_THREADS": os.environ.get("OPENBLAS_NUM_THREADS", "1")}
        heap = {"GLIBC_TUNABLES": ":".join(filter(None, (_HEAP, environment.get("GLIBC_TUNABLES"))))} if self.forks else {}
        return (confined_command(command, self._confinement, folder),
                {**environment, **openblas, **heap, **variables, **temporary, "PYTHONPATH": path})

    def send_setup(self, process, folder):
        """Send the setup to a new worker; it responds with READY. Raises OSError if the worker has ended."""
        setup = json.dumps({"parent": os.getpid(), "confinement": self._confinement, "folder": folder,
                            "forks": self.forks, "programs": self._with_programs}).encode()
        for part in (setup, *self._setup_messages):
            write_message(process.stdin, READY, part)

    def next_task(self):
        """Wait for the next task that may be started; None after `stop`."""
        task = self._tasks.get()
        self._may_start.wait()
        return None if self._stopped else task

    def on_start_failed(self, thread, task):
        """Handle a worker that cannot start: put its task back for another worker."""
        with self._lock:
            self._threads.remove(thread)
        self._tasks.put(task)
