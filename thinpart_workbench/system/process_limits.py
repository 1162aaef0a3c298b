"""What a process may take, and that it leaves nothing behind when it crashes."""

import sys

from . import windows

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None

MEMORY_CAN_BE_LIMITED = sys.platform != "darwin"
"""macOS refuses a limit of the address space, or takes it and does not hold it."""


def limit_memory(size):
    """Have this process fail to get memory beyond a limit.

    Parameters
    ----------
    size : int
        Bytes: of address space, or on Windows of committed memory.

    Returns
    -------
    bool
        Whether there is such a limit now.
    """
    try:
        if resource is None:
            windows.join_new_job(windows.LIMIT_MEMORY, size)
        else:
            resource.setrlimit(resource.RLIMIT_AS, (size, resource.getrlimit(resource.RLIMIT_AS)[1]))
    except (OSError, ValueError):
        if MEMORY_CAN_BE_LIMITED:
            raise
        return False
    return MEMORY_CAN_BE_LIMITED


def crash_quietly():
    """A crash leaves no file of several GB, and no dialog waits for an answer."""
    if resource is None:
        windows.crash_without_dialog()
    else:
        resource.setrlimit(resource.RLIMIT_CORE, (0, resource.getrlimit(resource.RLIMIT_CORE)[1]))
