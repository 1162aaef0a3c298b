# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find out why a process ended, from its exit code and its last output."""

import enum
import signal
import sys
from dataclasses import dataclass

_MEMORY_SIGNS = (b"bad_alloc", b"bad allocation", b"MemoryError", b"Unable to allocate", b"OutOfMemory",
                 b"out of memory", b"length_error", b"failed to map segment", b"pthread_create failed",
                 b"terminate called without an active exception")
"""Messages of C++, Python, numpy, OCCT, the dynamic linker and OpenBLAS when an allocation fails; the last one is that of
C++ when one of several threads cannot be started."""

_KILL_SIGNALS = {getattr(signal, name).value for name in ("SIGKILL", "SIGTERM", "SIGINT", "SIGHUP")
                 if hasattr(signal, name)}
"""Signals by which a user or another process ends a process. Any other signal means that the process crashed."""

_SHELL_SIGNALS = range(129, 128 + 65)
"""Exit codes of programs such as bubblewrap if a signal ended the program that they ran: 128 plus its number."""

_WINDOWS_FAULTS = range(0xC0000000, 1 << 32)
"""Exit codes of crashed processes on Windows."""

_TERMINATED_BY_QT = 0xF291
"""Exit code of a process that Qt terminated on Windows, which has no signals."""


class ExitCause(enum.Enum):
    """Why a process ended."""

    WELL = "ended well"
    OUT_OF_MEMORY = "out of memory"
    KILLED = "killed"
    CRASHED = "crashed"
    FAILED = "failed"


@dataclass(frozen=True)
class ProcessEnd:
    """How a process ended.

    Attributes
    ----------
    code : int
        Exit code as in `subprocess`: negative for the number of a signal.
    error_output : bytes
        The end of its standard error.
    """

    code: int
    error_output: bytes = b""

    def cause(self, is_done=True):
        """Why the process ended: ExitCause.

        `FAILED` if the process ended by itself with a code other than 0 or before it was done.

        Parameters
        ----------
        is_done : bool, optional
            Whether the process finished its job. If not, the cause is never `WELL`, whatever its exit code.
        """
        if self.code == 0 and is_done:
            return ExitCause.WELL
        if mentions_lack_of_memory(self.error_output):
            return ExitCause.OUT_OF_MEMORY
        return _cause_of(self.code)

    @property
    def text(self):
        """The end of the standard error as text."""
        return self.error_output.decode("utf-8", "replace")


KILLED_END = ProcessEnd(_TERMINATED_BY_QT if sys.platform == "win32" else -signal.SIGKILL.value)
"""The end of a process that was killed and whose exit code was not read."""


def mentions_lack_of_memory(words):
    """Whether the output of a process, bytes, or the text of an exception reports a lack of memory."""
    if isinstance(words, str):
        words = words.encode("utf-8", "replace")
    return any(sign in words for sign in _MEMORY_SIGNS)


def is_out_of_memory(error):
    """Whether an exception was caused by lack of memory; FreeCAD and OCCT have their own exception classes for it."""
    return isinstance(error, MemoryError) or mentions_lack_of_memory(f"{type(error).__name__}: {error}")


def _cause_of(code):
    if sys.platform == "win32":
        if code % (1 << 32) in _WINDOWS_FAULTS:
            return ExitCause.CRASHED
        return ExitCause.KILLED if code == _TERMINATED_BY_QT else ExitCause.FAILED
    number = code - 128 if code in _SHELL_SIGNALS else -code
    if number <= 0:
        return ExitCause.FAILED
    return ExitCause.KILLED if number in _KILL_SIGNALS else ExitCause.CRASHED
