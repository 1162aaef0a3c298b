# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ctrl-C and the other stop signals of each system."""

import signal
import subprocess
import threading
from contextlib import contextmanager

STOP_SIGNALS = tuple(
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))
"""Signals that ask a program to end. SIGHUP (closed terminal) exists on Unix, SIGBREAK (Ctrl-Break) on Windows."""

IGNORE_CTRL_C = getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0)
"""`creationflags` for a process on Windows that ignores Ctrl-C; on other systems use `without_ctrl_c`."""


@contextmanager
def without_ctrl_c():
    """Context manager: processes and threads started in it never receive Ctrl-C, not even while they start."""
    if not hasattr(signal, "pthread_sigmask"):
        yield  # Windows: see IGNORE_CTRL_C
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def interrupt_main_thread(number):
    """Have the main thread handle one of `STOP_SIGNALS` soon, even where it waits for the system; for another thread."""
    if hasattr(signal, "pthread_kill"):
        signal.pthread_kill(threading.main_thread().ident, number)  # system calls end early
    else:
        signal.raise_signal(number)  # Windows: Python handles it in the main thread all the same
