# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exceptions. Each has a ``kind`` for programs and one sentence for people."""

from .message import message

NO_MEMORY = message("There is not enough memory for this.")
"""Said by a process itself, or by whoever sees it end."""


class ThinPartError(Exception):
    """A failure that is reported as one row: ``kind`` identifies it, the message says what to do.

    Parameters
    ----------
    message : str
        One sentence: what happened, to what, what to do.
    kind : str, optional
        One of the keys of `KINDS`; by default that of the class.
    """

    kind = "failed"

    def __init__(self, message, kind=None):
        super().__init__(message)
        if kind is not None:
            self.kind = kind
        if self.kind not in KINDS:
            raise ValueError(f"unknown kind of failure: {self.kind}")


class MeshError(ThinPartError):
    """The triangles cannot be measured."""

    kind = "unreadable"


class ProfileError(ThinPartError):
    """A profile file is not a valid profile."""

    kind = "profile"


class Cancelled(KeyboardInterrupt):
    """Whoever asked for some work no longer wants it; what was done before is kept.

    `RunControl.check` raises it once the run is to stop, and the command line for Ctrl-C, SIGTERM and a closed terminal. A
    function that is told of progress may raise it too. It is a KeyboardInterrupt, which Ctrl-C raises in other programs: no
    failure of a part, and nothing that an ``except Exception`` takes for one.
    """

    def __init__(self, sentence=message("Stopped on request before the end.")):
        super().__init__(sentence)


KINDS = {
    "cancelled": "stopped on request",
    "cluster": "the cluster cannot be used",
    "crash": "the worker process crashed",
    "empty": "the file or document is empty",
    "failed": "an unexpected error",
    "info_file": "an info file is damaged, foreign or of a newer version",
    "info_write": "the info file could not be written",
    "memory": "the memory limit was reached",
    "missing": "there is no such file",
    "no_shell": "its walls make no shell",
    "no_solid": "there is no closed solid in it",
    "not_finite": "coordinates are not numbers",
    "permission": "no permission to read the file",
    "profile": "the profile is not usable",
    "timeout": "the time limit was reached",
    "unreadable": "the file is damaged or not what its name says",
    "unsafe": "the file is unsafe to open",
    "unsupported": "the format is not supported here",
    "usage": "wrong usage of the command",
    "zero_volume": "the part encloses no volume",
}
