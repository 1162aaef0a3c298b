# SPDX-License-Identifier: LGPL-2.1-or-later
"""Start a module of ThinPart in another process, by a Python or, if there is none, by FreeCADCmd."""

import json
import os
import sys
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
"""The folder that holds the package `thinpart_workbench`."""

RUNNER = CHECKOUT / "thinpart_workbench" / "freecadcmd" / "run_module.py"
RUN_VARIABLE = "THINPART_RUN"
"""Environment variable with the module for RUNNER and its arguments, because FreeCADCmd opens arguments as files."""


def module_command(module, arguments=(), program=None):
    """The command for ``python -m MODULE ARGUMENTS``.

    Returns `command` (list of str; the program comes first) and `variables` (dict; environment variables that have to be
    set).

    Parameters
    ----------
    module : str
    arguments : iterable of str
    program : str, optional
        A Python or FreeCADCmd; by default that of this process.
    """
    program = program or sys.executable
    if is_freecadcmd(program):
        return [program, os.fspath(RUNNER)], {RUN_VARIABLE: json.dumps([module, *arguments])}
    return [program, "-m", module, *arguments], {}


def is_freecadcmd(program):
    """Whether a program is FreeCADCmd, FreeCAD without a window, which runs scripts but is not a Python."""
    return os.path.basename(program).lower().startswith("freecadcmd")
