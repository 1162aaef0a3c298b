"""Starting a module of ThinPart in another process: by a Python, or by FreeCADCmd where there is none."""

import json
import os
import sys
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
"""The folder to import `thinpart_workbench` from."""

RUNNER = CHECKOUT / "thinpart_workbench" / "freecadcmd" / "run_module.py"
RUN_VARIABLE = "THINPART_RUN"
"""Environment variable that tells RUNNER what to run: FreeCADCmd takes further arguments for files."""


def module_command(module, arguments=(), program=None):
    """What to start for ``python -m MODULE ARGUMENTS``.

    Parameters
    ----------
    module : str
    arguments : iterable of str
    program : str, optional
        A Python, or FreeCADCmd; that of this process where left out.

    Returns
    -------
    command : list of str
        The program comes first.
    variables : dict
        Environment variables that have to be set.
    """
    program = program or sys.executable
    if is_freecadcmd(program):
        return [program, os.fspath(RUNNER)], {RUN_VARIABLE: json.dumps([module, *arguments])}
    return [program, "-m", module, *arguments], {}


def is_freecadcmd(program):
    """Whether a program is FreeCAD without window, which runs scripts but is no Python."""
    return os.path.basename(program).lower().startswith("freecadcmd")
