# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pausing, resuming and stopping a run."""

import time

from .errors import Cancelled

_REPORT_INTERVAL = 0.1
"""Seconds between two reports, each of which may be a message to another process."""


class RunControl:
    """The requests to pause or stop a run, which any thread may set, and the state of the run.

    Parameters
    ----------
    on_state_changed : callable, optional
        ``on_state_changed(state)`` with ``searching``, ``running`` or ``paused``; called in the thread of
        the run after the state has changed.
    """

    def __init__(self, on_state_changed=None):
        self.paused = False
        self.stopped = self.is_ending = False
        self._on_state_changed = on_state_changed
        self._state = None
        self._paused_seconds, self._paused_since = 0.0, None

    def pause(self):
        """Start no further files; running ones finish."""
        self.paused = True

    def resume(self):
        """Start files again."""
        self.paused = False

    def stop(self):
        """Stop the run at its next check; safe in a signal handler."""
        self.stopped = True

    def check(self):
        """Raise if the run is to stop; the run calls this often. `is_ending` is true from then on.

        Raises Cancelled if the run was asked to stop.
        """
        if self.stopped:
            self.is_ending = True
            raise Cancelled

    def set_state(self, state):
        """Set the state of the run, and report it if it has changed."""
        if state != self._state:
            self._paused_seconds = self.paused_seconds
            self._paused_since = time.monotonic() if state == "paused" else None
            self._state = state
            if self._on_state_changed is not None:
                self._on_state_changed(state)

    @property
    def paused_seconds(self):
        """float: how long the run was paused, in all."""
        if self._paused_since is None:
            return self._paused_seconds
        return self._paused_seconds + time.monotonic() - self._paused_since


def seldom(report):
    """A function that passes on only some of its calls to another one: ten in a second, and the last of a row of steps.

    Parameters
    ----------
    report : callable or None
        ``report(done, total)``, with numbers of steps; None where nobody wants to know.
    """
    last = [-_REPORT_INTERVAL]

    def step(done, total):
        if report is not None and (done == total or time.monotonic() > last[0] + _REPORT_INTERVAL):
            last[0] = time.monotonic()
            report(done, total)

    return step
