"""``thinpart install`` and ``uninstall``: links to this checkout among the add-ons of every FreeCAD that is there."""

import os
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from ..core.errors import ThinPartError

ROOT = Path(__file__).resolve().parents[2]
NAME = "ThinPart"

_MAY_NOT_LINK = 1314  # Windows: making symbolic links takes a right that users do not have


def add_arguments(parser):
    """There are no options."""


def run(options):
    """Make or remove the links and return the exit status."""
    from ..freecad_adapter.mod_folders import mod_folders

    do = _install if options.command == "install" else _uninstall
    failed, folders = 0, mod_folders()
    for folder in folders:
        try:
            do(folder)
        except ThinPartError as error:
            # What is wrong with one version's folder leaves the others to be done.
            print(f"thinpart: {error}", file=sys.stderr)
            failed += 1
    if options.command == "install" and failed < len(folders):
        print(f"FreeCAD reads {ROOT} from there: start it and choose the workbench {NAME}.")
    return 1 if failed else 0


def _install(folder):
    link = folder.path / NAME
    for copy in _copies(folder.path):
        if _leads_here(copy):
            print(f"{_readers(folder)}: ThinPart is installed already, {copy}")
            return
        raise ThinPartError(f"{_readers(folder)}: {copy} is there already and not this checkout: remove it "
                            f"{_how(copy)} and install again.")
    if os.path.lexists(link):
        raise ThinPartError(f"{_readers(folder)}: {link} is there already and no ThinPart: move it away and install again.")
    try:
        link.parent.mkdir(parents=True, exist_ok=True)
        _make_link(link)
    except OSError as error:
        raise ThinPartError(f"{_readers(folder)}: the link {link} could not be made ({error.strerror}).") from None
    print(f"{_readers(folder)}: installed, {link}")


def _uninstall(folder):
    copies = _copies(folder.path)
    for copy in copies:
        if _is_link(copy) and _leads_here(copy):
            try:
                # What a link leads to stays; so it is never a tree that is removed here.
                os.unlink(copy)
            except OSError as error:
                raise ThinPartError(
                    f"{_readers(folder)}: the link {copy} could not be removed ({error.strerror}).") from None
            print(f"{_readers(folder)}: removed, {copy}")
    left = [copy for copy in copies if os.path.lexists(copy)]
    if left:
        raise ThinPartError(f"{_readers(folder)}: left as it is, since it is no link to {ROOT}: " + "; ".join(
            f"{copy} (remove it {_how(copy)})" for copy in left))
    if not copies:
        print(f"{_readers(folder)}: ThinPart is not installed, {folder.path}")


def _copies(mod):
    """All that FreeCAD would load as ThinPart from a folder, whatever its name, and a link by our name to what is gone."""
    entries = sorted(mod.iterdir()) if mod.is_dir() else []
    return [each for each in entries if _is_thinpart(each) or each.name == NAME and _is_link(each)]


def _is_thinpart(folder):
    try:
        name = ElementTree.parse(folder / "package.xml").getroot().find("{*}name")
    except (OSError, ElementTree.ParseError):
        return False  # another kind of add-on, or no folder
    return name is not None and name.text == NAME


def _leads_here(path):
    return Path(os.path.realpath(path)) == ROOT


def _is_link(path):
    """Whether it is a symbolic link, or a junction of Windows, which Python does not call a link everywhere."""
    return os.path.realpath(path) != os.path.join(os.path.realpath(path.parent), path.name)


def _make_link(link):
    try:
        link.symlink_to(ROOT, target_is_directory=True)
    except OSError as error:
        if getattr(error, "winerror", None) != _MAY_NOT_LINK:
            raise
        import _winapi  # there on Windows only

        _winapi.CreateJunction(os.fspath(ROOT), os.fspath(link))


def _readers(folder):
    words = "FreeCAD {}.{}".format(*folder.version) if folder.version else "FreeCAD up to 1.0"
    if folder.borrower:
        words += ", and {}.{} until it has a folder of its own".format(*folder.borrower)
    return words


def _how(copy):
    return "by hand" if _is_link(copy) else "in FreeCAD's Addon Manager, or by hand"
