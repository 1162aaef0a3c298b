# SPDX-License-Identifier: LGPL-2.1-or-later
"""bubblewrap, a tool that runs a program with a read-only view of the file system."""

import functools
import os
import shutil
import subprocess

from .interruption import without_ctrl_c

_SECONDS_TO_TRY = 10


def bubblewrap(folder=None):
    """The prefix of a command that confines it to writing into one existing folder, or none, without network: list of str.

    The confined process is not a child of the caller, but still ends with the bwrap process.
    """
    writable = [] if folder is None else ["--bind", folder, folder]
    # Mount /dev before the folder, which may lie in /dev/shm.
    return ["bwrap", "--ro-bind", "/", "/", "--dev", "/dev", "--proc", "/proc", *writable, "--unshare-net", "--unshare-pid",
            "--unshare-ipc", "--die-with-parent", "--new-session", "--"]


@functools.cache
def has_bubblewrap():
    """Whether bubblewrap is installed and allowed here; the result of one attempt is cached."""
    if os.name != "posix" or shutil.which("bwrap") is None:
        return False
    try:
        with without_ctrl_c():
            return not subprocess.run([*bubblewrap(), "true"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                      stderr=subprocess.DEVNULL, timeout=_SECONDS_TO_TRY).returncode
    except (OSError, subprocess.SubprocessError):
        return False
