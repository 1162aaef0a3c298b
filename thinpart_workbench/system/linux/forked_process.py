# SPDX-License-Identifier: LGPL-2.1-or-later
"""A forked copy of this process that does one thing, and ends with all processes that it has started."""

import os
import select
import signal
import sys
import time
from contextlib import suppress

from .group_use import is_too_much
from .privileges import adopt_orphans, hide_memory

FORKS = sys.platform.startswith("linux") and hasattr(os, "fork")
"""Whether processes are forked here. A process that uses macOS's own libraries cannot be; Windows has no fork."""

_TICK = 0.1
"""Seconds between two looks at whether a copy has ended, though a process that it has started holds its pipe."""

_SECONDS_BETWEEN_LOOKS = 0.5
"""Seconds between two looks at what the copy and its descendants use together."""

_PATIENCE = 1.0
"""Seconds that a copy has to exit after it has closed its pipe, so that its own exit code is known."""

_CHUNK = 1 << 16


def prepare_to_fork():
    """Prepare this process for forking copies that foreign files may take over, as far as the system lets it."""
    with suppress(OSError):
        adopt_orphans()
    with suppress(OSError):
        hide_memory()


class ForkedProcess:
    """A copy of this process that has begun to run a function; a context manager that ends it.

    The copy leads a process group, which it and its descendants can leave only where nothing confines them. While it runs,
    the signal SIGTERM ends this process as well as the copy.

    Parameters
    ----------
    work : callable
        ``work(output, parent)`` runs in the copy with a binary file, whose content `received` yields, and the process id of
        this process; then the copy exits with the returned exit code.
    inherited : iterable of int
        File descriptors that the copy closes first.
    """

    def __init__(self, work, inherited=()):
        sys.stdout.flush()
        sys.stderr.flush()
        self._receiver, sender = os.pipe()
        self._code = None
        parent, before = os.getpid(), signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})
        try:
            self._number = os.fork()
            if self._number == 0:
                os.close(self._receiver)
                for descriptor in inherited:
                    os.close(descriptor)
                self._run(work, sender, parent, before)
        finally:
            os.close(sender)
        _join_group(self._number)
        signal.signal(signal.SIGTERM, self._on_termination)
        signal.pthread_sigmask(signal.SIG_SETMASK, before)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end(0.0)

    def received(self, requests):
        """Yield what the copy writes, bytes, until it closes its pipe or ends, or uses too much with its descendants.

        Raises EOFError if that pipe is closed: the parent has ended or does not want more.

        Parameters
        ----------
        requests : int
            File descriptor of a pipe from the parent of this process, from which nothing comes before all is received.
        """
        next_look = time.monotonic() + _SECONDS_BETWEEN_LOOKS
        while True:
            has_ended = self._has_ended()
            if not has_ended and time.monotonic() > next_look:
                next_look += _SECONDS_BETWEEN_LOOKS
                has_ended = is_too_much(self._number)
            if has_ended:
                self._kill()  # processes that it has started would keep the pipe open
            readable = select.select([self._receiver, requests], [], [], 0.0 if has_ended else _TICK)[0]
            if requests in readable:
                raise EOFError
            if self._receiver in readable:
                chunk = os.read(self._receiver, _CHUNK)
                if not chunk:
                    return
                yield chunk
            elif has_ended:
                return

    def end(self, patience=_PATIENCE):
        """End the copy and all of its descendants, after some seconds to exit by itself; call it again as you like.

        Returns an int: exit code of the copy, as in `subprocess`.
        """
        if self._receiver is not None:
            os.close(self._receiver)
            self._receiver = None
            until = time.monotonic() + patience
            while not self._has_ended() and time.monotonic() < until:
                time.sleep(0.001)
            self._kill()
            self._reap()
            signal.signal(signal.SIGTERM, signal.SIG_DFL)
        return self._code

    def _has_ended(self):
        if self._code is None:
            number, status = os.waitpid(self._number, os.WNOHANG)
            if number:
                self._code = os.waitstatus_to_exitcode(status)
        return self._code is not None

    def _kill(self):
        try:
            os.killpg(self._number, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has ended, and nobody else is in its group

    def _reap(self):
        """Wait until all of the group have ended: this process has adopted those whose parents ended."""
        if self._code is None:
            self._code = os.waitstatus_to_exitcode(os.waitpid(self._number, 0)[1])
        try:
            while True:
                os.waitpid(-self._number, 0)
        except ChildProcessError:
            return  # none is left

    def _on_termination(self, number, frame):
        self._kill()
        until = time.monotonic() + _PATIENCE
        with suppress(ChildProcessError):  # none is left
            while time.monotonic() < until:  # the kernel may not be able to end one that waits for a share
                if os.waitpid(-self._number, os.WNOHANG)[0] == 0:
                    time.sleep(0.001)
        os._exit(128 + number)

    @staticmethod
    def _run(work, sender, parent, mask):
        """In the copy: never returns."""
        code = 1
        try:
            _join_group(0)
            with suppress(OSError):
                hide_memory(False)
            signal.signal(signal.SIGTERM, signal.SIG_DFL)
            signal.pthread_sigmask(signal.SIG_SETMASK, mask)
            with os.fdopen(sender, "wb") as output:
                code = work(output, parent)
        except BaseException:  # nothing of this process's own code may run in the copy
            sys.excepthook(*sys.exc_info())
        finally:
            sys.stderr.flush()
            os._exit(code)


def _join_group(number):
    """Both processes do this, so that neither goes on before it is done."""
    try:
        os.setpgid(number, number)
    except OSError:
        pass  # the other one was first, and the copy has even ended
