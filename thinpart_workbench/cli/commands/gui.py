# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart gui``: start FreeCAD with the workbench from this checkout."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from ...core.errors import ThinPartError
from ...system.user import is_root

ROOT = Path(__file__).resolve().parents[3]
OPEN_WORKBENCH = ROOT / "thinpart_workbench" / "gui" / "activate_workbench.py"
PROGRAMS = ("freecad", "FreeCAD")

# The launcher sets these for its own Python; FreeCAD's Python must not see them.
_OWN = ("PYTHONPATH", "PYTHONSAFEPATH", "PYTHONHOME")


def add_arguments(parser):
    """Declare the options."""
    parser.add_argument("files", nargs="*", metavar="FILE", help="a document to open")


def run(options):
    """Start FreeCAD, wait until it is closed, and return its exit status."""
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        raise ThinPartError(
            "There is no freecad on the PATH: install FreeCAD (Debian: 'apt-get install freecad').",
            "unsupported")
    for file in options.files:
        if not os.path.isfile(file):
            raise ThinPartError(f"There is no file {file}.", "missing")
    if _needs_display() and not os.environ.get("DISPLAY") and not os.environ.get("WAYLAND_DISPLAY"):
        raise ThinPartError("There is no screen here (DISPLAY is not set): FreeCAD cannot open "
                            "its window.", "unsupported")
    environment = {name: value for name, value in os.environ.items() if name not in _OWN}
    if is_root():
        # Otherwise the web engine of FreeCAD's start page ends the whole program for root.
        environment.setdefault("QTWEBENGINE_DISABLE_SANDBOX", "1")
    # Options for FreeCAD have to follow the files: FreeCAD takes leading ones for options of Python.
    files = [os.path.abspath(file) for file in options.files]
    command = [program, os.fspath(OPEN_WORKBENCH), *files, "-M", os.fspath(ROOT)]
    return subprocess.run(command, env=environment, check=False).returncode


def _needs_display():
    """Whether windows need a display server named in the environment, as on Linux."""
    return sys.platform not in ("win32", "darwin")
