# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker loads once, before it forks a reader for each file: whatever a reader loads is lost with it.

Only code of FreeCAD and ThinPart is loaded, and no file is read, so that no file affects the reader of another one.
"""

import importlib
from contextlib import suppress

from ...freecad_adapter.bootstrap import load_meshing

_MODULES = (
    "..analysis.analyse_part", "..analysis.drawn_part", "..report.report_pages",
    "...core.record.thin_faces", "...core.rendering.picture",
    "...freecad_adapter.reading.part_files", "...freecad_adapter.thin_colours",
)
"""Modules that analysing a file imports when it needs them."""

_is_wanted = False


class Unprepared(BaseException):
    """A forked reader needs what its worker has not loaded yet: the worker loads it and forks another one.

    Not an `Exception`, which would be reported as one of the file.
    """


def want_preparation():
    """In a worker that forks: from now on `require_preparation` raises Unprepared, until `prepare` is called."""
    global _is_wanted
    _is_wanted = True


def require_preparation():
    """Call this before reading a file with FreeCAD.

    Raises Unprepared in a reader that was forked from a worker which is not prepared.
    """
    if _is_wanted:
        raise Unprepared


def prepare():
    """Load FreeCAD and the modules that read and measure parts."""
    global _is_wanted
    _is_wanted = False
    with suppress(Exception):  # whatever FreeCAD raises, the reader meets and reports it
        load_meshing()
        for name in _MODULES:
            importlib.import_module(name, __package__)
