# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wait for input from a pipe."""

import select
import sys
import time

from . import windows

if sys.platform == "win32":
    import msvcrt

_TICK = 0.02
"""Seconds between two checks of a pipe, on systems that cannot wait for one."""


def is_readable(handle, seconds=None):
    """Whether reading returns at once, because there is input or the pipe was closed.

    Parameters
    ----------
    handle : int
        File descriptor of a pipe.
    seconds : float, optional
        Time to wait for this; by default forever.
    """
    if sys.platform != "win32":
        return bool(select.select([handle], [], [], seconds)[0])
    end = None if seconds is None else time.monotonic() + seconds
    while True:
        try:
            if windows.bytes_in_pipe(msvcrt.get_osfhandle(handle)):
                return True
        except OSError:
            return True  # the pipe was closed, or it is not a pipe: reading reports it
        if end is not None and time.monotonic() >= end:
            return False
        time.sleep(_TICK)
