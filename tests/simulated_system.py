# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes this process look like one on Windows or macOS, as far as Python shows the difference.

Only what ThinPart asks for is another: the names that `os`, `signal` and `select` have, the modules that are
there, and Windows's own calls, which `FakeKernel` and `FakeMsvcrt` answer. The standard library, numpy and
scipy are imported before, and go on as on this system.
"""

import ctypes
import importlib.abc
import os
import pkgutil
import select
import signal
import sys
import types

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

UNIX_MODULES = ("fcntl", "resource", "pwd", "grp", "termios", "tty", "pty", "syslog", "readline")
UNIX_NAMES = {
    os: ("fork", "forkpty", "getuid", "geteuid", "getgid", "getegid", "getpgid", "setpgid", "killpg", "setsid",
         "getpriority", "setpriority", "nice", "mkfifo", "chown", "lchown", "fchmod", "fchown", "uname", "sysconf",
         "statvfs", "getloadavg", "sched_getaffinity", "wait3", "wait4", "WIFEXITED", "O_NOFOLLOW", "O_NONBLOCK",
         "O_DIRECTORY", "O_CLOEXEC", "PRIO_PROCESS", "register_at_fork", "posix_spawn", "ctermid", "initgroups"),
    signal: ("SIGHUP", "SIGKILL", "SIGALRM", "SIGCHLD", "SIGUSR1", "SIGUSR2", "SIGPIPE", "SIGSTOP", "SIGCONT",
             "pthread_sigmask", "SIG_BLOCK", "SIG_SETMASK", "SIG_UNBLOCK", "alarm", "setitimer", "sigwait"),
    select: ("poll", "epoll", "kqueue", "kevent"),
}
LINUX_NAMES = {select: ("epoll",), os: ("sched_getaffinity", "posix_fadvise", "fdatasync")}


class _Hidden(importlib.abc.MetaPathFinder):
    """Some modules cannot be imported."""

    def __init__(self, names):
        self._names = names

    def find_spec(self, fullname, path=None, target=None):
        if fullname in self._names:
            raise ModuleNotFoundError(f"No module named {fullname!r}", name=fullname)


def use(system):
    """Be ``win32`` or ``darwin`` from now on."""
    _import_what_others_bring()
    if system == "win32":
        hidden, names = UNIX_MODULES, UNIX_NAMES
        _add_windows()  # first: it goes on with what is hidden then
    else:
        hidden, names = (), LINUX_NAMES
        _add_macos()
    for name in hidden:
        sys.modules.pop(name, None)
    sys.meta_path.insert(0, _Hidden(hidden))
    for module, gone in names.items():
        for name in gone:
            if hasattr(module, name):
                delattr(module, name)
    sys.platform = system
    # os.name stays: pathlib and subprocess would make Windows's paths and processes of it.


def modules():
    """Names of all modules of ThinPart that need no FreeCAD, no Qt and no Dask to be imported."""
    import thinpart_workbench

    for each in pkgutil.walk_packages(thinpart_workbench.__path__, "thinpart_workbench."):
        if not each.name.startswith(("thinpart_workbench.gui.", "thinpart_workbench.freecadcmd")) and (
                each.name not in ("thinpart_workbench.__main__", "thinpart_workbench.workflow.cluster.cluster_worker",
                                  "thinpart_workbench.freecad_adapter.additional_packages")):
            yield each.name


def _import_what_others_bring():
    import asyncio  # noqa: F401
    import concurrent.futures.process  # noqa: F401
    import multiprocessing.pool
    import multiprocessing.synchronize  # noqa: F401
    import sqlite3  # noqa: F401
    import subprocess  # noqa: F401
    import tempfile  # noqa: F401
    import uuid  # noqa: F401
    import webbrowser  # noqa: F401

    import scipy.ndimage
    import scipy.optimize
    import scipy.sparse
    import scipy.spatial  # noqa: F401


class FakeMsvcrt(types.ModuleType):
    """Locks like Windows: one process, one handle, and a second one is refused."""

    LK_LOCK, LK_NBLCK, LK_UNLCK = 1, 2, 0

    def __init__(self):
        super().__init__("msvcrt")
        self.calls = []
        self._fcntl = __import__("fcntl")

    def locking(self, handle, mode, size):
        self.calls.append((handle, mode, size, os.lseek(handle, 0, os.SEEK_CUR)))
        assert size == 1
        try:
            self._fcntl.flock(handle, self._fcntl.LOCK_EX | self._fcntl.LOCK_NB)
        except BlockingIOError:
            raise PermissionError(13, "Permission denied") from None

    @staticmethod
    def get_osfhandle(handle):
        return handle


class FakeKernel:
    """Windows's calls that ThinPart uses; `calls` has those that were made."""

    def __init__(self):
        self.calls = []
        self.pipes = {}  # handle: bytes that wait in it, or None where its other end is closed
        self.processes = {os.getpid()}

    def __getattr__(self, name):
        function = _Function(lambda *arguments: self._call(name, arguments))
        setattr(self, name, function)
        return function

    def named(self, name):
        """Arguments of the calls of one function."""
        return [arguments for called, arguments in self.calls if called == name]

    def _call(self, name, arguments):
        self.calls.append((name, arguments))
        if name == "OpenProcess":
            return 4000 if arguments[2] in self.processes else 0
        if name == "PeekNamedPipe":
            waiting = self.pipes.get(arguments[0])
            if waiting is None:
                return 0
            ctypes.cast(arguments[4], ctypes.POINTER(ctypes.c_uint32))[0] = waiting
        return {"CreateJobObjectW": 3000, "GetCurrentProcess": 2 ** 64 - 1}.get(name, 1)


