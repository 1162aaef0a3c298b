# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time that a test may take, and what is said of one that takes longer: where it stands and what it waits for."""

import faulthandler
import os
import signal
import time
import traceback
from contextlib import contextmanager
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent

TEARDOWN_SECONDS = 60
AGAIN_SECONDS = 5
"""Between one try to end a test and the next: the first may hit a function that Qt has called."""
GRACE_SECONDS = 30
"""After them, a test that no exception reaches, since Python does not run, ends all that follow too."""


class TooLong(pytest.fail.Exception):
    """A test has taken longer than it may."""


class _Limit:
    """The one limit that counts, since a process has one alarm."""

    def __init__(self):
        self.name, self.seconds, self.file = "", 0.0, None
        self.told = self.raised = ""
        self.waits = []
        self.look, self.dismiss = (lambda: ""), (lambda: None)


_limit = _Limit()


def stacks_to(file):
    """Where the stacks of all threads go when Python itself hangs: a file or its number."""
    _limit.file = file


def in_window(look, dismiss):
    """How to tell what the window shows, and how to end what waits for a person."""
    _limit.look, _limit.dismiss = look, dismiss


def begin(name, seconds):
    """From now on, the test has some seconds."""
    _limit.name, _limit.seconds, _limit.told, _limit.raised = name, seconds, "", ""
    signal.signal(signal.SIGALRM, _expired)
    signal.setitimer(signal.ITIMER_REAL, seconds, AGAIN_SECONDS)
    if _limit.file is not None:
        faulthandler.dump_traceback_later(seconds + GRACE_SECONDS, exit=True, file=_limit.file)


def end():
    """The test has ended."""
    signal.setitimer(signal.ITIMER_REAL, 0)
    faulthandler.cancel_dump_traceback_later()
    _limit.name = ""


def runs():
    """Whether a test has a limit at the moment."""
    return bool(_limit.name)


def expired():
    """What there is to say of a test that has had its time, or ""."""
    return _limit.told


def untold():
    """What there is to say of a test that has had its time and does not know, or ""; said once."""
    told, _limit.told = _limit.told, ""
    return told


def wait_until(condition, what, seconds=60.0, pause=lambda: time.sleep(0.02)):
    """Wait until something is so, for no longer than the test may take; fail where it never is.

    Parameters
    ----------
    condition : callable
    what : str or callable
        In words what is waited for; asked once it has not come.
    seconds : float
    pause : callable
        Between one look and the next.

    Raises
    ------
    AssertionError
        Says what was waited for and what goes on around.
    """
    what = what if callable(what) else (lambda text=what: text)
    end = time.monotonic() + seconds
    with _waiting_for(what):
        while not condition():
            if expired():
                raise AssertionError(expired())
            if time.monotonic() > end:
                raise AssertionError(f"waited {seconds:g} s for {what()}\n{around()}")
            pause()


@contextmanager
def _waiting_for(what):
    _limit.waits.append(what)
    try:
        yield
    finally:
        _limit.waits.pop()


def _expired(_, frame):
    again = bool(_limit.told)
    if not again:
        _limit.told = _said(frame)
    _limit.dismiss()
    # A wait looks itself, and tells more. An exception might hit what Qt calls meanwhile, and be lost.
    if again or not _limit.waits:
        raise TooLong(_limit.told)


def _said(frame):
    said = [f"{_limit.name} has not ended after {_limit.seconds:g} s."]
    said += [f"It waits for {what()}" for what in _limit.waits[-1:]]
    ours = [each for each in traceback.extract_stack(frame) if Path(each.filename).is_relative_to(HERE)]
    # How a wait works is not what it waits for.
    ours = [each for each in ours if Path(each.filename).name.startswith("test_")] or ours
    said += [f"  {Path(each.filename).relative_to(HERE.parent)}:{each.lineno}: {each.line}" for each in ours[-3:]]
    return "\n".join([*said, around()])


def around():
    """What may have to do with a wait: processes that still run, and what the window shows where there is one."""
    said = [f"Process {number} runs: {command}" for number, command in children()]
    return "\n".join(filter(None, [*said, _limit.look()]))


def children(process=None):
    """(process id, command line) of the processes that one, or this one, has started and that still run."""
    process = os.getpid() if process is None else process
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, parent = stat.read_text(errors="replace").rpartition(")")[2].split()[:2]
            command = (stat.parent / "cmdline").read_text(errors="replace").replace("\0", " ").strip()
        except OSError:
            continue  # it ended while being looked at
        if int(parent) == process and state != "Z":
            yield int(stat.parent.name), command
