# SPDX-License-Identifier: LGPL-2.1-or-later
"""Landlock, which permanently takes away a Linux process's right to write outside some folders.

See landlock(7); the constants are from ``linux/landlock.h``.
"""

import ctypes
import errno
import os
import struct
import sys

from .linux.privileges import set_no_new_privileges

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
"""System calls, the same on every architecture."""

_VERSION_FLAG = 1
_PATH_BENEATH = 1

_WRITE_FILE, _TRUNCATE = 1 << 1, 1 << 14

_WRITING = (
    (1, _WRITE_FILE | sum(1 << bit for bit in range(4, 13))),  # remove, and make files, folders, links and devices
    (2, 1 << 13),  # move from folder to folder
    (3, _TRUNCATE),
    (5, 1 << 15),  # ioctl on a device
)
"""Least version of Landlock, and the access rights for writing that it adds."""

_TCP = (4, 0b11)
"""Least version of Landlock, and the rights to bind and to connect."""

_OTHERS = (6, 0b11)
"""Least version of Landlock, and the scopes: abstract sockets of other processes, and signals to them."""

_ALL_THREADS = (8, 1 << 3)
"""Least version of Landlock, and the flag that restricts all threads of the process."""


def landlock_version():
    """Version of the kernel's Landlock, int; 0 if the kernel has none."""
    if not sys.platform.startswith("linux"):
        return 0
    try:
        return max(0, _call(_CREATE_RULESET, None, ctypes.c_size_t(0), ctypes.c_uint32(_VERSION_FLAG)))
    except OSError:
        return 0  # not built in or not enabled


def write_only_below(folders):
    """Restrict this process and its children to writing below some existing folders and to /dev/null.

    Reading is not restricted. The restriction cannot be undone. Raises OSError if that is not possible. Before version 8,
    Landlock restricts a single thread, so the process may have no other.
    """
    version = landlock_version()
    all_threads = _ALL_THREADS[1] if version >= _ALL_THREADS[0] else 0
    if not all_threads and len(os.listdir("/proc/self/task")) > 1:
        raise OSError(errno.EBUSY, "this process has other threads")
    writing = sum(bits for since, bits in _WRITING if version >= since)
    network = _TCP[1] if version >= _TCP[0] else 0
    others = _OTHERS[1] if version >= _OTHERS[0] else 0
    attributes = struct.pack("=QQQ", writing, network, others)
    rules = _call(_CREATE_RULESET, attributes, ctypes.c_size_t(len(attributes)), ctypes.c_uint32(0))
    try:
        for folder in folders:
            _allow(rules, folder, writing)
        _allow(rules, os.devnull, writing & (_WRITE_FILE | _TRUNCATE))
        set_no_new_privileges()
        _call(_RESTRICT_SELF, rules, ctypes.c_uint32(all_threads))
    finally:
        os.close(rules)


def _allow(rules, path, rights):
    handle = os.open(path, os.O_PATH | os.O_CLOEXEC)
    try:
        rule = struct.pack("=Qi", rights, handle)
        _call(_ADD_RULE, rules, ctypes.c_int(_PATH_BENEATH), rule, ctypes.c_uint32(0))
    finally:
        os.close(handle)


def _call(number, *arguments):
    library = ctypes.CDLL(None, use_errno=True)
    library.syscall.restype = ctypes.c_long
    result = library.syscall(ctypes.c_long(number), *arguments)
    if result < 0:
        raise OSError(ctypes.get_errno(), f"system call {number}")
    return result
