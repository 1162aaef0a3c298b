"""Ctrl-C and its kin, as far as they are known here."""

import signal
import subprocess
from contextlib import contextmanager

STOP_SIGNALS = tuple(
    getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK") if hasattr(signal, name))
"""How a program is asked to end: a lost terminal is Unix's, Ctrl-Break is Windows's."""

DEAF_TO_CTRL_C = getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0)
"""`creationflags` of a process that does not see Ctrl-C; elsewhere `without_ctrl_c` does that."""


@contextmanager
def without_ctrl_c():
    """Processes and threads that start in this block never see Ctrl-C, not even while they start."""
    if not hasattr(signal, "pthread_sigmask"):
        yield  # Windows: see DEAF_TO_CTRL_C
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)
