# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calls of the Windows API that Python has no functions for; used on Windows only."""

import ctypes
from functools import cache

PROCESS_DUPLICATE, PROCESS_SET_INFORMATION = 0x0040, 0x0200
"""Access rights of a process handle (OpenProcess)."""

LIMIT_MEMORY, KILL_WITH_JOB = 0x0100, 0x2000
"""Limit flags of a job: limit the committed memory per process; end its processes when its last handle is closed."""

_EXTENDED_LIMITS = 9
_CLOSE_SOURCE, _SAME_ACCESS = 1, 2
_NO_DIALOGS = 0x0001 | 0x0002  # SEM_FAILCRITICALERRORS, SEM_NOGPFAULTERRORBOX
_BELOW_NORMAL = 0x4000


# `ctypes.wintypes` is not used, because its types have these sizes on Windows only.
_HANDLE, _DWORD, _BOOL = ctypes.c_void_p, ctypes.c_uint32, ctypes.c_int


class _BasicLimits(ctypes.Structure):
    _fields_ = [("process_time", ctypes.c_int64), ("job_time", ctypes.c_int64), ("flags", _DWORD),
                ("least_working_set", ctypes.c_size_t), ("greatest_working_set", ctypes.c_size_t),
                ("processes", _DWORD), ("affinity", ctypes.c_size_t),
                ("priority", _DWORD), ("scheduling", _DWORD)]


class _ExtendedLimits(ctypes.Structure):
    _fields_ = [("basic", _BasicLimits), ("counters", ctypes.c_uint64 * 6),
                ("process_memory", ctypes.c_size_t), ("job_memory", ctypes.c_size_t),
                ("process_peak", ctypes.c_size_t), ("job_peak", ctypes.c_size_t)]


@cache
def _kernel():
    kernel = ctypes.WinDLL("kernel32", use_last_error=True)
    handle, number, yes = _HANDLE, _DWORD, _BOOL
    # Without declared types, ctypes would truncate handles to 32 bits.
    for name, result, arguments in (
            ("CreateJobObjectW", handle, [ctypes.c_void_p, ctypes.c_wchar_p]),
            ("SetInformationJobObject", yes, [handle, ctypes.c_int, ctypes.c_void_p, number]),
            ("AssignProcessToJobObject", yes, [handle, handle]),
            ("GetCurrentProcess", handle, []),
            ("OpenProcess", handle, [number, yes, number]),
            ("DuplicateHandle", yes, [handle, handle, handle, ctypes.c_void_p, number, yes, number]),
            ("CloseHandle", yes, [handle]),
            ("PeekNamedPipe", yes, [handle, ctypes.c_void_p, number, ctypes.c_void_p, ctypes.c_void_p,
                                    ctypes.c_void_p]),
            ("SetPriorityClass", yes, [handle, number]),
            ("SetErrorMode", number, [number])):
        function = getattr(kernel, name)
        function.restype, function.argtypes = result, arguments
    return kernel


def join_new_job(flags, memory=0):
    """Put this process into a job of its own, and get the handle of that: int; raises OSError.

    Parameters
    ----------
    flags : int
    memory : int
        Bytes, for LIMIT_MEMORY.
    """
    kernel = _kernel()
    job = _checked(kernel.CreateJobObjectW(None, None))
    limits = _ExtendedLimits()
    limits.basic.flags, limits.process_memory = flags, memory
    _checked(kernel.SetInformationJobObject(job, _EXTENDED_LIMITS, ctypes.byref(limits),
                                            ctypes.sizeof(limits)))
    _checked(kernel.AssignProcessToJobObject(job, kernel.GetCurrentProcess()))
    return job


def give_handle(handle, process):
    """Move a handle to another process, which does not know of it; it is closed when that process ends.

    Raises OSError if the process no longer exists.

    Parameters
    ----------
    handle : int
    process : int
        Process id.
    """
    kernel = _kernel()
    receiver = _checked(kernel.OpenProcess(PROCESS_DUPLICATE, False, process))
    try:
        given = _HANDLE()
        _checked(kernel.DuplicateHandle(kernel.GetCurrentProcess(), handle, receiver, ctypes.byref(given),
                                        0, False, _SAME_ACCESS | _CLOSE_SOURCE))
    finally:
        kernel.CloseHandle(receiver)


def bytes_in_pipe(handle):
    """Number of bytes that can be read from a pipe at once.

    Raises OSError if the pipe was closed, or the handle is not a pipe.
    """
    count = _DWORD()
    _checked(_kernel().PeekNamedPipe(handle, None, 0, None, ctypes.byref(count), None))
    return count.value


def lower_priority(process):
    """Give a process a priority below normal; raises OSError."""
    kernel = _kernel()
    handle = _checked(kernel.OpenProcess(PROCESS_SET_INFORMATION, False, process))
    try:
        _checked(kernel.SetPriorityClass(handle, _BELOW_NORMAL))
    finally:
        kernel.CloseHandle(handle)


def crash_without_dialog():
    """End this process at a crash without a dialog that waits for an answer."""
    _kernel().SetErrorMode(_NO_DIALOGS)


def _checked(result):
    if not result:
        raise ctypes.WinError(ctypes.get_last_error())
    return result
