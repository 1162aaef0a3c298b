# SPDX-License-Identifier: LGPL-2.1-or-later
"""The definition of the outcome of a file. Responses of workers are checked against it: a malicious file may
control its worker."""

from ...core.errors import KINDS
from ...core.kinds.compound_kinds import Anything, ListOf, MapOf, Record
from ...core.kinds.value_kinds import Flag, Number, OneOf, OrNull, Text
from ...core.record.record_types import FAILURE, PART
from ...storage.info.info_definition import HASH, SOURCE

_SECONDS = Number(0.0)

_LONGEST_PAGE = 100_000_000
"""Greatest number of characters of a page or a table: a page contains its pictures, a table has a row per face."""

_DRAWN = MapOf(Anything(_LONGEST_PAGE))  # pictures that cannot be used do not lose the measurement

_CONFINEMENT = Record({"files": Text(), "network": Text()})

_FAILED = Record({"file": Text(), "error": Record({"kind": OneOf(tuple(KINDS)), "message": Text()})},
                 {"seconds": _SECONDS, "confinement": OrNull(_CONFINEMENT)})

_ANALYSED = Record(
    {"file": Text(), "parts": ListOf(PART, most=1_000_000, distinct="name"), "failures": ListOf(FAILURE, most=1_000_000),
     "reused": Flag(), "seconds": _SECONDS},
    {"sha256": HASH, "faces": MapOf(Text(_LONGEST_PAGE)), "unwritten": Record({"source": SOURCE, "drawn": _DRAWN}),
     "confinement": OrNull(_CONFINEMENT)})


def failure(file, kind, message):
    """The outcome of a file that could not be analysed."""
    return {"file": file, "error": {"kind": kind, "message": message}}


def checked_outcome(task, outcome):
    """The outcome that a worker returned.

    Returns a dict: without what no outcome has: others would take the parts of a file that failed for results. Its ``file``
    is that of the task, whichever file the worker has named. Raises ValueError if it is invalid; the text says why, in a few
    words.

    Parameters
    ----------
    task : FileTask
    outcome : object
        Any JSON value.
    """
    kind = _FAILED if isinstance(outcome, dict) and "error" in outcome else _ANALYSED
    fault = kind.fault(outcome, "")
    if fault is not None:
        raise ValueError(fault)
    return {**{key: value for key, value in outcome.items() if key in kind.kinds}, "file": task.file}


def told_failure(task, outcome):
    """The `failure` of a task that a worker returned, or None if what it returned is none; as `checked_outcome`."""
    return checked_outcome(task, outcome) if _FAILED.holds(outcome) else None
