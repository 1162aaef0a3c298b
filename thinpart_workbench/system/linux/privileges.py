# SPDX-License-Identifier: LGPL-2.1-or-later
"""Privileges of a Linux process: given up for good, or kept from processes that it forks."""

import ctypes
import errno
import os
import struct

_PR_SET_DUMPABLE, _PR_SET_CHILD_SUBREAPER, _PR_SET_NO_NEW_PRIVS = 4, 36, 38

_CAPABILITIES_VERSION = 0x20080522
_READ_ANY_FILE = 1 << 1 | 1 << 2
"""CAP_DAC_OVERRIDE and CAP_DAC_READ_SEARCH: root reads the files of others, as without confinement."""


def set_no_new_privileges():
    """Prevent this process and its children from gaining privileges by starting a program (no_new_privs); raises OSError.

    Landlock and seccomp both require it.
    """
    _set(_PR_SET_NO_NEW_PRIVS, 1)


def give_up_capabilities():
    """Take away what root may do beyond other users, except for reading files; nothing for other users. Raises OSError."""
    if os.geteuid() != 0:
        return
    library = ctypes.CDLL(None, use_errno=True)
    header = struct.pack("=Ii", _CAPABILITIES_VERSION, 0)
    held = ctypes.create_string_buffer(24)
    if library.capget(header, held):
        raise OSError(ctypes.get_errno(), "capget")
    effective, permitted, *_ = struct.unpack("=6I", held.raw)
    kept = permitted & _READ_ANY_FILE
    if library.capset(header, struct.pack("=6I", effective & kept, kept, 0, 0, 0, 0)):
        raise OSError(ctypes.get_errno() or errno.EPERM, "capset")


def hide_memory(hidden=True):
    """Keep other processes of the user from reading and writing this process's memory; forked ones inherit it.

    Raises OSError.

    Parameters
    ----------
    hidden : bool, optional
        False allows it again.
    """
    _set(_PR_SET_DUMPABLE, int(not hidden))


def adopt_orphans():
    """Become the parent of all processes below this one whose own parents end, so that none is lost; raises OSError."""
    _set(_PR_SET_CHILD_SUBREAPER, 1)


def _set(what, value):
    zero = ctypes.c_ulong(0)
    if ctypes.CDLL(None, use_errno=True).prctl(what, ctypes.c_ulong(value), zero, zero, zero):
        raise OSError(ctypes.get_errno(), "prctl")
