# SPDX-License-Identifier: LGPL-2.1-or-later
"""A seccomp filter, which permanently forbids a Linux process some system calls.

It covers what Landlock does not: the network, permissions and times of files, and other processes. See seccomp(2).
"""

import ctypes
import errno
import os
import platform
import struct
import sys

from .linux.privileges import set_no_new_privileges
from .linux.system_calls import (
    FIRST_UNKNOWN,
    MACHINES,
    NAMESPACES,
    OTHER_NUMBERS,
    OWN_SETTINGS,
    PROGRAMS,
    REFUSED,
    REFUSED_ARGUMENTS,
    SIGNALS,
    THREAD,
    UNREADABLE,
)

_MODE_FILTER, _ALL_THREADS = 1, 1

_LOAD, _IF_EQUAL, _IF_AT_LEAST, _IF_ANY_BIT, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
"""Instructions of the Berkeley packet filter."""

_NUMBER_AT, _ARCHITECTURE_AT, _FIRST_ARGUMENT_AT, _SECOND_ARGUMENT_AT = 0, 4, 16, 24
"""Offsets in ``struct seccomp_data``; for arguments those of the lower halves, as both machines are little-endian. The
kernel uses no more of the arguments that are compared."""

_ALLOW, _FAIL = 0x7FFF0000, 0x00050000
_REFUSE, _NO_SUCH_CALL = (_RETURN, 0, 0, _FAIL | errno.EPERM), (_RETURN, 0, 0, _FAIL | errno.ENOSYS)
_PASS = (_RETURN, 0, 0, _ALLOW)


def install_system_call_filter(with_programs=False):
    """Forbid this process and its children to open sockets and to affect other processes.

    They cannot change permissions, owners, times and attributes of files either, nor make files in memory. Refused calls
    fail with EPERM, and those that are newer than the filter with ENOSYS. Raises OSError if the filter cannot be installed.

    Parameters
    ----------
    with_programs : bool, optional
        Whether this process may make other processes, such as of programs that it runs; threads it may always make.
    """
    machine = MACHINES.get(platform.machine())
    if machine is None or not sys.platform.startswith("linux") or sys.maxsize < 1 << 32:
        raise OSError(errno.ENOSYS, "no filter for this machine")
    program = b"".join(struct.pack("=HBBI", *line) for line in _program(machine, os.getpid(), with_programs))
    content = ctypes.create_string_buffer(program, len(program))
    filter_program = struct.pack("@HP", len(program) // 8, ctypes.addressof(content))
    set_no_new_privileges()
    library = ctypes.CDLL(None, use_errno=True)
    if library.syscall(ctypes.c_long(machine.seccomp), ctypes.c_uint(_MODE_FILTER), ctypes.c_uint(_ALL_THREADS),
                       filter_program):
        raise OSError(ctypes.get_errno() or errno.EBUSY, "seccomp")


def _program(machine, own, with_programs):
    """The lines of the filter. Each rule is one comparison that either skips the rest of the rule or runs into it."""
    yield from ((_LOAD, 0, 0, _ARCHITECTURE_AT), (_IF_EQUAL, 1, 0, machine.architecture), _REFUSE)
    yield from ((_LOAD, 0, 0, _NUMBER_AT), (_IF_AT_LEAST, 0, 1, OTHER_NUMBERS), _REFUSE)
    yield from ((_IF_AT_LEAST, 0, 1, FIRST_UNKNOWN), _NO_SUCH_CALL)
    rules = {
        **dict.fromkeys(UNREADABLE, (_NO_SUCH_CALL,)),
        **dict.fromkeys(REFUSED if with_programs else REFUSED | PROGRAMS, (_REFUSE,)),
        **dict.fromkeys(SIGNALS, _unless_first_is(own)),
        **dict.fromkeys(OWN_SETTINGS, _unless_first_is(0, own)),
        **{name: _if_second_is(*values) for name, values in REFUSED_ARGUMENTS.items()},
        "clone": _new_process(with_programs),
    }
    for name, lines in rules.items():
        if name in machine.numbers:
            yield (_IF_EQUAL, 0, len(lines), machine.numbers[name])
            yield from lines
    yield _PASS


def _unless_first_is(*values):
    return ((_LOAD, 0, 0, _FIRST_ARGUMENT_AT), *(line for value in values for line in ((_IF_EQUAL, 0, 1, value), _PASS)),
            _REFUSE)


def _if_second_is(*values):
    return ((_LOAD, 0, 0, _SECOND_ARGUMENT_AT), *(line for value in values for line in ((_IF_EQUAL, 0, 1, value), _REFUSE)),
            _PASS)


def _new_process(allowed):
    lines = [(_LOAD, 0, 0, _FIRST_ARGUMENT_AT), (_IF_ANY_BIT, 0, 1, NAMESPACES), _REFUSE]
    return (*lines, _PASS) if allowed else (*lines, (_IF_ANY_BIT, 1, 0, THREAD), _REFUSE, _PASS)
