# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual environment in which the peers live, made on first use."""

import subprocess
from pathlib import Path

from .child_process import Child, ChildError

PACKAGES = {
    "embreex": ("embreex", "numpy"),
    "trimesh": ("trimesh", "embreex", "rtree", "networkx", "scipy"),
    "open3d": ("open3d",),
    "pymeshlab": ("pymeshlab",),
}
"""What pip installs for each peer. One that cannot be installed does not keep out the others."""

INSTALL_LIMIT = 1800.0
"""Seconds."""


def open_peers(folder, pythons, say, names=tuple(PACKAGES)):
    """Start every peer, installing what is missing.

    Parameters
    ----------
    folder : Path
        Of the virtual environment.
    pythons : list of str
        Interpreters to make it with, in the order of preference.
    say : callable
        Told what takes long.
    names : tuple of str
        The peers that are wanted.

    Returns
    -------
    children : dict of str to Child
        The peers that work.
    versions : dict of str to str
    failures : dict of str to str
        One sentence for each of the others.
    """
    python = Path(folder) / "bin" / "python"
    children, versions, failures = {}, {}, {}
    for peer, packages in ((name, PACKAGES[name]) for name in names):
        child = Child(str(python), "peers", peer)
        try:
            if not python.is_file():
                say("making a virtual environment for the peers")
                _make_environment(folder, pythons)
            versions.update(_versions(child, python, peer, packages, say))
            children[peer] = child
        except ChildError as error:
            child.close()
            failures[peer] = str(error)
    return children, versions, failures


def installed_python(folder, pythons, packages, say):
    """Path of the Python of an environment with some packages, which is made where it is missing.

    Parameters
    ----------
    folder, pythons, say
        As of `open_peers`.
    packages : tuple of str

    Raises
    ------
    ChildError
        if they cannot be installed.
    """
    python = Path(folder) / "bin" / "python"
    if not python.is_file():
        say(f"installing {' '.join(packages)}")
        _make_environment(folder, pythons)
        _call([str(python), "-m", "pip", "install", "--quiet", *packages], f"{' '.join(packages)} cannot be installed")
    return python


def _versions(child, python, peer, packages, say):
    try:
        return child.ask("versions")
    except ChildError:
        child.close()
    say(f"installing {' '.join(packages)}")
    _call([str(python), "-m", "pip", "install", "--quiet", *packages], f"{peer} cannot be installed")
    return child.ask("versions")


def _make_environment(folder, pythons):
    for python in pythons:
        try:
            _call([python, "-m", "venv", "--clear", str(folder)],
                  "No virtual environment can be made (on Debian: apt-get install python3-venv)")
            return
        except ChildError as error:
            last = error
    raise last


def _call(command, what):
    try:
        run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                             timeout=INSTALL_LIMIT)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ChildError(f"{what}: {type(error).__name__}.") from None
    if run.returncode:
        lines = [line for line in (run.stderr + run.stdout).splitlines() if line.strip()]
        reason = next((line for line in lines if "error" in line.lower()), lines[-1] if lines else "")
        raise ChildError(f"{what}: {reason.strip()[:200]}")
