# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folders into which FreeCAD's Addon Manager installs Python packages for add-ons."""

import importlib
import importlib.util
import os
import site
import sys
from importlib.machinery import PathFinder
from pathlib import Path

import FreeCAD as App


def package_folders():
    """list of str: the folders that FreeCAD searches, in its order, including those that do not exist yet."""
    top = Path(App.getUserAppDataDir()) / "AdditionalPythonPackages"
    version = f"py{sys.version_info.major}{sys.version_info.minor}"
    return [os.fspath(top / version), os.fspath(top), *_of_snap()]


def has_package(name):
    """Whether FreeCAD's Python can import a package, even if it was installed after FreeCAD started."""
    importlib.invalidate_caches()
    return importlib.util.find_spec(name) is not None or PathFinder.find_spec(name, package_folders()) is not None


def _of_snap():
    return [site.getusersitepackages()] if os.environ.get("SNAP_REVISION") else []
