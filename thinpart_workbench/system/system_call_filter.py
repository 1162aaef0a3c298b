"""A seccomp filter, which permanently forbids a Linux process some system calls.

It covers what Landlock does not: the network, permissions and times of files, and other processes. See seccomp(2).
"""

import ctypes
import errno
import os
import platform
import struct
import sys

from .landlock import set_no_new_privileges

_MODE_FILTER, _ALL_THREADS = 1, 1

_LOAD, _IF_EQUAL, _IF_AT_LEAST, _RETURN = 0x20, 0x15, 0x35, 0x06
"""Instructions of the Berkeley packet filter."""

_NUMBER_AT, _ARCHITECTURE_AT, _FIRST_ARGUMENT_AT = 0, 4, 16
"""Offsets in ``struct seccomp_data``; for the argument that of its lower half, as both machines are little-endian."""

_ALLOW, _REFUSE = 0x7FFF0000, 0x00050000

_OTHER_NUMBERS = 0x40000000
"""From this number on x86-64 has a second set of its system calls (x32)."""

_MACHINES = {
    # name: audit architecture, number of seccomp, refused calls, calls allowed for this process alone
    "x86_64": (0xC000003E, 317, {
        "socket": 41, "io_uring_setup": 425,
        "chmod": 90, "fchmod": 91, "fchmodat": 268, "fchmodat2": 452,
        "chown": 92, "fchown": 93, "lchown": 94, "fchownat": 260,
        "utime": 132, "utimes": 235, "futimesat": 261, "utimensat": 280,
        "setxattr": 188, "lsetxattr": 189, "fsetxattr": 190, "removexattr": 197, "lremovexattr": 198,
        "fremovexattr": 199, "setxattrat": 463, "removexattrat": 466, "truncate": 76,
        "ptrace": 101, "process_vm_writev": 311, "pidfd_getfd": 438, "pidfd_send_signal": 424, "tkill": 200,
        "rt_sigqueueinfo": 129, "rt_tgsigqueueinfo": 297,
    }, {"kill": 62, "tgkill": 234}),
    "aarch64": (0xC00000B7, 277, {
        "socket": 198, "io_uring_setup": 425,
        "fchmod": 52, "fchmodat": 53, "fchmodat2": 452, "fchownat": 54, "fchown": 55, "utimensat": 88,
        "setxattr": 5, "lsetxattr": 6, "fsetxattr": 7, "removexattr": 14, "lremovexattr": 15, "fremovexattr": 16,
        "setxattrat": 463, "removexattrat": 466, "truncate": 45,
        "ptrace": 117, "process_vm_writev": 271, "pidfd_getfd": 438, "pidfd_send_signal": 424, "tkill": 130,
        "rt_sigqueueinfo": 138, "rt_tgsigqueueinfo": 240,
    }, {"kill": 129, "tgkill": 131}),
}


def install_system_call_filter():
    """Forbid this process and its children to open sockets and to affect other processes.

    They cannot change permissions, owners, times and attributes of files either. Refused calls fail with EPERM.

    Raises
    ------
    OSError
        If the filter cannot be installed.
    """
    machine = _MACHINES.get(platform.machine())
    if machine is None or not sys.platform.startswith("linux") or sys.maxsize < 1 << 32:
        raise OSError(errno.ENOSYS, "no filter for this machine")
    program = _program(machine)
    content = ctypes.create_string_buffer(program, len(program))
    filter_program = struct.pack("@HP", len(program) // 8, ctypes.addressof(content))
    set_no_new_privileges()
    library = ctypes.CDLL(None, use_errno=True)
    if library.syscall(ctypes.c_long(machine[1]), ctypes.c_uint(_MODE_FILTER), ctypes.c_uint(_ALL_THREADS), filter_program):
        raise OSError(ctypes.get_errno() or errno.EBUSY, "seccomp")


def _program(machine):
    """The filter as bytes: per comparison one instruction that either skips the next one or runs into it."""
    architecture, _, refused, own_only = machine
    refuse = (_RETURN, 0, 0, _REFUSE | errno.EPERM)
    lines = [(_LOAD, 0, 0, _ARCHITECTURE_AT), (_IF_EQUAL, 1, 0, architecture), refuse,
             (_LOAD, 0, 0, _NUMBER_AT), (_IF_AT_LEAST, 0, 1, _OTHER_NUMBERS), refuse]
    for number in refused.values():
        lines += [(_IF_EQUAL, 0, 1, number), refuse]
    for number in own_only.values():
        lines += [(_IF_EQUAL, 0, 4, number), (_LOAD, 0, 0, _FIRST_ARGUMENT_AT), (_IF_EQUAL, 1, 0, os.getpid()),
                  refuse, (_RETURN, 0, 0, _ALLOW)]
    lines.append((_RETURN, 0, 0, _ALLOW))
    return b"".join(struct.pack("=HBBI", *line) for line in lines)
