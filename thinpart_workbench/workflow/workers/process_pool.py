"""A pool of worker processes that may be confined, and that return JSON data only."""

import errno
import io
import json
import os
import pickle
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import Future
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import suppress
from queue import Empty, SimpleQueue
from typing import Any, NamedTuple, Optional

from ...core.errors import ThinPartError
from ...core.message import message
from ...freecad_adapter.python_beside_freecad import is_within_freecad, python_beside_freecad, python_environment
from ...system.confinement import NONE, UNCONFINED, chosen_confinement, confined_command
from ...system.exit_cause import KILLED_END, ProcessEnd
from ...system.interruption import IGNORE_CTRL_C, without_ctrl_c
from ...system.linux.forked_process import FORKS
from ...system.process_group import OWN_GROUP, kill_group
from ...system.python_process import CHECKOUT, module_command
from .pool_messages import (
    CONFINED,
    DONE,
    ENDED,
    FAILED,
    GREETING,
    LARGEST,
    PART,
    READY,
    TAKEN,
    InvalidMessage,
    decode_response,
    read_message,
    write_message,
)

_MODULE = "thinpart_workbench.workflow.workers.pool_worker"

_TEMPORARY = ("TMPDIR", "TEMP", "TMP", "FREECAD_USER_TEMP", "XDG_CACHE_HOME")
"""Environment variables with folders for temporary files. FreeCAD unpacks documents there. It reads the variables when
it starts, which has already happened if the worker runs in FreeCADCmd."""

_HEAP = ("glibc.malloc.hugetlb=1:glibc.malloc.top_pad=8388608:glibc.malloc.mmap_threshold=33554432:"
         "glibc.malloc.trim_threshold=268435456")
"""Settings of the memory of workers that fork, where the C library is glibc. A forked process starts with no free memory;
with these it asks the system for large pieces and keeps them, as a process would that has analysed files before."""

_LONGEST_LINE = 1 << 16
"""Maximum bytes of a line that a program prints before `GREETING`."""

_TASKS_PER_WORKER = 4
"""Running and queued tasks: enough that no worker is idle while the parent prints."""

_TICK = 0.1
"""Seconds after which `next_finished` returns without a task, so that the caller can do other work."""

_MEANWHILE = 0.05
"""Longest time without looking for finished tasks, in which other work may start, in seconds."""

_MOST_FAILED_STARTS = 5
"""Times in a row that none of the workers could start, after which the run fails."""

_MAX_ATTEMPTS = 3
"""Workers to which a task is sent before it fails: idle workers may be killed."""

_MAX_LOG_BYTES = 1 << 20
"""Bytes that are read of the log of a dead worker."""

_END_SECONDS = 1.0
"""Seconds to wait for a worker that has closed its pipe to exit, in order to get its own exit code."""


class WorkerDied(Exception):
    """A worker process ended during a task.

    Attributes
    ----------
    end : ProcessEnd
        Its text is what the worker printed during that task.
    """

    def __init__(self, end=KILLED_END):
        super().__init__()
        self.end = end


class WorkerFault(Exception):
    """The exception of a task as text: its class and message."""


