# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compile ThinPart's modules for workers: confined ones cannot keep what they compile, and would do it at every start."""

import os
import sys
from contextlib import suppress
from importlib.machinery import SourceFileLoader
from importlib.util import cache_from_source

from ...system.python_process import CHECKOUT

_NOT_FOR_WORKERS = ("__pycache__", "gui", "window_processes", "freecadcmd", "commands")


def compiled_modules(package=CHECKOUT / "thinpart_workbench"):
    """Compile what is not compiled yet, as Python does when it imports a module; yields after each module.

    Yields a str: the file of a module that has been compiled. Nothing is compiled if the user does not want it
    (``PYTHONDONTWRITEBYTECODE``) or if the folder cannot be written to.

    Parameters
    ----------
    package : Path, optional
    """
    if sys.dont_write_bytecode:
        return
    for folder, folders, names in os.walk(package):
        folders[:] = sorted(name for name in folders if name not in _NOT_FOR_WORKERS)
        for name in names:
            source = os.path.join(folder, name)
            if not name.endswith(".py") or _is_compiled(source):
                continue
            with suppress(OSError, SyntaxError):  # the import tells about it
                SourceFileLoader(name, source).get_code(name)
            if not os.path.exists(cache_from_source(source)):
                return
            yield source


def _is_compiled(source):
    try:
        return os.stat(cache_from_source(source)).st_mtime >= os.stat(source).st_mtime
    except OSError:
        return False
