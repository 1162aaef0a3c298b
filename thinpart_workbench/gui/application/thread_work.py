# SPDX-License-Identifier: LGPL-2.1-or-later
"""Work in a thread beside that of the window: arithmetic too long for the window and too short for a process, and paths that
may be on another computer."""

import gc
import queue
import threading
import time

from .qt import QtCore, QtWidgets

PATIENCE = 10.0
"""Seconds after which a path counts as unreachable."""

_POLL_INTERVAL = 20
"""Milliseconds between two looks at a thread."""

_running = 0
"""Threads that are waited for."""


def check_path_in_thread(check, callback, parent=None):
    """Check a path in a thread, so that FreeCAD can quit even while the thread waits for a lost network share.

    Parameters
    ----------
    check : callable
        Without arguments; returns anything but None.
    callback : callable
        Called in the thread of the window with the result, or with None where there was none in time.
    parent : QObject, optional
        See `work_in_thread`.
    """
    work_in_thread(check, lambda found: callback(None if isinstance(found, Exception) else found), parent, PATIENCE)


def work_in_thread(work, done, parent=None, patience=None):
    """Do some work in a thread.

    Parameters
    ----------
    work : callable
        Without arguments; uses nothing of Qt or FreeCAD, and ends.
    done : callable
        Called in the thread of the window with what the work has returned, or with the Exception that it has raised.
    parent : QObject, optional
        Once it is deleted, `done` is not called any more.
    patience : float, optional
        Seconds after which `done` is called with a TimeoutError, while the work goes on in vain.

    Notes
    -----
    Python destroys objects that refer to each other in whichever thread allocates the next one. Timers and widgets that
    are destroyed in another thread than their own crash Qt at its next event, so nothing is collected meanwhile.
    """
    global _running
    results, timer = queue.SimpleQueue(), QtCore.QTimer(QtWidgets.QApplication.instance(), interval=_POLL_INTERVAL)
    end, gone = None if patience is None else time.monotonic() + patience, []
    if parent is not None:
        parent.destroyed.connect(lambda *_: gone.append(True))

    def run():
        try:
            results.put(work())
        except Exception as error:  # handed to the thread of the window, whatever its class
            results.put(error)

    def poll():
        global _running
        if thread.is_alive() and (end is None or time.monotonic() < end):
            return
        timer.stop()
        timer.deleteLater()
        _running -= 1
        if not _running:
            gc.enable()
        if not gone:
            done(TimeoutError() if results.empty() else results.get_nowait())

    thread = threading.Thread(target=run, daemon=True)
    timer.timeout.connect(poll)
    _running += 1
    gc.disable()
    thread.start()
    timer.start()
