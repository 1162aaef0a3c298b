# SPDX-License-Identifier: LGPL-2.1-or-later
"""Handle Ctrl-C and similar signals: the first one stops a run at the next safe point, or soon where there is none."""

import signal
import threading
from contextlib import contextmanager

from ..core.errors import Cancelled
from ..system.interruption import STOP_SIGNALS, interrupt_main_thread

PATIENCE = 1.0
"""Seconds after which a run is interrupted that has not come to a safe point: it reads a large profile, or waits for a
share."""


@contextmanager
def interrupting_signals():
    """Context manager in which Ctrl-C, a request to end (SIGTERM) and a closed terminal raise Cancelled."""
    def on_signal(number, frame):
        raise Cancelled

    with _handled(on_signal):
        yield


@contextmanager
def stop_signals(control):
    """Context manager in which Ctrl-C, a request to end (SIGTERM) and a closed terminal stop the run.

    A run checks `control`, a RunControl, between two files, so it prints no half lines. Where it does not come to that
    within `PATIENCE`, it is interrupted wherever it is. A second signal interrupts at once, for example if the disk or the
    reader of a pipe does not respond. Yields a callable: a context manager during which no signal interrupts.
    """
    is_deferred = is_overdue = False
    deadline = None

    def on_signal(number, frame):
        nonlocal deadline, is_overdue
        if not control.stopped:
            control.stop()
            deadline = threading.Timer(PATIENCE, on_deadline, (number,))
            deadline.daemon = True
            deadline.start()
            return
        was_overdue, is_overdue = is_overdue, False
        if is_deferred or was_overdue and control.is_ending:
            return  # it is about to end
        control.is_ending = True
        raise Cancelled

    def on_deadline(number):
        nonlocal is_overdue
        is_overdue = True
        interrupt_main_thread(number)

    @contextmanager
    def undisturbed():
        nonlocal is_deferred
        is_deferred = True
        try:
            yield
        finally:
            is_deferred = False

    with _handled(on_signal):
        try:
            yield undisturbed
        finally:
            if deadline is not None:
                deadline.cancel()


@contextmanager
def _handled(on_signal):
    """Context manager in which a function handles all `STOP_SIGNALS` that are not ignored."""
    before = {}
    for number in STOP_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup and a shell's & ignore signals
            before[number] = signal.signal(number, on_signal)
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
