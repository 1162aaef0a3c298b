# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that a reader does not come to the end of."""

import fcntl
import os
import signal
from contextlib import contextmanager


def make_endless(path):
    """Make a file of a terabyte that takes no room: whoever reads it is busy for longer than any test."""
    with open(path, "wb") as file:
        file.truncate(1 << 40)


@contextmanager
def held(path):
    """Whoever else opens a file waits for as long as the block lasts, as for a server that is off.

    The system ends it after /proc/sys/fs/lease-break-time, which is 45 s.
    """
    before = signal.signal(signal.SIGIO, signal.SIG_IGN)  # that somebody waits would end this process
    handle = os.open(path, os.O_RDWR | os.O_CREAT, 0o600)
    try:
        fcntl.fcntl(handle, fcntl.F_SETLEASE, fcntl.F_WRLCK)
        yield
    finally:
        os.close(handle)
        signal.signal(signal.SIGIO, before)
