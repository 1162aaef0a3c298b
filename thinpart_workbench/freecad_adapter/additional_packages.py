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
    """list of str: those that FreeCAD searches, in its order, whether or not they are there yet."""
    top = Path(App.getUserAppDataDir()) / "AdditionalPythonPackages"
    version = f"py{sys.version_info.major}{sys.version_info.minor}"
    return [os.fspath(top / version), os.fspath(top), *_of_snap()]


def install_folder():
    """str: where packages for this FreeCAD are installed. FreeCAD 0.20 knows no folders by Python's version."""
    by_version, top, *of_snap = package_folders()
    if of_snap:
        return of_snap[0]
    return by_version if tuple(map(int, App.Version()[:2])) >= (0, 21) else top


def has_package(name):
    """Whether a package can be imported by FreeCAD's Python, also one that was installed since FreeCAD started."""
    importlib.invalidate_caches()
    return importlib.util.find_spec(name) is not None or PathFinder.find_spec(name, package_folders()) is not None


def _of_snap():
    return [site.getusersitepackages()] if os.environ.get("SNAP_REVISION") else []
