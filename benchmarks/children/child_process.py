# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child processes that hold a mesh and carry out one timed task after the other.

Every contestant has its own process, which stays loaded, so that turns can alternate between them: what else
the machine does then hits all alike. Question and answer are one line of JSON each.
"""

import gc
import json
import os
import resource
import select
import subprocess
import sys
import time

from ..places import ROOT

MEMORY_SHARE = 0.8
"""Of the machine's memory, what one child may address: it then fails alone, not the machine."""


class ChildError(Exception):
    """A task that failed, in one sentence."""


class Child:
    """A child process as its parent sees it.

    Parameters
    ----------
    python : str
        Its interpreter.
    module : str
        A module of this package, which calls `serve`.
    arguments : tuple of str
    cores : int, optional
        Processors that it may use; by default all.
    """

    def __init__(self, python, module, *arguments, cores=None):
        self._command = [python, "-m", f"benchmarks.children.{module}", *arguments]
        self._cores = cores
        self._process = None
        self._errors = None

    def ask(self, task, limit=600.0, **arguments):
        """Have a task done; the process is started where it is not running.

        Parameters
        ----------
        task : str
        limit : float, s
            Afterwards the process is ended.

        Returns
        -------
        dict

        Raises
        ------
        ChildError
        """
        self._start()
        try:
            self._process.stdin.write(json.dumps({"task": task, **arguments}).encode() + b"\n")
            self._process.stdin.flush()
        except BrokenPipeError:
            pass  # the answer says why
        answer = json.loads(self._line(limit))
        if "error" in answer:
            raise ChildError(answer["error"])
        return answer

    def close(self):
        """End the process, whatever it is doing."""
        if self._process is not None:
            self._process.kill()
            self._process.wait()
            self._process.stdin.close()
            self._process.stdout.close()
            self._process = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _start(self):
        if self._process is not None:
            return
        try:
            self._process = subprocess.Popen(
                self._command, bufsize=0, env=environment(), stdin=subprocess.PIPE,
                stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, preexec_fn=pinned_to(self._cores),
            )
        except OSError as error:
            raise ChildError(f"{self._command[0]} cannot be started ({error.strerror}).") from None

    def _line(self, limit):
        line, until = b"", time.monotonic() + limit
        while not line.endswith(b"\n"):
            ready = select.select([self._process.stdout], [], [], max(0.0, until - time.monotonic()))
            if not ready[0]:
                self.close()
                raise ChildError(f"It took longer than {limit:.0f} s and was ended.")
            piece = self._process.stdout.read(65536)
            if not piece:
                status = self._process.wait()
                self.close()
                raise ChildError(f"Its process died with status {status}.")
            line += piece
        return line


def environment():
    """The environment of a child: it imports from this checkout and leaves nothing in it; dict of str to str."""
    return dict(os.environ, PYTHONPATH=os.fspath(ROOT), PYTHONSAFEPATH="1", PYTHONDONTWRITEBYTECODE="1")


def pinned_to(cores):
    """What a new process calls so that it and its own children keep to so many processors.

    Before it starts, because libraries count the processors once, when they are loaded.

    Parameters
    ----------
    cores : int or None
        None for all.

    Returns
    -------
    callable or None
        For ``preexec_fn`` of `subprocess.Popen`.
    """
    if cores is None:
        return None
    chosen = sorted(os.sched_getaffinity(0))[:cores]
    return lambda: os.sched_setaffinity(0, chosen)


def serve(tasks):
    """Answer the parent until it closes the pipe.

    Parameters
    ----------
    tasks : dict of str to callable
        Each takes its arguments by name and returns a dict.
    """
    _limit_memory()
    # Libraries print to stdout when they like to, FreeCAD from C++: the answers get a pipe of their own.
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    for line in sys.stdin:
        arguments = json.loads(line)
        try:
            answer = tasks[arguments.pop("task")](**arguments)
        except Exception as error:  # whatever a foreign library raises becomes one row
            answer = {"error": _sentence(error)}
        answers.write(json.dumps(answer) + "\n")
        answers.flush()


def timed(function, *arguments):
    """Call a function once.

    Returns
    -------
    seconds : float
    result : object
    """
    gc.collect()
    start = time.perf_counter()
    result = function(*arguments)
    return time.perf_counter() - start, result


def peak_memory():
    """Greatest memory that this process has had so far, bytes. It never falls."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024


def _limit_memory():
    total = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    limit = int(MEMORY_SHARE * total)
    allowed = resource.getrlimit(resource.RLIMIT_AS)[1]
    if allowed != resource.RLIM_INFINITY:
        limit = min(limit, allowed)
    resource.setrlimit(resource.RLIMIT_AS, (limit, limit))


def _sentence(error):
    text = " ".join(str(error).split())[:200] or "no reason given"
    return f"{type(error).__name__}: {text}"
