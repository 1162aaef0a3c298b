"""Named failures. Each carries a ``kind`` for programs and one sentence for people."""


class ThinPartError(Exception):
    """A failure that is reported as one row: ``kind`` names it, the message says what to do.

    Parameters
    ----------
    message : str
        One sentence: what happened, to what, what to do.
    kind : str, optional
        One of the keys of `KINDS`; the class's own kind when left out.
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
    """A profile file does not say what a profile must say."""

    kind = "profile"


class Cancelled(ThinPartError):
    """The user asked to stop."""

    kind = "cancelled"

    def __init__(self, message="Stopped before the end, as asked."):
        super().__init__(message)


KINDS = {
    "cancelled": "stopped as asked",
    "cluster": "the cluster cannot be used",
    "crash": "the reading process died",
    "empty": "the file or document holds nothing",
    "failed": "an unforeseen failure",
    "info_file": "an info file is damaged, foreign or of a newer version",
    "info_write": "the info file could not be written",
    "memory": "the memory limit was reached",
    "missing": "there is no such file",
    "no_solid": "there is no closed solid in it",
    "not_finite": "coordinates are not numbers",
    "permission": "the file may not be read",
    "profile": "the profile is not usable",
    "timeout": "the time limit was reached",
    "unreadable": "the file is damaged or not what its name says",
    "unsafe": "the file would write where it must not",
    "unsupported": "the format cannot be read here",
    "usage": "the command was called wrongly",
    "zero_volume": "the part encloses no volume",
}
