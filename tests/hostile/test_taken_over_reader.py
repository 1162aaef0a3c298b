# SPDX-License-Identifier: LGPL-2.1-or-later
"""A reader that a file has taken over: what it can do to other processes, to other files of the run, and to its limits."""

import ctypes
import fcntl
import json
import os
import resource
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
from contextlib import suppress
from pathlib import Path

import pytest
import time_limit
from program import SAMPLES
from run_workers import run_workers
from test_confinement import CONFINEMENTS

from thinpart_workbench.system.confinement import VARIABLE
from thinpart_workbench.system.linux.system_calls import MACHINES
from thinpart_workbench.workflow.analysis.analyse_file import FileTask
from thinpart_workbench.workflow.workers.process_pool import ProcessPool
from thinpart_workbench.workflow.workers.reading import start_reader

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="readers are forked on Linux alone")

_REMOVE = 0
"""IPC_RMID of the three kinds of System V objects."""

_LIBRARY = ctypes.CDLL(None, use_errno=True)


def _call(name, *arguments):
    """A system call by its name; OSError if it is refused or fails."""
    machine = MACHINES[os.uname().machine]
    values = [ctypes.c_long(each) if isinstance(each, int) else each for each in arguments]
    found = _LIBRARY.syscall(ctypes.c_long(machine.numbers[name]), *values)
    if found < 0:
        raise OSError(ctypes.get_errno(), name)
    return found


def _settings():
    return ctypes.create_string_buffer(64)


_REACHES = {
    "limits of another": lambda number: _call("prlimit64", number, 0, (ctypes.c_ulong * 2)(1, 1), None),
    "limits of another read": lambda number: _call("prlimit64", number, 0, None, _settings()),
    "its own limit raised": lambda number: resource.setrlimit(resource.RLIMIT_AS, (-1, -1)),
    "processors": lambda number: os.sched_setaffinity(number, {0}),
    "scheduler": lambda number: _call("sched_setscheduler", number, 5, ctypes.byref(ctypes.c_int(0))),
    "scheduler and its values": lambda number: _call("sched_setattr", number, _settings(), 0),
    "nice value": lambda number: os.setpriority(os.PRIO_PROCESS, number, 19),
    "nice value of all of its group": lambda number: os.setpriority(os.PRIO_PGRP, 0, 19),
    "disk priority": lambda number: _call("ioprio_set", 1, number, 0x4007),
    "a handle of a process": lambda number: os.pidfd_open(number),
    "comparing": lambda number: _call("kcmp", number, number, 1, 0, 0),
    "reading memory": lambda number: _call("process_vm_readv", number, None, 0, None, 0, 0),
    "pair of sockets": lambda number: socket.socketpair(),
    "shared memory": lambda number: _call("shmctl", _call("shmget", 0, 4096, 0o1600), _REMOVE, 0),
    "semaphores": lambda number: _call("semctl", _call("semget", 0, 1, 0o1600), 0, _REMOVE, 0),
    "messages": lambda number: _call("msgctl", _call("msgget", 0, 0o1600), _REMOVE, 0),
    "keyring": lambda number: _call("keyctl", 0, -4, 1),
    "a file in memory": lambda number: os.memfd_create("x"),
    "rings": lambda number: _call("io_uring_setup", 1, (ctypes.c_char * 120)()),
    "user faults": lambda number: _call("userfaultfd", 1),
    "namespaces": lambda number: _call("unshare", 0x10000000),
    "a process in namespaces": lambda number: _call("clone", 0x10000000 | signal.SIGCHLD, 0, 0, 0, 0),
    "a session": lambda number: os.setsid(),
    "a group": lambda number: os.setpgid(0, 0),
    "a process": lambda number: _fork(),
    "a program": lambda number: subprocess.run(["true"], check=True),
    "signals when a file is ready": lambda number: fcntl.fcntl(0, 8, number),
    "a lock of a folder": lambda number: fcntl.flock(os.open(tempfile.gettempdir(), os.O_RDONLY), fcntl.LOCK_EX),
}
"""What no reader is to do, with the number of a process of the same user.

Some of it is done without confinement too: it may affect that process and the reader alone, and leave nothing behind.
"""

_ITSELF = {
    "its own limits": lambda number: resource.getrlimit(resource.RLIMIT_AS),
    "its own processors": lambda number: os.sched_setaffinity(0, os.sched_getaffinity(0)),
    "its own nice value": lambda number: os.getpriority(os.PRIO_PROCESS, 0),
    "a thread": lambda number: threading.Thread(target=time.time).start(),
    "a signal to itself": lambda number: os.kill(os.getpid(), 0),
}
"""What is no harm."""


def _fork():
    if os.fork() == 0:
        os._exit(0)


def reach(task):
    """In the reader: which of these it can do."""
    done = []
    for name, act in {**_REACHES, **_ITSELF}.items():
        with suppress(OSError, ValueError):
            act(int(task.file))
            done.append(name)
    return done


def forge(task):
    """In the reader: change what the next one uses, and leave a process behind that answers for it."""
    from thinpart_workbench.workflow.analysis import analyse_file

    before = getattr(analyse_file, "forged", False), os.path.exists(os.path.join(tempfile.gettempdir(), "ambush"))
    analyse_file.forged = True
    Path(tempfile.gettempdir(), "ambush").mkdir()
    return before


