# SPDX-License-Identifier: LGPL-2.1-or-later
"""A copy of the program that a test may change, and what it answers then."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import thinpart_workbench

TESTS = Path(__file__).resolve().parent


def copied_program(folder):
    """Copy all but the window into a folder, with what it reads; the copied package's folder."""
    package = Path(thinpart_workbench.__file__).parent
    shutil.copytree(package, folder / package.name, ignore=shutil.ignore_patterns("__pycache__", "gui"))
    shutil.copytree(package.parent / "resources" / "profiles", folder / "resources" / "profiles")
    return folder / package.name


def copied_workbench(folder):
    """Copy all that FreeCAD starts as an add-on into a folder; the copied package's folder."""
    package = Path(thinpart_workbench.__file__).parent
    for name in (package.name, "resources"):
        shutil.copytree(package.parent / name, folder / name, ignore=shutil.ignore_patterns("__pycache__", "samples"))
    for name in ("Init.py", "InitGui.py", "package.xml"):
        shutil.copy(package.parent / name, folder)
    return folder / package.name


def answer(package, script):
    """What a script prints that runs with a copied package: str."""
    return printed(package, "-c", script)


def printed(package, *arguments):
    """What Python prints, given these arguments and a copied package: str."""
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join((str(package.parent), str(TESTS))),
                       PYTHONDONTWRITEBYTECODE="1", THINPART_CACHE=str(package.parent / "cache"))
    ran = subprocess.run([sys.executable, *arguments], cwd=package.parent, env=environment,
                         capture_output=True, encoding="utf-8")
    assert ran.returncode == 0, ran.stderr
    return ran.stdout
