# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart install`` and ``uninstall``: link this checkout into the add-on folders of all installed FreeCADs."""

import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.foreign_text import printable

ROOT = Path(__file__).resolve().parents[3]
NAME = "ThinPart"

_MAY_NOT_LINK = 1314  # Windows: making symbolic links needs a privilege that users do not have


def add_arguments(parser):
    """Declare no options."""


def run(options):
    """Make or remove the links and return the exit status."""
    from ...freecad_adapter.mod_folders import mod_folders

    action = _install if options.command == "install" else _uninstall
    failed, folders = 0, mod_folders()
    for folder in folders:
        try:
            action(folder)
        except ThinPartError as error:
            # An error in one version's folder does not stop the others.
            print(f"thinpart: {printable(error)}", file=sys.stderr)
            failed += 1
    if options.command == "install" and failed < len(folders):
        print(printable(f"FreeCAD reads {ROOT} from there: start it and choose the workbench {NAME}."))
    return 1 if failed else 0


def _install(folder):
    link = folder.path / NAME
    for copy in _copies(folder.path):
        if _leads_to_checkout(copy):
            print(printable(f"{_version_names(folder)}: ThinPart is installed already, {copy}"))
            return
        raise ThinPartError(f"{_version_names(folder)}: {copy} already exists and is not this checkout: remove it "
                            f"{_removal_hint(copy)} and install again.")
    if os.path.lexists(link):
        raise ThinPartError(
            f"{_version_names(folder)}: {link} already exists and is not ThinPart: move it away and install again.")
    try:
        link.parent.mkdir(parents=True, exist_ok=True)
        _make_link(link)
    except OSError as error:
        raise ThinPartError(
            f"{_version_names(folder)}: the link {link} could not be created ({error.strerror}).") from None
    print(printable(f"{_version_names(folder)}: installed, {link}"))


def _uninstall(folder):
    copies = _copies(folder.path)
    for copy in copies:
        if _is_link(copy) and _leads_to_checkout(copy):
            try:
                # Remove the link only, never the tree that it leads to.
                os.unlink(copy)
            except OSError as error:
                raise ThinPartError(
                    f"{_version_names(folder)}: the link {copy} could not be removed ({error.strerror}).") from None
            print(printable(f"{_version_names(folder)}: removed, {copy}"))
    left = [copy for copy in copies if os.path.lexists(copy)]
    if left:
        raise ThinPartError(f"{_version_names(folder)}: not removed, since it is not a link to {ROOT}: " + "; ".join(
            f"{copy} (remove it {_removal_hint(copy)})" for copy in left))
    if not copies:
        print(printable(f"{_version_names(folder)}: ThinPart is not installed, {folder.path}"))


def _copies(mod):
    """Add-ons in a folder that FreeCAD would load as ThinPart, whatever their name, and a broken link of that name."""
    entries = sorted(mod.iterdir()) if mod.is_dir() else []
    return [entry for entry in entries if _is_thinpart(entry) or entry.name == NAME and _is_link(entry)]


def _is_thinpart(folder):
    try:
        name = ElementTree.parse(folder / "package.xml").getroot().find("{*}name")
    except (OSError, ElementTree.ParseError):
        return False  # another kind of add-on, or not a folder
    return name is not None and name.text == NAME


def _leads_to_checkout(path):
    return Path(os.path.realpath(path)) == ROOT


def _is_link(path):
    """Whether a path is a symbolic link or a Windows junction, which not every Python reports as a link."""
    return os.path.realpath(path) != os.path.join(os.path.realpath(path.parent), path.name)


def _make_link(link):
    try:
        link.symlink_to(ROOT, target_is_directory=True)
    except OSError as error:
        if getattr(error, "winerror", None) != _MAY_NOT_LINK:
            raise
        import _winapi  # exists on Windows only

        _winapi.CreateJunction(os.fspath(ROOT), os.fspath(link))


def _version_names(folder):
    words = "FreeCAD {}.{}".format(*folder.version) if folder.version else "FreeCAD up to 1.0"
    if folder.borrower:
        words += ", and {}.{} until it has a folder of its own".format(*folder.borrower)
    return words


def _removal_hint(copy):
    return "by hand" if _is_link(copy) else "in FreeCAD's Addon Manager, or by hand"
