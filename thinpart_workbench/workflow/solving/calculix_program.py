# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX as a program: where it is, and how it ends."""

import os
import re
import shutil
import sys

from ...core.errors import ThinPartError
from ...core.message import message
from ...system.exit_cause import ExitCause
from ...system.process_limits import run_limited

NAMES = ("ccx", "CalculiX", "ccx_static")
"""What the solver is called: by Debian and FreeCAD's bundles, by others."""

TIMEOUT, MEMORY, CRASHED = message("the solver took too long"), message("the solver needed too much memory"), message(
    "the solver crashed")

_VERSION = re.compile(r"Version +(\S+)")
_ERROR_LINE = re.compile(r"^ *\*ERROR:? *(.*(?:\n(?! *\n).*)?)", re.MULTILINE)


def calculix_program(preferred=""):
    """Path of CalculiX, at a preferred path first, and its version, str; raises ThinPartError ``unsupported`` without it."""
    beside = os.path.dirname(sys.executable)
    program = (preferred and shutil.which(preferred)) or next(
        (found for name in NAMES for found in (shutil.which(name), shutil.which(name, path=beside)) if found), None)
    if program is not None:
        try:
            end = run_limited([program, "-v"], 20, os.getcwd())
        except OSError:
            end = None
        found = None if end is None else _VERSION.search(end.text)
        if found is not None:
            return program, found[1]
    raise ThinPartError(message("This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx', elsewhere: "
                                "https://www.calculix.de), and see that 'ccx -v' runs."), "unsupported")


def solve(program, name, seconds, folder):
    """Solve the job of a file ``NAME.inp``, with one thread; its results are files beside it.

    Returns a str: why there is none; empty if there is.

    Parameters
    ----------
    program : str
    name : str
        Without ending.
    seconds : float
        Limit of processor time.
    folder : str
        Working directory.
    """
    end = run_limited([program, name], seconds, folder, {**os.environ, "OMP_NUM_THREADS": "1"})
    if end.timed_out:
        return TIMEOUT
    cause = end.cause()
    if cause is ExitCause.OUT_OF_MEMORY:
        return MEMORY
    if "Job finished" in end.text:
        return ""
    found = _ERROR_LINE.search(end.text)
    return CRASHED if found is None else " ".join(found[1].split())[:200]
