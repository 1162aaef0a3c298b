# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make FreeCAD importable outside its own program, in the order that it needs."""

import importlib
import os
import sys
from pathlib import Path

from ..core.errors import ThinPartError
from ..core.message import message
from ..requirements import FREECAD_LIBS, freecad_library

_SHARE = ("/usr/share/freecad", "/usr/lib/freecad")


def load_freecad():
    """Import FreeCAD and return its module.

    Raises ThinPartError, kind ``unsupported`` if there is no FreeCAD for this Python, ``permission`` if the home folder
    cannot be used.

    FreeCAD is imported first, because importing MeshPart before it causes a segmentation fault. The folders of its
    modules must be on the module path before a document is opened, or FreeCAD silently drops bodies from it.
    """
    if "FreeCAD" in sys.modules:
        return sys.modules["FreeCAD"]
    library = freecad_library()
    for folder in (library, *FREECAD_LIBS):
        if folder:
            _append(folder)
    if library and hasattr(os, "add_dll_directory"):  # Windows searches for DLLs in registered folders only
        os.add_dll_directory(library)
    if not has_home():
        raise ThinPartError(
            message("FreeCAD needs a home folder, but {folder} is not accessible: set FREECAD_USER_HOME to a folder "
                    "that is.", folder=os.path.expanduser("~")), "permission",
        )
    # MeshPart brings UCX along, a library of MPI, which takes half a second to watch all memory. Nothing here needs that.
    os.environ.setdefault("UCX_MEM_EVENTS", "n")
    try:
        freecad = importlib.import_module("FreeCAD")
    except ImportError as error:
        if "failed to map segment" in str(error):
            raise MemoryError(str(error)) from None
        raise ThinPartError(
            message("FreeCAD cannot be imported by {program} ({problem}): install it (Debian: 'apt-get install "
                    "freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or FreeCAD.pyd.",
                    program=sys.executable, problem=error),
            "unsupported",
        ) from None
    for home in _homes(freecad):
        _append(home / "Ext")
        # The folder itself too, because PartDesign is imported from it as a package.
        _append(home / "Mod")
        for module in sorted((home / "Mod").glob("*")):
            _append(module)
    return freecad


def _homes(freecad):
    return [Path(freecad.getHomePath()), *map(Path, _SHARE)]


def trusted_code_folders():
    """Folders of the Python code of FreeCAD and its add-ons, list of str; loads FreeCAD."""
    freecad = load_freecad()
    folders = [os.path.dirname(freecad.__file__)]
    for home in _homes(freecad):
        folders += [os.fspath(home / name) for name in ("lib", "Ext", "Mod")]
    folders.append(os.path.join(freecad.getUserAppDataDir(), "Mod"))
    return [folder for folder in folders if os.path.isdir(folder)]


def load_meshing():
    """Import FreeCAD and the modules for reading and meshing solids, which otherwise load with the first part.

    Raises ThinPartError: see `load_freecad`.
    """
    load_freecad()
    for name in ("Part", "MeshPart"):
        importlib.import_module(name)


def has_home():
    """Whether FreeCAD has a home folder that it can use.

    FreeCAD ends the process if it may not access that folder, for example under a service account.
    """
    return "FREECAD_USER_HOME" in os.environ or os.access(
        os.path.expanduser("~"), os.X_OK | os.W_OK
    )


def _append(folder):
    folder = os.fspath(folder)
    if folder not in sys.path and os.path.isdir(folder):
        sys.path.append(folder)
