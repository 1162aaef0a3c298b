"""What the outside asks of a run under way: to pause, to go on, to stop."""


class RunControl:
    """Wishes, which any thread may set, and the state that the run is in because of them.

    Parameters
    ----------
    announce : callable, optional
        ``announce(state)`` with ``searching``, ``running`` or ``paused``; called from the thread that
        runs, once the state holds.
    """

    def __init__(self, announce=None):
        self.paused = False
        self.stopped = False
        self._announce = announce
        self._state = None

    def pause(self):
        """No further file is begun; those at work end."""
        self.paused = True

    def resume(self):
        """Files are begun again."""
        self.paused = False

    def stop(self):
        """The run ends as soon as it looks; safe in a signal handler."""
        self.stopped = True

    def check(self):
        """To be called often by the run.

        Raises
        ------
        KeyboardInterrupt
            When the run was asked to stop: as Ctrl-C would, for that is what it stands for.
        """
        if self.stopped:
            raise KeyboardInterrupt

    def enter(self, state):
        """The run is in this state now; it is announced when it was in another one."""
        if state != self._state:
            self._state = state
            if self._announce is not None:
                self._announce(state)
