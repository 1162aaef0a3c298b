"""The Python that measures beside FreeCAD, and processes in which it can import FreeCAD."""

import os
import sys
from pathlib import Path

import FreeCAD as App

from .. import PACKAGES_VARIABLE
from ..core.errors import ThinPartError
from ..freecad_adapter.additional_packages import package_folders
from ..requirements import FREECAD_MODULES
from ..system.priority import step_back
from ..system.python_process import CHECKOUT, RUN_VARIABLE, module_command
from .qt import QtCore, QtWidgets, disconnect, translate

# What is set for FreeCAD's own Python, or by a user for another one, and misleads this one.
_UNSUITABLE = ("PYTHONSTARTUP", "PYTHONINSPECT", "PYTHONDEBUG", "PYTHONPATH", "PYTHONHOME",
               "PYTHONUNBUFFERED", "PYTHONOPTIMIZE", RUN_VARIABLE)

_LIBRARIES = ("lib", "bin")
"""Where a bundle may have FreeCAD's module: on Linux and macOS; on Windows."""


def python_program():
    """Path of the Python that FreeCAD was built with, or of FreeCADCmd where there is none beside FreeCAD.

    Raises
    ------
    ThinPartError
        kind ``unsupported`` where there is none.

    Notes
    -----
    Inside FreeCAD ``sys.executable`` is FreeCAD itself.
    """
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    home = App.getHomePath()
    folders = (Path(sys.prefix, "bin"), Path(sys.base_prefix, "bin"), Path(sys.prefix),
               Path(home, "bin"), Path(sys.executable).parent)
    # A folder's python3 may be another one than that with the version in its name, so names go first.
    for name in (version, "python3", "python", "python.exe", "freecadcmd", "FreeCADCmd", "FreeCADCmd.exe",
                 "freecadcmd.exe"):
        for folder in folders:
            if os.access(folder / name, os.X_OK) and (folder / name).is_file():
                return os.fspath(folder / name)
    raise ThinPartError(translate(
        "ThinPart", "There is no Python {} beside FreeCAD to measure with: install it."
    ).format(version[6:]), "unsupported")


def python_environment():
    """dict of the environment variables for `python_program`."""
    environment = {name: value for name, value in os.environ.items() if name not in _UNSUITABLE}
    # A bundled FreeCAD points Python to the bundle's own library, and its Python needs that too.
    home = os.environ.get("PYTHONHOME")
    if home and os.path.realpath(home) == os.path.realpath(sys.prefix):
        environment["PYTHONHOME"] = home
    for folder in (os.path.join(App.getHomePath(), each) for each in _LIBRARIES):
        if any(os.path.isfile(os.path.join(folder, module)) for module in FREECAD_MODULES):
            environment.setdefault("FREECAD_LIB", folder)
    environment[PACKAGES_VARIABLE] = os.pathsep.join(package_folders())
    # The folder in which FreeCAD was started may hold a numpy.py.
    environment.update(PYTHONPATH=os.fspath(CHECKOUT), PYTHONSAFEPATH="1",
                       PYTHONDONTWRITEBYTECODE="1", PYTHONUTF8="1")
    # Under a memory limit, OpenBLAS waits for ever for threads whose stacks it cannot have.
    environment.update(OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    return environment


def new_process(parent):
    """QProcess, not yet started, for `python_program`, which steps back behind the window."""
    process = QtCore.QProcess(parent)
    environment = QtCore.QProcessEnvironment()
    for name, value in python_environment().items():
        environment.insert(name, value)
    process.setProcessEnvironment(environment)
    process.started.connect(lambda: _step_back(process))
    return process


def start_module(process, program, module, arguments=()):
    """Start a process of `new_process` with a module.

    Parameters
    ----------
    process : QProcess
    program : str
        See `python_program`.
    module : str
        Its full name.
    arguments : iterable of str
    """
    (program, *given), variables = module_command(module, arguments, program)
    environment = process.processEnvironment()
    for name, value in variables.items():
        environment.insert(name, value)
    process.setProcessEnvironment(environment)
    process.start(program, given)


def listen(process, output, errors, finished, failed):
    """Connect a process.

    Parameters
    ----------
    process : QProcess
    output, errors : callable
        Called when there is something to read on its standard output or error.
    finished : callable
        Takes what ``QProcess.finished`` sends.
    failed : callable
        Takes a ``QProcess.ProcessError``.
    """
    process.readyReadStandardOutput.connect(output)
    process.readyReadStandardError.connect(errors)
    process.finished.connect(finished)
    process.errorOccurred.connect(failed)


def hand_over(process):
    """Nobody listens to a process any more; it may outlive whoever has started it, though not FreeCAD."""
    for signal in (process.readyReadStandardOutput, process.readyReadStandardError, process.finished,
                   process.errorOccurred):
        disconnect(signal)
    process.setParent(QtWidgets.QApplication.instance())


def _step_back(process):
    """The window goes first where there are few processors."""
    number = process.processId()
    if number:  # 0 where it has ended already, and then it would be FreeCAD itself that steps back
        try:
            step_back(number)
        except OSError:
            return  # it has ended meanwhile, which is told elsewhere
