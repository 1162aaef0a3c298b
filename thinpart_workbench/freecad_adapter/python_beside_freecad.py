# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Python program for worker processes beside FreeCAD, and its environment variables."""

import os
import sys
from pathlib import Path

from .. import PACKAGES_VARIABLE
from ..requirements import FREECAD_MODULES
from ..system.process_limits import run_limited
from ..system.python_process import CHECKOUT, RUN_VARIABLE, is_freecadcmd, module_command

# Variables set for FreeCAD's embedded Python, or by the user for another Python, that would mislead the worker's.
_UNSUITABLE = ("PYTHONSTARTUP", "PYTHONINSPECT", "PYTHONDEBUG", "PYTHONPATH", "PYTHONHOME",
               "PYTHONUNBUFFERED", "PYTHONOPTIMIZE", RUN_VARIABLE)

_LIBRARIES = ("lib", "bin")
"""Folders of a bundle that may hold FreeCAD's module: on Linux and macOS, and on Windows."""


def is_within_freecad():
    """Whether this process is FreeCAD's program with a window, so that ``sys.executable`` is FreeCAD itself."""
    name = os.path.basename(sys.executable or "").lower()
    return "FreeCAD" in sys.modules and name.startswith("freecad") and not is_freecadcmd(name)


def python_beside_freecad():
    """Path of the Python that FreeCAD was built with, else of FreeCADCmd; None if neither exists."""
    import FreeCAD

    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    folders = (Path(sys.prefix, "bin"), Path(sys.base_prefix, "bin"), Path(sys.prefix),
               Path(FreeCAD.getHomePath(), "bin"), Path(sys.executable).parent)
    # A python3 may be another version than the program with the version in its name, so try each name everywhere first.
    for name in (version, "python3", "python", "python.exe", "freecadcmd", "FreeCADCmd", "FreeCADCmd.exe",
                 "freecadcmd.exe"):
        for folder in folders:
            if os.access(folder / name, os.X_OK) and (folder / name).is_file():
                return os.fspath(folder / name)
    return None


def run_module_limited(module, arguments, seconds, folder):
    """Run a module of ThinPart in another process with a limit of time: OCC cannot be interrupted, a process can.

    Returns a ProgramEnd or None: None where there is no Python to run it.

    Parameters
    ----------
    module : str
    arguments : list of str
    seconds : float
        Of processor time.
    folder : str
        Working directory.
    """
    program, environment = None, dict(os.environ)
    if is_within_freecad():
        program, environment = python_beside_freecad(), python_environment()
        if program is None:
            return None  # FreeCAD itself would open another window
    path = os.pathsep.join(filter(None, (os.fspath(CHECKOUT), environment.get("PYTHONPATH"))))
    command, variables = module_command(module, arguments, program)
    return run_limited(command, seconds, folder, {**environment, **variables, "PYTHONPATH": path})


def python_environment():
    """dict of the environment variables for `python_beside_freecad`."""
    import FreeCAD

    from .additional_packages import package_folders

    environment = {name: value for name, value in os.environ.items() if name not in _UNSUITABLE}
    # A bundled FreeCAD sets PYTHONHOME to the bundle's own library, which its Python needs too.
    home = os.environ.get("PYTHONHOME")
    if home and os.path.realpath(home) == os.path.realpath(sys.prefix):
        environment["PYTHONHOME"] = home
    for folder in (os.path.join(FreeCAD.getHomePath(), name) for name in _LIBRARIES):
        if any(os.path.isfile(os.path.join(folder, module)) for module in FREECAD_MODULES):
            environment.setdefault("FREECAD_LIB", folder)
    environment[PACKAGES_VARIABLE] = os.pathsep.join(package_folders())
    # The folder in which FreeCAD was started may hold a numpy.py.
    environment.update(PYTHONPATH=os.fspath(CHECKOUT), PYTHONSAFEPATH="1",
                       PYTHONDONTWRITEBYTECODE="1", PYTHONUTF8="1")
    # Under a memory limit, OpenBLAS waits forever for threads whose stacks cannot be allocated.
    environment.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    return environment
