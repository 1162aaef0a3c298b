# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thread of a pool that starts one worker process and sends it one task after the other."""

import io
import os
import shutil
import subprocess
import threading
from concurrent.futures import Future
from concurrent.futures import TimeoutError as TaskTimeout
from contextlib import suppress
from typing import Any, NamedTuple

from ...system.exit_cause import KILLED_END, ProcessEnd
from ...system.interruption import IGNORE_CTRL_C, without_ctrl_c
from ...system.process_group import OWN_GROUP, kill_group
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

_LONGEST_LINE = 1 << 16
"""Maximum bytes of a line that a program prints before `GREETING`."""

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


class PoolTask(NamedTuple):
    """What a worker is sent: pickled work with its arguments, and the future of its result."""

    future: Future
    content: bytes


class WorkerThread(threading.Thread):
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
