"""Ctrl-C and its kin: the first one asks a run to stop where it does no harm."""

import signal
from contextlib import contextmanager

from ..system.interruption import STOP_SIGNALS


@contextmanager
def stop_signals(control):
    """For a ``with`` block: Ctrl-C, a request to end (SIGTERM) and a lost terminal stop the run.

    A run looks at `control` between two files, so no line is printed by half. Whoever does not want to
    wait for that, since the disk or the reader of a pipe does not answer, asks a second time.

    Parameters
    ----------
    control : RunControl

    Yields
    ------
    callable
        A context manager during which nothing interrupts.
    """
    kept = False
    before = {}

    def asked(number, frame):
        if control.stopped and not kept:
            raise KeyboardInterrupt
        control.stop()

    @contextmanager
    def undisturbed():
        nonlocal kept
        kept = True
        try:
            yield
        finally:
            kept = False

    for number in STOP_SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:  # as nohup and a shell's & have it
            before[number] = signal.signal(number, asked)
    try:
        yield undisturbed
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
