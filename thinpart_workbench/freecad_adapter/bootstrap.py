"""Makes FreeCAD importable outside its own program, in the order that it needs."""

import importlib
import os
import sys
from pathlib import Path

from ..core.errors import ThinPartError
from ..requirements import FREECAD_LIBS, freecad_library

_SHARE = ("/usr/share/freecad", "/usr/lib/freecad")


def load_freecad():
    """Import FreeCAD and return its module.

    Raises
    ------
    ThinPartError
        kind ``unsupported`` where there is no FreeCAD for this Python.

    Notes
    -----
    FreeCAD comes first: importing MeshPart before it is a segmentation fault. The folders of its
    modules must be known before a document is opened, or bodies are silently dropped from it.
    """
    if "FreeCAD" in sys.modules:
        return sys.modules["FreeCAD"]
    library = freecad_library()
    for folder in (library, *FREECAD_LIBS):
        if folder:
            _append(folder)
    if library and hasattr(os, "add_dll_directory"):  # Windows looks for what it needs only where it is told to
        os.add_dll_directory(library)
    if not has_home():
        raise ThinPartError(
            f"The home folder {os.path.expanduser('~')} may not be used, which FreeCAD needs: set "
            "FREECAD_USER_HOME to a folder that may.", "permission",
        )
    try:
        freecad = importlib.import_module("FreeCAD")
    except ImportError as error:
        if "failed to map segment" in str(error):
            raise MemoryError(str(error)) from None
        raise ThinPartError(
            f"FreeCAD cannot be imported by {sys.executable} ({error}): "
            "install it (Debian: 'apt-get install freecad') or set FREECAD_LIB to the folder with its FreeCAD.so or "
            "FreeCAD.pyd.",
            "unsupported",
        ) from None
    for home in _homes(freecad):
        _append(home / "Ext")
        # The folder itself too: PartDesign is imported as a package out of it.
        _append(home / "Mod")
        for module in sorted((home / "Mod").glob("*")):
            _append(module)
    return freecad


def _homes(freecad):
    return [Path(freecad.getHomePath()), *map(Path, _SHARE)]


def trusted_code_folders():
    """Folders of Python code that FreeCAD brings, and of its add-ons, list of str; loads FreeCAD."""
    freecad = load_freecad()
    folders = [os.path.dirname(freecad.__file__)]
    for home in _homes(freecad):
        folders += [os.fspath(home / name) for name in ("lib", "Ext", "Mod")]
    folders.append(os.path.join(freecad.getUserAppDataDir(), "Mod"))
    return [folder for folder in folders if os.path.isdir(folder)]


def load_meshing():
    """Import FreeCAD with all that reading and meshing solids takes, which is otherwise loaded by the first part.

    Raises
    ------
    ThinPartError
        See `load_freecad`.
    """
    load_freecad()
    for name in ("Part", "MeshPart"):
        importlib.import_module(name)


def has_home():
    """Whether FreeCAD has a home folder that it can use.

    It ends the process where it may not look into that folder, as under a service's user.
    """
    return "FREECAD_USER_HOME" in os.environ or os.access(
        os.path.expanduser("~"), os.X_OK | os.W_OK
    )


def _append(folder):
    folder = os.fspath(folder)
    if folder not in sys.path and os.path.isdir(folder):
        sys.path.append(folder)
