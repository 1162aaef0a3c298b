"""Waiting for what comes through a pipe."""

import select
import sys
import time

from . import windows

if sys.platform == "win32":
    import msvcrt

_TICK = 0.02
"""Seconds between two looks into a pipe, where the system cannot wait for one."""


def is_readable(handle, seconds=None):
    """Whether reading returns at once, since something came or nothing more will.

    Parameters
    ----------
    handle : int
        Of a pipe.
    seconds : float, optional
        To wait for that; for ever where left out.
    """
    if sys.platform != "win32":
        return bool(select.select([handle], [], [], seconds)[0])
    end = None if seconds is None else time.monotonic() + seconds
    while True:
        try:
            if windows.bytes_in_pipe(msvcrt.get_osfhandle(handle)):
                return True
        except OSError:
            return True  # its end, or no pipe: reading tells
        if end is not None and time.monotonic() >= end:
            return False
        time.sleep(_TICK)
