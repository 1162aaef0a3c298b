# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways in which a process ends, each done by a real one, and what it is to be taken for.

``python -m tests.exit_cases NAME`` ends in one of them.

The same table is for `exit_cause`, for the pool of workers and for the window, so that they agree.
"""

import ctypes
import faulthandler
import os
import signal
import sys
import traceback

if __name__ == "__main__":
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from thinpart_workbench.system.exit_cause import ExitCause
from thinpart_workbench.system.process_limits import crash_quietly, limit_memory

_LIMIT = 1 << 30
"""Bytes of address space; a quarter of it is more than what is running already takes."""

_TOO_MUCH = 1 << 31


def end_as(name):
    """End this process in one of these ways."""
    crash_quietly()
    faulthandler.enable()
    CASES[name][0]()
    sys.stderr.flush()
    os._exit(0)


def _python_memory():
    _exit_with_traceback(lambda: bytearray(_TOO_MUCH))


def _numpy_memory():
    import numpy as np

    _exit_with_traceback(lambda: np.ones(_TOO_MUCH // 8))


def _exit_with_traceback(work):
    limit_memory(_LIMIT)
    try:
        work()
    except MemoryError:
        traceback.print_exc()
        sys.stderr.flush()
        os._exit(1)


def _cpp_memory():
    library = ctypes.CDLL("libstdc++.so.6")
    limit_memory(_LIMIT)
    new = library._Znwm  # operator new(unsigned long)
    new.argtypes = [ctypes.c_ulong]
    new(_TOO_MUCH)


def _cpp_length():
    library = ctypes.CDLL("libstdc++.so.6")
    library._ZSt20__throw_length_errorPKc(b"vector")


def _say_and_fail(words):
    def end():
        os.write(2, words.encode() + b"\n")
        os._exit(1)

    return end


def _signal(number):
    return lambda: os.kill(os.getpid(), number)


def _foreseen_late():
    # What wrote of memory before, and ended well, has ended well.
    os.write(2, b"MemoryError: it was tried again with less\n")


def _fail():
    try:
        raise ValueError("on purpose")
    except ValueError:
        traceback.print_exc()
    sys.stderr.flush()
    os._exit(1)


CASES = {
    "nothing special": (lambda: None, ExitCause.WELL),
    "enough memory in the end": (_foreseen_late, ExitCause.WELL),
    "Python's memory": (_python_memory, ExitCause.OUT_OF_MEMORY),
    "numpy's memory": (_numpy_memory, ExitCause.OUT_OF_MEMORY),
    "C++'s memory": (_cpp_memory, ExitCause.OUT_OF_MEMORY),
    "C++'s length": (_cpp_length, ExitCause.OUT_OF_MEMORY),
    # These three say so and cannot be had at will: OpenBLAS, the dynamic linker and MSVC's library.
    "threads": (_say_and_fail("OpenBLAS blas_thread_init: pthread_create failed for thread 1 of 2"),
                ExitCause.OUT_OF_MEMORY),
    "segments": (_say_and_fail("libTKernel.so: failed to map segment from shared object"), ExitCause.OUT_OF_MEMORY),
    "Windows": (_say_and_fail("RuntimeError: bad allocation"), ExitCause.OUT_OF_MEMORY),
    "killed": (_signal(signal.SIGKILL), ExitCause.KILLED),
    "asked to end": (_signal(signal.SIGTERM), ExitCause.KILLED),
    "segmentation fault": (lambda: ctypes.string_at(0), ExitCause.CRASHED),
    "abort": (os.abort, ExitCause.CRASHED),
    "traceback": (_fail, ExitCause.FAILED),
    "status": (lambda: os._exit(3), ExitCause.FAILED),
}
"""Name of a case: how the process ends, and why it has."""


if __name__ == "__main__":
    end_as(sys.argv[1])
