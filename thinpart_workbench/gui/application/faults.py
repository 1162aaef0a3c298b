# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports unexpected exceptions in one sentence, so that the user never sees a traceback of ThinPart."""

import sys
import time
import traceback

import FreeCAD as App

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ...freecad_adapter.guard import FAULTS
from . import lifelong
from .qt import translate
from .sentences import translated

_OWN_PREFIX = __name__.partition(".")[0] + "."
_QUIET_SECONDS = 10.0
"""Seconds during which the same fault at the same line is not reported again: it may be in a paint or mouse handler."""

_reported = {}  # time of the last report, by source location and exception type


def report_fault(error):
    """Report an exception in one sentence; its traceback goes to FreeCAD's log, which is hidden by default."""
    lines = "".join(traceback.format_exception(type(error), error, error.__traceback__))
    App.Console.PrintLog(lines.encode("utf-8", "backslashreplace").decode())  # it refuses bytes of file names
    last = traceback.extract_tb(error.__traceback__)[-1:]
    location = [(frame.filename, frame.lineno) for frame in last], type(error)
    now, key = time.monotonic(), str(location)
    if now - _reported.get(key, -_QUIET_SECONDS) >= _QUIET_SECONDS:
        _reported[key] = now
        lifelong.notifications.report_error(fault_sentence(error))


def forget_reported_faults():
    """Report every fault anew, even one that was reported a moment ago."""
    _reported.clear()


def fault_sentence(error):
    """An exception as one readable sentence on one line."""
    if isinstance(error, ThinPartError):
        return translated(error)
    words = translated(problem_of(error, message("the log has its details")))
    return translate(
        "ThinPart", "An unexpected error occurred ({}): try again, and if it happens again, report it with FreeCAD's "
                    "log.").format(words)


def install_fault_handler():
    """Report all unexpected exceptions from now on; called once, when FreeCAD starts.

    Notes
    -----
    Methods that FreeCAD calls are guarded (`freecad_adapter/guard`). Qt calls slots, timers and event handlers, and
    passes what they raise to `sys.excepthook`. The hook turns an exception into a sentence only if Qt or FreeCAD made
    the outermost call: someone who calls ThinPart from the Python console, a macro or a test sees the traceback.
    """
    FAULTS.add(report_fault)
    before = sys.excepthook

    def hook(kind, error, trace):
        if _is_ours(trace) and isinstance(error, Exception):
            report_fault(error.with_traceback(trace))
        else:
            before(kind, error, trace)

    sys.excepthook = hook


def _is_ours(trace):
    """Whether the outermost frame of a traceback is code of ThinPart."""
    # Compare the module's name: FreeCAD spells the paths of modules in its own ways.
    return trace is not None and str(trace.tb_frame.f_globals.get("__name__", "")).startswith(_OWN_PREFIX)