def write_everywhere(task):
    """In the reader: to every pipe that is open, and to the memory of the process that forked it."""
    reached = []
    for handle in range(3, 64):
        with suppress(OSError):
            if os.readlink(f"/proc/self/fd/{handle}").startswith("pipe:"):
                reached.append(handle)
    for mode in ("rb", "r+b"):
        with suppress(OSError):
            open(f"/proc/{os.getppid()}/mem", mode).close()
            reached.append("memory")
    return reached


def hold_the_pipe(task):
    """In the reader: end, and leave a process that keeps the pipe for the answer."""
    if os.fork() == 0:
        if task.file == "own session":
            with suppress(OSError):
                os.setsid()
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
        time.sleep(600)
    os._exit(0)


def sleep_twice(task):
    """In the reader: take too long, together with a process that ignores what can be ignored."""
    if os.fork() == 0:
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(600)


def fork_without_end(task):
    """In the reader: more and more processes, none of which takes much."""
    while True:
        if os.fork() == 0:
            time.sleep(600)


@pytest.fixture
def other():
    """A process of the same user."""
    process = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(600)"])
    yield process
    process.kill()
    process.wait()


def _outcomes(workers, *files):
    found = []
    for file in files:
        workers.submit(FileTask(str(file)))
        while (one := workers.next_finished()) is None:
            pass
        found.append(one[0].exception() or one[0].result())
    return found


def _with_programs(folder, do, seconds, megabytes=1024):
    return ProcessPool(1, seconds, str(folder), do, start_reader, (megabytes,), confine=True, with_programs=True)


@pytest.mark.parametrize("confinement", CONFINEMENTS)
def test_a_reader_reaches_no_other_process_and_no_limit(tmp_path, monkeypatch, other, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    with run_workers(reach, tmp_path, 50.0) as workers:
        done, = _outcomes(workers, other.pid)
    assert done == [*_ITSELF]
    assert other.poll() is None and os.getpriority(os.PRIO_PROCESS, other.pid) == os.getpriority(os.PRIO_PROCESS, 0)


def test_what_is_tried_there_can_be_done_without_confinement(tmp_path, monkeypatch, other):
    """Else the test above would pass wherever an attempt is wrong in itself."""
    monkeypatch.setenv(VARIABLE, "none")
    with run_workers(reach, tmp_path, 50.0) as workers:
        done, = _outcomes(workers, other.pid)
    usual = {"limits of another", "limits of another read", "processors", "scheduler", "nice value", "a handle of a process",
             "pair of sockets", "shared memory", "semaphores", "messages", "a file in memory", "a process", "a program",
             "a lock of a folder"}
    assert usual <= set(done)


@pytest.mark.parametrize("confinement", [*CONFINEMENTS, "none"])
def test_no_file_affects_the_reader_of_the_next_one(tmp_path, monkeypatch, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    with run_workers(forge, tmp_path, 50.0) as workers:
        assert _outcomes(workers, "a", "b", "c") == [[False, False]] * 3


@pytest.mark.parametrize("confinement", CONFINEMENTS)
def test_a_reader_has_its_own_pipe_alone_and_not_the_memory_of_its_worker(tmp_path, monkeypatch, confinement):
    monkeypatch.setenv(VARIABLE, confinement)
    with run_workers(write_everywhere, tmp_path, 50.0) as workers:
        reached, = _outcomes(workers, "a")
    assert len(reached) == 1 and "memory" not in reached


@pytest.mark.parametrize("confinement", CONFINEMENTS)
@pytest.mark.parametrize("do", [hold_the_pipe, sleep_twice, fork_without_end])
def test_nothing_of_a_reader_outlives_it_or_its_limits(tmp_path, monkeypatch, confinement, do):
    """Of one that may run programs: others cannot make processes at all."""
    monkeypatch.setenv(VARIABLE, confinement)
    workers = _with_programs(tmp_path, do, 600.0 if do is not sleep_twice else 1.0)
    try:
        failed, again = _outcomes(workers, "own session", "x")
        assert type(failed).__name__ == ("TimeoutError" if do is sleep_twice else "WorkerDied")
        assert type(again) is type(failed)
        assert len(_below(tmp_path)) <= 3  # the worker, and bubblewrap
    finally:
        workers.stop()
    time_limit.wait_until(lambda: not _below(tmp_path), "the end of all that was killed", 10)


def _below(folder):
    """Numbers of the processes that have a temporary folder in there."""
    found = []
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # it has ended meanwhile
            is_zombie = (process / "stat").read_text().rpartition(")")[2].split()[0] == "Z"
            if f"TMPDIR={folder}".encode() in (process / "environ").read_bytes() and not is_zombie:
                found.append(int(process.name))
    return found


def test_a_worker_is_alone_when_it_forks():
    """A thread that another process does not get would hold locks there for ever."""
    program = """
import os, sys
from thinpart_workbench.workflow.workers import preparation, reading
reading.start_reader(4096)
preparation.prepare()
assert "MeshPart" in sys.modules
print(os.listdir("/proc/self/task"))
"""
    run = subprocess.run([sys.executable, "-c", program], cwd=SAMPLES.parents[1], capture_output=True, encoding="utf-8",
                         env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    assert run.returncode == 0, run.stderr
    assert len(json.loads(run.stdout.strip().splitlines()[-1].replace("'", '"'))) == 1
