# SPDX-License-Identifier: LGPL-2.1-or-later
"""The packages that ThinPart needs, in one table for the launcher, the tests and error messages.

The launcher runs this file before every command, so it imports only the standard library, looks for modules without
importing them, and takes a few milliseconds::

    python3 requirements.py COMMAND [ARGUMENTS]    missing packages, one "package<TAB>why" per line
    python3 requirements.py --all COMMAND [SUITE]  the same for all packages that the command needs, as far as a Debian has
                                                   them: trixie, say; by default that of this machine

The result is for the Python that runs this file. The exit status is always 0.
"""

import importlib.util
import os
import sys
from collections import namedtuple

OLDEST_PYTHON = (3, 9)

# Folders of FreeCAD's Python modules on Debian; the environment variable FREECAD_LIB goes first.
FREECAD_LIBS = ("/usr/lib/freecad/lib", "/usr/lib/freecad-python3/lib")


# FreeCAD's own module: on Linux and macOS, and on Windows.
FREECAD_MODULES = ("FreeCAD.so", "FreeCAD.pyd")


def freecad_library():
    """The folder with a FreeCAD module that this Python can load, or None."""
    for folder in (os.environ.get("FREECAD_LIB", ""),) + FREECAD_LIBS:
        for name in FREECAD_MODULES:
            library = os.path.join(folder, name)
            if folder and os.path.isfile(library) and _loads_here(library):
                return folder
    return None


def _loads_here(library):
    # The system's FreeCAD needs the system's Python: the same version from elsewhere (pyenv, conda) would load a
    # second Python runtime into the process and crash it.
    if os.path.realpath(library).startswith("/usr/lib/") and sys.base_prefix != "/usr":
        return False
    with open(library, "rb") as file:
        content = file.read()
    # The library names the Python that it was linked with, or none at all.
    if library.endswith(".pyd"):
        return b"python3%d.dll" % sys.version_info[1] in content.lower()
    return b"libpython3.%d." % sys.version_info[1] in content or b"libpython3." not in content


def _freecad():
    return "FreeCAD" in sys.modules or freecad_library() is not None


def _module(name):
    def found():
        if name in sys.modules:
            return True
        spec = importlib.util.find_spec(name)
        # A removed package may leave an empty folder, which looks like a namespace package without origin.
        return spec is not None and spec.origin is not None

    return found


def _program(name):
    def found():
        folders = os.environ.get("PATH", os.defpath).split(os.pathsep)
        return any(os.access(os.path.join(folder, name), os.X_OK) for folder in folders)

    return found


# Commands that open CAD files, and commands that need info files only.
CAD = ("classify", "report", "map", "duplicates", "size", "gui", "demo", "test")
STORED = (
    "reclassify",
    "learn",
    "find",
    "similar",
    "note",
)
# Commands that ask FreeCAD for the folders of its add-ons.
LINKING = ("install", "uninstall")
RELEASING = ("release",)

Requirement = namedtuple("Requirement", "package why found commands")

# "classify --dask" stands for the command with that option.
TABLE = (
    Requirement("freecad", "reads the CAD files and makes their surface meshes", _freecad, CAD + LINKING),
    Requirement("freecad", "is the window that the workbench runs in", _program("freecad"), ("gui", "test")),
    Requirement("python3-numpy", "does the arithmetic on meshes", _module("numpy"), CAD + STORED + LINKING + RELEASING),
    Requirement("python3-scipy", "finds neighbours, hulls and connected pieces", _module("scipy"), CAD + STORED + LINKING),
    Requirement("python3-sklearn", "fits the probabilities of a profile", _module("sklearn"), ("learn", "test")),
    Requirement("freecad", "reads the CAD files that Gmsh meshes", _freecad,
                ("learn --from-meshing", "learn --from-solver")),
    Requirement("gmsh", "meshes parts, to label them by it and to try element sizes", _program("gmsh"),
                ("learn --from-meshing", "learn --from-solver", "size --check", "size --shell", "test")),
    Requirement("calculix-ccx", "solves parts, to label them by it", _program("ccx"), ("learn --from-solver", "test")),
    Requirement("python3-distributed", "spreads the work over a cluster", _module("distributed"),
                ("classify --dask", "duplicates --dask", "test")),
    Requirement("python3-pytest", "runs the tests", _module("pytest"), ("test",)),
    Requirement("python3-pytest-timeout", "ends a test that hangs", _module("pytest_timeout"), ("test",)),
    Requirement("python3-pytest-xdist", "runs tests on all cores", _module("xdist"), ("test",)),
    Requirement("python3-hypothesis", "makes up cases for the tests", _module("hypothesis"), ("test",)),
    Requirement("python3-jsonschema", "checks info files against their schema", _module("jsonschema"), ("test",)),
    Requirement("bubblewrap", "confines what reads foreign files where the kernel cannot", _program("bwrap"), ("test",)),
    Requirement("xvfb", "is the screen that the window's tests run on", _program("Xvfb"), ("test",)),
    Requirement("git", "makes the tag and the zip", _program("git"), RELEASING),
    Requirement("git", "makes the repositories that FreeCAD's Addon Manager installs from", _program("git"), ("test",)),
    Requirement("python3-git", "lets the Addon Manager of FreeCAD 0.20 use git", _module("git"), ("test",)),
    Requirement("imagemagick", "takes the screenshots", _program("import"), ("test",)),
)


# Packages that a Debian lacks: what needs them says so itself, and its tests are skipped.
LACKING = {"trixie": ("calculix-ccx",)}


def _suite():
    """The code name of this machine's Debian; empty elsewhere."""
    try:
        with open("/etc/os-release", encoding="utf-8") as file:
            lines = file.read().splitlines()
    except OSError:
        return ""
    return next((line.partition("=")[2].strip("\"'") for line in lines if line.startswith("VERSION_CODENAME=")), "")


def required(command, arguments=()):
    """The rows of the table that a command line needs."""
    asked = {command}
    for argument in arguments:
        if argument == "--":
            break
        if argument in ("-h", "--help"):
            return []
        asked.add(command + " " + argument.partition("=")[0])
    return [row for row in TABLE if asked.intersection(row.commands)]


def missing(command, arguments=()):
    """(package, why) of everything that a command line needs and this Python cannot find."""
    rows = [row for row in required(command, arguments) if not row.found()]
    return _packages(rows, _suite()) if rows else []


def _packages(rows, suite):
    reasons = {}
    for row in rows:
        if row.package not in LACKING.get(suite, ()):
            reasons.setdefault(row.package, row.why)
    return list(reasons.items())


def main(arguments):
    if sys.version_info < OLDEST_PYTHON:
        lines = [("python3", "ThinPart needs Python {}.{} or newer".format(*OLDEST_PYTHON))]
    elif arguments[:1] == ["--all"]:
        lines = _packages(required(*arguments[1:2] or [""]), (arguments[2:3] or [_suite()])[0])
    else:
        lines = missing(arguments[0], arguments[1:]) if arguments else []
    for package, why in lines:
        print(package + "\t" + why)


if __name__ == "__main__":
    main(sys.argv[1:])
