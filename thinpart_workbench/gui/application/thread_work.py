"""Work in a thread beside that of the window, for arithmetic too long for the window and too short for a process."""

import gc
import queue
import threading

from .qt import QtCore, QtWidgets

_POLL_INTERVAL = 50
"""Milliseconds between two looks at a thread."""

_running = 0
"""Threads that work."""


def work_in_thread(work, done):
    """Do some work in a thread.

    Parameters
    ----------
    work : callable
        Without arguments; uses nothing of Qt or FreeCAD, and ends.
    done : callable
        Called in the thread of the window with what the work has returned, or with the Exception that it has raised.

    Notes
    -----
    Python destroys objects that refer to each other in whichever thread allocates the next one. Timers and widgets that
    are destroyed in another thread than their own crash Qt at its next event, so nothing is collected meanwhile.
    """
    global _running
    results, timer = queue.SimpleQueue(), QtCore.QTimer(QtWidgets.QApplication.instance(), interval=_POLL_INTERVAL)

    def run():
        try:
            results.put(work())
        except Exception as error:  # handed to the thread of the window, whatever its class
            results.put(error)

    def poll():
        global _running
        if thread.is_alive():
            return
        timer.stop()
        timer.deleteLater()
        _running -= 1
        if not _running:
            gc.enable()
        done(results.get_nowait())

    thread = threading.Thread(target=run, daemon=True)
    timer.timeout.connect(poll)
    _running += 1
    gc.disable()
    thread.start()
    timer.start()
