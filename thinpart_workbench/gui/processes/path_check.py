"""Checks of paths that may be on another computer, without blocking the GUI."""

import queue
import threading
import time

from ..application.qt import QtCore

PATIENCE = 10.0
"""Seconds after which a check counts as unanswered."""

_POLL_INTERVAL = 20
"""Milliseconds."""


def check_path_in_thread(check, callback, parent):
    """Run a check in a daemon thread, so that FreeCAD can quit even while the thread waits for a lost network share.

    Parameters
    ----------
    check : callable
        Without arguments; returns anything but None.
    callback : callable
        Called in the GUI thread with the result, or with None when there was none in time.
    parent : QObject
        Once it is deleted, the callback is not called any more.
    """
    results, deadline = queue.SimpleQueue(), time.monotonic() + PATIENCE
    threading.Thread(target=lambda: results.put(check()), daemon=True).start()
    timer = QtCore.QTimer(parent, interval=_POLL_INTERVAL)

    def poll():
        try:
            result = results.get_nowait()
        except queue.Empty:
            if time.monotonic() < deadline:
                return
            result = None
        timer.stop()
        timer.deleteLater()
        callback(result)

    timer.timeout.connect(poll)
    timer.start()
