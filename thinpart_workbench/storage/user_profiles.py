# SPDX-License-Identifier: LGPL-2.1-or-later
"""A user's own profiles: their folder, and writing one."""

import os
from contextlib import contextmanager
from pathlib import Path

from ..core.errors import ThinPartError
from ..core.foreign_text import json_text
from ..core.judging.criteria import PROFILES
from ..core.kinds.file_marks import PROFILE
from ..core.message import message
from ..system.user_folders import settings_home
from .output_file import ForeignFile, check_output, write_output


def user_profiles_folder():
    """``$THINPART_PROFILES``, else ``thinpart/profiles`` in the user's folder for settings; may not exist: Path."""
    return Path(os.path.expanduser(
        os.environ.get("THINPART_PROFILES") or os.path.join(settings_home(), "thinpart", "profiles")))


def user_profiles():
    """The files in that folder, by name: list of Path. Whether they are profiles is not looked at."""
    try:
        return sorted(path for path in user_profiles_folder().iterdir() if path.suffix == ".json" and os.path.isfile(path))
    except OSError:
        return []  # there is none, or it cannot be read now


def check_profile_file(file, overwrite=False, inputs=()):
    """Check that a profile may be written to a file, as `check_output`; makes a missing folder of the user's own profiles.

    Raises ForeignFile if the file is no profile, and `overwrite` would allow it. Raises ThinPartError, kind ``usage`` if it
    has the name of a shipped profile, which would be taken for that, or must not be written; kind ``failed`` if it cannot be
    written.
    """
    shipped = {path.stem.casefold() for path in PROFILES.glob("*.json")}
    if Path(file).stem.casefold() in shipped:
        raise ThinPartError(message("{file} would have the name of a profile that comes with ThinPart: choose another.",
                                    file=os.fspath(file)), "usage")
    with _writing(file):
        if Path(os.path.abspath(file)).parent == user_profiles_folder():
            os.makedirs(user_profiles_folder(), exist_ok=True)
        check_output(file, PROFILE, overwrite, inputs)


def write_profile(content, file, overwrite=False, inputs=()):
    """Write the content of a profile, dict, atomically, where `check_profile_file` lets it; raises the same."""
    check_profile_file(file, overwrite, inputs)
    text = json_text(content, indent=2) + "\n"
    with _writing(file):
        write_output(file, text.encode(), PROFILE, overwrite, inputs)


@contextmanager
def _writing(file):
    try:
        yield
    except ForeignFile:
        raise ForeignFile(message("{file} is no profile and is not overwritten: write the new profile elsewhere.",
                                  file=os.fspath(file)), "usage") from None
    except OSError as error:
        raise ThinPartError(message("The profile {file} could not be written ({problem}): choose another place for it.",
                                    file=os.fspath(file), problem=error.strerror)) from None
