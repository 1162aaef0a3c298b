"""Handle Ctrl-C and similar signals: the first one stops a run at the next safe point."""

import signal
from contextlib import contextmanager

from ..system.interruption import STOP_SIGNALS


@contextmanager
def stop_signals(control):
    """Context manager in which Ctrl-C, a request to end (SIGTERM) and a closed terminal stop the run.

    A run checks `control` between two files, so it prints no half lines. A second signal interrupts at once, for
    example if the disk or the reader of a pipe does not respond.

    Parameters
    ----------
    control : RunControl

    Yields
    ------
    callable
        A context manager during which no signal interrupts.
    """
    is_deferred = False
    before = {}

    def on_signal(number, frame):
        if control.stopped and not is_deferred:
            raise KeyboardInterrupt
        control.stop()

    @contextmanager
    def undisturbed():
        nonlocal is_deferred
        is_deferred = True
        try:
            yield
        finally:
            is_deferred = False

    for number in STOP_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # nohup and a shell's & ignore signals
            before[number] = signal.signal(number, on_signal)
    try:
        yield undisturbed
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
