# SPDX-License-Identifier: LGPL-2.1-or-later
"""A worker of `process_pool`: ``python -m thinpart_workbench.workflow.workers.pool_worker``.

It receives its parent's process id and its confinement, then ``sys.path``, then its start function, and then tasks, one
after the other. It ends at the end of its input. It responds in JSON.

A confined worker reads no file itself, where the system can fork processes: it forks one for every task, which reads its
file confined, and it passes on what that one writes without looking at it. So a file that takes over its reader has no
effect on the results of others.
"""

import gc
import json
import os
import pickle
import shutil
import sys
from contextlib import suppress

from ...system.confinement import BUBBLEWRAP, confine, confine_writing
from ...system.linux.forked_process import ForkedProcess, prepare_to_fork
from ...system.parent_death import end_with_parent
from .pool_messages import (
    CONFINED,
    DONE,
    ENDED,
    FAILED,
    GREETING,
    PART,
    READY,
    TAKEN,
    encode_response,
    read_message,
    write_message,
)
from .preparation import Unprepared, prepare, want_preparation
from .reading import close_documents

_UNPREPARED = 75
"""Exit code of a forked process that has raised Unprepared."""


def main():
    """Process tasks until none are left."""
    requests, responses = _private_pipes()
    responses.write(GREETING)
    responses.flush()
    try:
        setup = json.loads(read_message(requests)[1])
        worker = (_ForkingWorker if setup["forks"] else _Worker)(requests, responses, setup)
        sys.path[:] = pickle.loads(read_message(requests)[1])
        start, arguments = pickle.loads(read_message(requests)[1])
        start(*arguments)
        write_message(responses, READY)
        while True:
            worker.process(read_message(requests)[1])
    except (EOFError, BrokenPipeError):
        return  # the pool is gone


class _Worker:
    """Processes its tasks itself."""

    def __init__(self, requests, responses, setup):
        self._responses = responses
        # Before importing anything else: an import may start threads.
        self._confinement = encode_response(_confined(setup))
        if setup["confinement"] != BUBBLEWRAP:  # bubblewrap is between the two processes, and ends this one itself
            end_with_parent(setup["parent"])

    def process(self, task):
        write_message(self._responses, TAKEN)
        write_message(self._responses, CONFINED, self._confinement)
        outcome = _outcome(task)
        # Not in a process of its own, which ends: FreeCAD 1.1 ends at once where it may not change the mode of a drawing's
        # template, which it does to remove it.
        close_documents()
        write_message(self._responses, *outcome)


class _ForkingWorker:
    """Forks a process for each task. It ends with its pool because nothing keeps it from seeing that its input ends."""

    def __init__(self, requests, responses, setup):
        self._requests, self._responses, self._setup = requests, responses, setup
        prepare_to_fork()
        want_preparation()
        confine_writing(setup["confinement"], setup["folder"])

    def process(self, task):
        write_message(self._responses, TAKEN)
        kept = set(os.listdir(self._setup["folder"]))
        code = self._run(task)
        if code == _UNPREPARED:
            prepare()
            gc.collect()
            gc.freeze()  # so that the garbage collectors of the forked processes leave the memory alone that they share
            write_message(self._responses, TAKEN)
            code = self._run(task)
        write_message(self._responses, ENDED, encode_response(code))
        self._remove_files(kept)

    def _run(self, task):
        """The exit code of a process that was forked for a task, after its output was passed on."""
        def work(output, parent):
            end_with_parent(parent)
            return _run_confined(task, output, self._setup)

        with ForkedProcess(work, [self._requests.fileno(), self._responses.fileno()]) as reader:
            for part in reader.received(self._requests.fileno()):
                write_message(self._responses, PART, part)
            return reader.end()

    def _remove_files(self, kept):
        """Remove what a task has left, which could be an ambush for the next one."""
        with os.scandir(self._setup["folder"]) as entries:
            for entry in entries:
                if entry.name in kept:
                    continue
                if entry.is_dir(follow_symlinks=False):
                    shutil.rmtree(entry.path, ignore_errors=True)
                else:
                    with suppress(OSError):
                        os.unlink(entry.path)


def _run_confined(task, output, setup):
    write_message(output, CONFINED, encode_response(_confined(setup)))
    try:
        write_message(output, *_outcome(task))
    except Unprepared:
        return _UNPREPARED
    return 0


def _confined(setup):
    return confine(setup["confinement"], setup["folder"], with_programs=setup["programs"])


def _outcome(task):
    try:
        work, arguments = pickle.loads(task)
        return DONE, encode_response(work(*arguments))
    except Exception as error:  # reported to the pool
        return FAILED, encode_response(f"{type(error).__name__}: {error}")


def _private_pipes():
    """The pipes from and to the pool; other code reads from the null device and prints to stderr."""
    requests, responses = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.close(nothing)
    os.dup2(2, 1)
    return requests, responses


if __name__ == "__main__":
    main()