class _Function:
    def __init__(self, call):
        self._call = call
        self.restype = self.argtypes = None

    def __call__(self, *arguments):
        # Without types, a handle of 64 bits would be cut.
        assert self.argtypes is not None and len(self.argtypes) == len(arguments) and self.restype is not None
        return self._call(*arguments)


KERNEL = FakeKernel()


def _add_windows():
    import shutil
    import subprocess

    # The standard library chose these by what was there when it was imported.
    shutil._use_fd_functions = False
    if hasattr(shutil, "_rmtree_unsafe"):
        shutil._rmtree_impl = shutil._rmtree_unsafe
    subprocess._USE_POSIX_SPAWN = subprocess._USE_VFORK = False

    sys.modules["msvcrt"] = FakeMsvcrt()
    ctypes.WinDLL = lambda name, use_last_error: {"kernel32": KERNEL}[name]
    ctypes.get_last_error = lambda: 5
    ctypes.WinError = lambda code: OSError(13, f"Windows says {code}")
    subprocess.CREATE_NEW_PROCESS_GROUP = 0x200
    kill = signal.SIGKILL
    subprocess.Popen.kill = lambda process: process.poll() is None and os.kill(process.pid, kill)
    signal.SIGBREAK = 21


def _add_macos():
    import resource

    def refused(kind, limits):
        if kind == resource.RLIMIT_AS:
            raise ValueError("current limit exceeds maximum limit")
        return setrlimit(kind, limits)

    setrlimit, resource.setrlimit = resource.setrlimit, refused
    select.kqueue, select.kevent = FakeQueue, lambda *arguments: arguments
    select.KQ_FILTER_PROC, select.KQ_EV_ADD, select.KQ_NOTE_EXIT = -5, 1, 2 ** 31


class FakeQueue:
    """kqueue as far as it tells the end of a process."""

    def control(self, events, most):
        import time

        (number, kind, action, note), = events
        assert (kind, action, note, most) == (-5, 1, 2 ** 31, 1)
        while True:
            try:
                os.kill(number, 0)
            except ProcessLookupError:
                raise OSError(3, "No such process") from None
            try:
                with open(f"/proc/{number}/stat") as file:
                    if file.read().rpartition(")")[2].split()[0] == "Z":
                        return events
            except OSError:
                return events
            time.sleep(0.05)