class ProcessPool:
    """Worker processes that each do one task after the other; a worker that dies fails its task and is replaced.

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

    Notes
    -----
    Each worker has a thread in this process that communicates with it through pipes. Linux ends a process with
    the thread that has started it, and threads can wait for pipes on every system. Workers respond in JSON: a
    malicious file may have taken over the worker, and unpickling its response would run code.
    """

    def __init__(self, count, seconds, folder, work, start, start_arguments=(), confine=False, with_programs=False):
        self._count, self.seconds, self._folder, self._work = count, seconds, folder, work
        self._confinement = chosen_confinement() if confine else NONE
        self._with_programs = with_programs
        self.forks = confine and FORKS
        self._setup_messages = pickle.dumps(sys.path), pickle.dumps((start, start_arguments))
        self._tasks: SimpleQueue[Optional[_Task]] = SimpleQueue()
        self._submitted: dict[Future, Any] = {}
        self._finished: SimpleQueue[Future] = SimpleQueue()
        self._threads: list[_WorkerThread] = []
        self._lock = threading.Lock()
        self._may_start = threading.Event()
        self._may_start.set()
        self._stopped = False
        self._started = self._failed_starts = 0
        self.confinement = UNCONFINED

    def run(self, pending, control, may_start=lambda task: True, meanwhile=()):
        """Do tasks until none are left.

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
            See `next_finished`.
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
        self._tasks.put(_Task(future, pickle.dumps((self._work, (task,)))))
        self._start_thread()

    def next_finished(self):
        """The next finished task.

        Returns
        -------
        tuple of (Future, object), or None
            The future and its task. Its result consists of JSON values; its exception is WorkerFault if the work raised one,
            `concurrent.futures.TimeoutError` or WorkerDied. None if no task finishes within `_TICK`.

        Raises
        ------
        ThinPartError
            If no worker could start, too often in a row.
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
                self._threads.append(_WorkerThread(self, folder))
                self._threads[-1].start()

    def command(self, folder):
        """The command that starts a worker, and its environment.

        Parameters
        ----------
        folder : str
            The folder into which it may write.

        Raises
        ------
        OSError
            If there is no program that can run a worker.
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
        """Send the setup to a new worker; it responds with READY.

        Raises
        ------
        OSError
            If the worker has ended.
        """
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


class _Task(NamedTuple):
    future: Future
    content: bytes


class _WorkerThread(threading.Thread):
    """The thread that starts one worker and sends tasks to it."""

    def __init__(self, pool, folder):
        super().__init__(name="thinpart-worker", daemon=True)
        self._pool, self._folder = pool, folder
        # While there is a worker: its `Popen`, with pipes, and its log file.
        self._worker: Any = None
        self._log: Any = None
        self._lock = threading.Lock()
        self._stopped = False
        self._timed_task = None  # the task whose timer is running
        self._timed_out = False

    def run(self):
        with without_ctrl_c():
            while (task := self._pool.next_task()) is not None:
                try:
                    can_start = self._process(task)
                except Exception as error:  # reported to the waiting caller; the thread goes on with the next task
                    self._end_worker()
                    task.future.set_exception(error)
                    continue
                if not can_start:
                    self._pool.on_start_failed(self, task)
                    break
        self._end_worker()

    def stop(self):
        """Kill the worker and take no further task; called from another thread."""
        with self._lock:
            self._stopped = True
            if self._worker is not None:
                self._kill()

    def _process(self, task):
        """Process a task; False if no worker can start."""
        for _ in range(_MAX_ATTEMPTS):
            if self._worker is None and not self._start_worker():
                return self._stopped
            if self._send_task(task):
                self._set_outcome(task)
                return True
            self._end_worker()  # the idle worker was killed
            if self._stopped:
                return True
        task.future.set_exception(WorkerDied())  # each of the workers was killed while idle
        return True

    def _start_worker(self):
        with self._lock:
            if self._stopped:
                return False
            try:
                os.mkdir(self._folder, 0o700)
                # Outside the worker's folder: the worker has the open file, but cannot write to its path.
                self._log = open(self._folder + ".log", "w+b", buffering=0)
                command, variables = self._pool.command(self._folder)
                self._worker = subprocess.Popen(
                    command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self._log,
                    creationflags=IGNORE_CTRL_C, start_new_session=OWN_GROUP, env=variables)
            except OSError:  # not enough memory, too many processes, or no disk space
                self._remove_folder()
                return False
        try:
            self._pool.send_setup(self._worker, self._folder)
            while line := self._worker.stdout.readline(_LONGEST_LINE):
                if line == GREETING:  # FreeCADCmd prints its banner first
                    break
        except OSError:
            pass  # it has ended
        if self._read_message()[0] == READY:
            return True
        self._end_worker()
        return False

    def _send_task(self, task):
        self._log.seek(0)  # also the worker's position: the file description is shared
        self._log.truncate()
        try:
            write_message(self._worker.stdin, TAKEN, task.content)
        except OSError:
            return False
        return self._read_message()[0] == TAKEN

    def _set_outcome(self, task):
        with self._lock:
            self._timed_task, self._timed_out = task, False
        timer = threading.Timer(self._pool.seconds, self._on_timeout, (task,))
        timer.start()
        outcome, code = self._read_outcome()
        timer.cancel()
        with self._lock:
            self._timed_task = None
        if self._set_response(task, outcome):
            return
        log = self._read_log()
        if code is None:
            code = self._end_worker(_END_SECONDS)
        if self._timed_out:
            task.future.set_exception(TaskTimeout())
        elif not self._stopped:
            task.future.set_exception(WorkerDied(ProcessEnd(code, log)))

    def _set_response(self, task, outcome):
        """Whether the messages about a task are valid, and have become its result or exception."""
        try:
            _, confinement = read_message(outcome)  # it comes before anything is read that could forge it
            self._pool.confinement = decode_response(confinement)
            kind, content = read_message(outcome)
            response = decode_response(content)
        except (EOFError, InvalidMessage):
            return False
        if kind == DONE:
            task.future.set_result(response)
        elif kind == FAILED:
            task.future.set_exception(WorkerFault(str(response)))
        return kind in (DONE, FAILED)

    def _on_timeout(self, task):
        with self._lock:
            if self._timed_task is task:
                self._timed_out = True
                self._kill()

    def _kill(self):
        """Have the worker end; one that forks ends at once, after the processes that it has forked."""
        if self._pool.forks:
            self._worker.terminate()
        else:
            kill_group(self._worker)

    def _read_outcome(self):
        """The messages about a task, a binary file, and the exit code of the process that was forked for it or None."""
        outcome, code = io.BytesIO(), None
        while outcome.tell() <= LARGEST:
            kind, content = self._read_message()
            if kind == PART:
                outcome.write(content)
            elif kind == TAKEN:
                outcome = io.BytesIO()  # another process was forked for the same task
            elif kind == ENDED:
                code = decode_response(content)
                break
            elif kind is None:
                break
            else:
                write_message(outcome, kind, content)
                if kind != CONFINED:
                    break
        outcome.seek(0)
        return outcome, code

    def _read_message(self):
        """Kind and content of the worker's next message; (None, None) if it has ended."""
        try:
            return read_message(self._worker.stdout)
        except (OSError, EOFError, InvalidMessage):
            return None, None

    def _read_log(self):
        try:
            self._log.seek(0)
            return self._log.read(_MAX_LOG_BYTES)
        except OSError:
            return b""

    def _end_worker(self, patience=0.0):
        """End the worker, if there is one, and return its exit code. Wait `patience` seconds before killing it."""
        with self._lock:
            process, self._worker = self._worker, None
        if process is None:
            return None
        with suppress(subprocess.TimeoutExpired):
            process.wait(patience)
        if self._pool.forks:
            process.terminate()  # it ends what it has forked
            with suppress(subprocess.TimeoutExpired):
                process.wait(_END_SECONDS)
        kill_group(process)
        for pipe in (process.stdin, process.stdout):
            with suppress(OSError):
                pipe.close()
        process.wait()
        self._remove_folder()
        return process.returncode

    def _remove_folder(self):
        """Remove the files of a worker, such as documents that FreeCAD unpacked, and its log."""
        if self._log is not None:
            self._log.close()
            self._log = None
        with suppress(OSError):
            os.unlink(self._folder + ".log")
        with suppress(RecursionError):  # a reader was made to nest folders; the folder of the run is in it still
            shutil.rmtree(self._folder, ignore_errors=True)
