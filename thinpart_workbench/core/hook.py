# SPDX-License-Identifier: LGPL-2.1-or-later
"""A list of callbacks for an event."""


class Hook:
    """Callbacks for an event. Calling the hook calls them one after the other.

    A callback that fails does not prevent the others from being called. Qt signals are not used because there is no
    Qt below the window, and because they are slower: FreeCAD reports every property of every object.

    Parameters
    ----------
    report : callable, optional
        Called with each exception that a callback raised, once all were called. Without it, the first one is raised.
    """

    def __init__(self, report=None):
        self._callbacks = []
        self._report = report

    def __len__(self):
        return len(self._callbacks)

    def add(self, callback):
        """Add a callback after the existing ones."""
        self._callbacks.append(callback)

    def remove(self, callback):
        """Remove a callback. Raises ValueError if it was not added."""
        self._callbacks.remove(callback)

    def __call__(self, *arguments):
        failures = []
        for callback in tuple(self._callbacks):  # a copy, since callbacks may add or remove some
            try:
                callback(*arguments)
            except Exception as error:  # of any kind, so that the other callbacks are still called
                failures.append(error)
        if failures and self._report is None:
            raise failures[0]
        for failure in failures:
            self._report(failure)
