# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's own limits of walls: the file, and what is known with it."""

import os
from pathlib import Path

from ..core.errors import ThinPartError
from ..core.foreign_text import json_text
from ..core.judging.wall_limits import SHIPPED, chosen_limits, limits_content, read_limits, shipped_limits
from ..core.kinds.file_marks import LIMITS
from ..core.message import message
from ..system.user_folders import settings_home
from .output_file import write_output

NAME = "wall_limits.json"


def user_limits_file():
    """``$THINPART_LIMITS``, else ``thinpart/wall_limits.json`` in the user's folder for settings; may not exist: Path."""
    return Path(os.path.expanduser(os.environ.get("THINPART_LIMITS") or os.path.join(settings_home(), "thinpart", NAME)))


def new_user_limits():
    """`user_limits_file`, made as a copy of the shipped limits where there is none: Path.

    Raises ThinPartError, kind ``failed`` if it cannot be written.
    """
    file = user_limits_file()
    if not os.path.lexists(file):
        _write(file, SHIPPED.read_bytes())
    return file


def _write(file, content):
    try:
        os.makedirs(file.parent, exist_ok=True)
        write_output(file, content, LIMITS)
    except OSError as error:
        raise ThinPartError(message("Your own limits {file} cannot be written ({problem}): make room, or name another file "
                                    "in THINPART_LIMITS.", file=file, problem=error.strerror), "failed") from None


def user_limits():
    """What a user's own limits file has: list of dict, a process each; empty where there is no file.

    Raises ThinPartError, kind ``usage`` if it cannot be used.
    """
    file = user_limits_file()
    return limits_content(file)["processes"] if os.path.lexists(file) else []


def write_user_limits(processes):
    """Write a user's own limits file, and get its path: Path.

    Raises ThinPartError, kind ``usage`` if the file that is there cannot be used, and so is not overwritten; kind ``failed``
    if it cannot be written.

    Parameters
    ----------
    processes : list of dict
        As in the file; `wall_limits.limits_fault` finds nothing wrong with them.
    """
    file = user_limits_file()
    content = {**limits_content(file if os.path.lexists(file) else SHIPPED), "processes": processes}
    _write(file, (json_text(content, indent=2) + "\n").encode())
    return file


def known_limits(file=None):
    """The shipped limits, with a user's own added or put in their place: dict of str to WallLimits.

    See `read_limits`. A process of the user's takes the place of the shipped one with all its materials. Raises
    ThinPartError, kind ``usage`` if the user's file cannot be used.

    Parameters
    ----------
    file : str or Path, optional
        The user's own; by default that of `user_limits_file`, if it exists.
    """
    known = shipped_limits()
    if file is None:
        own_file = user_limits_file()
        if not os.path.lexists(own_file):
            return known
        file = own_file
    own = read_limits(file)
    replaced = {_process(name) for name in own}
    return {**{name: limits for name, limits in known.items() if _process(name) not in replaced}, **own}


def limits_named(names, file=None):
    """The limits that people name: tuple of WallLimits; see `chosen_limits` and `known_limits`.

    No file is read where no name is given.
    """
    names = [name for name in names if name.strip()]
    return chosen_limits(known_limits(file), names) if names else ()


def _process(name):
    return name.partition(":")[0].casefold()
