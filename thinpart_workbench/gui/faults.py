"""What nobody foresaw, told in one sentence: no traceback of ThinPart reaches the user."""

import sys
import time
import traceback

import FreeCAD as App

from ..core.errors import ThinPartError
from ..freecad_adapter.edge import on_fault
from .notices import NOTICES
from .qt import translate
from .sentences import translated

_OURS = __name__.partition(".")[0] + "."
_QUIET = 10.0
"""Seconds for which the same fault at the same place is not told again: it may be in what is drawn or moved."""

_told = {}  # when, by the place in the code


def tell_fault(error):
    """Say in one sentence what was raised; the traceback goes to FreeCAD's log, which is hidden by default."""
    App.Console.PrintLog("".join(traceback.format_exception(type(error), error, error.__traceback__)))
    last = traceback.extract_tb(error.__traceback__)[-1:]
    place = [(each.filename, each.lineno) for each in last], type(error)
    now, key = time.monotonic(), str(place)
    if now - _told.get(key, -_QUIET) >= _QUIET:
        _told[key] = now
        NOTICES.complain(fault_sentence(error))


def forget_told():
    """Tell again what was told just now."""
    _told.clear()


def fault_sentence(error):
    """What an exception is to people: one sentence, one line."""
    if isinstance(error, ThinPartError):
        return translated(error)
    words = " ".join(f"{type(error).__name__}: {error}".split())
    return translate(
        "ThinPart", "This did not work, for a reason that was not foreseen ({}): try again, and if it happens "
        "again, report it with FreeCAD's log.").format(words if len(words) <= 200 else words[:200] + "\u2026")


def tell_faults():
    """Tell what ends at an edge from now on; called once, when FreeCAD starts.

    Notes
    -----
    What FreeCAD calls is guarded (`freecad_adapter.edge`). Slots, timers and events are called by Qt, which gives
    `sys.excepthook` what they raise. There, only what was called by Qt or FreeCAD itself ends in a sentence:
    whoever calls ThinPart from the Python console, a macro or a test sees the traceback.
    """
    on_fault(tell_fault)
    before = sys.excepthook

    def hook(kind, error, trace):
        if _is_ours(trace) and isinstance(error, Exception):
            tell_fault(error.with_traceback(trace))
        else:
            before(kind, error, trace)

    sys.excepthook = hook


def _is_ours(trace):
    """Whether the first that was called is code of ThinPart."""
    # By the module's name: FreeCAD writes paths of modules in ways of its own.
    return trace is not None and str(trace.tb_frame.f_globals.get("__name__", "")).startswith(_OURS)
