# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limit the resources of a process and of programs that it runs, and suppress core dumps and crash dialogs."""

import errno
import os
import shutil
import signal
import subprocess
import sys
from dataclasses import dataclass

from . import windows
from .exit_cause import ProcessEnd

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None

WALL_FACTOR = 3.0
"""Times the limit that a program may take by the clock where the limit is for the processor."""

_CPU_SIGNALS = {-getattr(signal, name).value for name in ("SIGXCPU", "SIGKILL") if hasattr(signal, name)}

MEMORY_CAN_BE_LIMITED = sys.platform != "darwin"
"""Whether memory can be limited. macOS rejects a limit of the address space, or accepts it without enforcing it."""


@dataclass(frozen=True)
class ProgramEnd(ProcessEnd):
    """How a program ended.

    Attributes
    ----------
    timed_out : bool
        Whether it was ended because of the limit of time.
    """

    timed_out: bool = False


def limit_memory(size):
    """Make allocations beyond a limit fail in this process and those that it starts; it cannot be raised again.

    Returns a bool: whether the limit is in effect.

    Parameters
    ----------
    size : int
        Bytes of address space, or of committed memory on Windows.
    """
    try:
        if resource is None:
            windows.join_new_job(windows.LIMIT_MEMORY, size)
        else:
            _lower_limit(resource.RLIMIT_AS, size)
    except (OSError, ValueError):
        if MEMORY_CAN_BE_LIMITED:
            raise
        return False
    return MEMORY_CAN_BE_LIMITED


def limit_files(size, count):
    """Limit the size of files that this process writes, and the number of files that it opens.

    Windows has no such limits.

    Parameters
    ----------
    size : int
        Bytes.
    count : int
        Open files.
    """
    if resource is not None:
        _lower_limit(resource.RLIMIT_FSIZE, size)
        _lower_limit(resource.RLIMIT_NOFILE, count)


def crash_quietly():
    """Prevent a crash from writing a core dump of several GB or opening a dialog that waits for an answer."""
    if resource is None:
        windows.crash_without_dialog()
    else:
        _lower_limit(resource.RLIMIT_CORE, 0)


def _lower_limit(limit, requested):
    # The hard limit too: what a file has taken over would raise the soft one again.
    most = resource.getrlimit(limit)[1]
    least = requested if most == resource.RLIM_INFINITY else min(requested, most)
    resource.setrlimit(limit, (least, least))


def run_limited(command, seconds, folder, environment=None):
    """Run a program with a limit of time and wait for it. Limits of memory and files are inherited from this process.

    Returns a ProgramEnd: its output holds both streams. Raises OSError if the program cannot be started.

    A confined process may neither kill another nor set its limits (see `system_call_filter`), so a shell sets the limit
    that the program then has, and the kernel ends it.

    Parameters
    ----------
    command : list of str
    seconds : float
        Limit of processor time where the system can limit that of another process, else by the clock.
    folder : str
        Working directory.
    environment : dict, optional
        Environment variables; by default those of this process.
    """
    if shutil.which(command[0]) is None:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), command[0])
    with_limit = _with_processor_limit(seconds)
    process = subprocess.Popen([*_ends_with_this_process(), *with_limit, *command], cwd=folder, env=environment,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    try:
        output, _ = process.communicate(timeout=WALL_FACTOR * seconds if with_limit else seconds)
    except subprocess.TimeoutExpired:
        try:
            process.kill()
        except PermissionError:
            pass  # confined: what started this process has a limit for it
        process.stdout.close()
        return ProgramEnd(process.wait(), b"", True)
    timed_out = bool(with_limit) and process.returncode in _CPU_SIGNALS
    return ProgramEnd(process.returncode, output, timed_out)


def _ends_with_this_process():
    """The prefix of a command on Linux that ends it when this process ends."""
    program = shutil.which("setpriv") if sys.platform.startswith("linux") else None
    return [] if program is None else [program, "--pdeathsig", "KILL"]


def _with_processor_limit(seconds):
    """The prefix of a command on Linux that limits its processor time."""
    shell = shutil.which("sh") if sys.platform.startswith("linux") else None
    if shell is None:
        return []
    whole = max(1, round(seconds))
    return [shell, "-c", 'ulimit -S -t "$1" && ulimit -H -t "$2" && shift 2 && exec "$@"', shell, str(whole), str(whole + 1)]
