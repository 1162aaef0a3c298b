"""Questions about a path that may lie on another computer, which the window never waits for."""

import queue
import threading
import time

from .qt import QtCore

PATIENCE = 10.0
"""Seconds after which no answer is expected any more."""

_EVERY = 20


def ask_about_path(question, take, parent):
    """Ask in a thread, which ends with FreeCAD also where it waits for a share that is gone.

    Parameters
    ----------
    question : callable
        Without arguments; returns anything but None.
    take : callable
        Called in the window's thread with the answer, or with None when none came in time.
    parent : QObject
        When it goes, the answer is not wanted any more.
    """
    answers, until = queue.SimpleQueue(), time.monotonic() + PATIENCE
    threading.Thread(target=lambda: answers.put(question()), daemon=True).start()
    timer = QtCore.QTimer(parent, interval=_EVERY)

    def look():
        try:
            answer = answers.get_nowait()
        except queue.Empty:
            if time.monotonic() < until:
                return
            answer = None
        timer.stop()
        timer.deleteLater()
        take(answer)

    timer.timeout.connect(look)
    timer.start()
