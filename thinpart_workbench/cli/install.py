"""``thinpart install`` and ``uninstall``: a link to this checkout among FreeCAD's add-ons."""

import os
from pathlib import Path

from ..core.errors import ThinPartError

ROOT = Path(__file__).resolve().parents[2]
NAME = "ThinPart"


def add_arguments(parser):
    """There are no options."""


def run(options):
    """Make or remove the link and return the exit status."""
    link = Path(_user_folder()) / "Mod" / NAME
    return _install(link) if options.command == "install" else _uninstall(link)


def _user_folder():
    from ..freecad_adapter.bootstrap import load_freecad

    return load_freecad().getUserAppDataDir()


def _install(link):
    if _is_ours(link):
        print(f"ThinPart is installed already: {link}")
        return 0
    if os.path.lexists(link):
        raise ThinPartError(
            f"{link} is there already and is no link to {ROOT}: move it away and install again.",
            "usage")
    try:
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(ROOT, target_is_directory=True)
    except OSError as error:
        raise ThinPartError(f"The link {link} could not be made ({error.strerror}).") from None
    print(f"Installed: {link} leads to {ROOT}. Start FreeCAD and choose the workbench ThinPart.")
    return 0


def _uninstall(link):
    if not os.path.lexists(link):
        print(f"ThinPart is not installed: there is no {link}.")
        return 0
    if not _is_ours(link):
        raise ThinPartError(f"{link} is no link to {ROOT}, so it was left as it is.", "usage")
    try:
        link.unlink()
    except OSError as error:
        raise ThinPartError(f"The link {link} could not be removed ({error.strerror}).") from None
    print(f"Removed: {link}. The checkout {ROOT} was left as it is.")
    return 0


def _is_ours(link):
    """Whether it is a link to this checkout, which is what `install` makes."""
    return link.is_symlink() and link.resolve() == ROOT
