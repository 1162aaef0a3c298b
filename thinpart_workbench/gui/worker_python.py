"""The Python that measures beside FreeCAD, and processes in which it can import FreeCAD."""

import os
import sys
from pathlib import Path

import FreeCAD as App

from ..core.errors import ThinPartError
from .qt import QtCore, QtWidgets, translate

CHECKOUT = Path(__file__).resolve().parents[2]

# What is set for FreeCAD's own Python, or by a user for another one, and misleads this one.
_UNSUITABLE = ("PYTHONSTARTUP", "PYTHONINSPECT", "PYTHONDEBUG", "PYTHONPATH", "PYTHONHOME",
               "PYTHONUNBUFFERED", "PYTHONOPTIMIZE")


def python_program():
    """Path of the Python that FreeCAD was built with.

    Raises
    ------
    ThinPartError
        kind ``unsupported`` where there is none.

    Notes
    -----
    Inside FreeCAD ``sys.executable`` is FreeCAD itself.
    """
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    folders = (Path(sys.prefix, "bin"), Path(sys.base_prefix, "bin"), Path(sys.prefix),
               Path(App.getHomePath(), "bin"), Path(sys.executable).parent)
    for name in (version, "python3", "python", "python.exe"):
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
    library = os.path.join(App.getHomePath(), "lib")
    if os.path.isfile(os.path.join(library, "FreeCAD.so")):
        environment.setdefault("FREECAD_LIB", library)
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
        signal.disconnect()
    process.setParent(QtWidgets.QApplication.instance())


def _step_back(process):
    """The window goes first where there are few processors."""
    number = process.processId()
    # 0 where it has ended already, and then it would be FreeCAD itself that steps back.
    if number and hasattr(os, "setpriority"):
        try:
            os.setpriority(os.PRIO_PROCESS, number, 10)
        except ProcessLookupError:
            return  # it has ended meanwhile, which is told elsewhere
