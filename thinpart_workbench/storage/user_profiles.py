"""A user's own profiles: their folder, and writing one."""

import json
import os
from pathlib import Path

from ..core.errors import ProfileError, ThinPartError
from ..core.judging.criteria import PROFILES, profile_from
from ..core.kinds.json_file import UnreadableJson, read_json
from ..core.message import message
from ..system.user_folders import settings_home
from .atomic_file import write_atomically


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


def check_profile_file(file):
    """Check that a profile may be written to a file.

    Parameters
    ----------
    file : str or Path

    Raises
    ------
    ThinPartError
        kind ``usage`` if it has the name of a shipped profile, which would be taken for that, or if it exists and is no
        profile.
    """
    shipped = {path.stem.casefold() for path in PROFILES.glob("*.json")}
    if Path(file).stem.casefold() in shipped:
        raise ThinPartError(message("{file} would have the name of a profile that comes with ThinPart: choose another.",
                                    file=os.fspath(file)), "usage")
    if os.path.lexists(file) and not _is_profile(file):
        raise ThinPartError(message("{file} is no profile and is not overwritten: write the new profile elsewhere.",
                                    file=os.fspath(file)), "usage")


def write_profile(content, file):
    """Write a profile atomically.

    Parameters
    ----------
    content : dict
    file : str or Path
        The folder of the user's own profiles is made where it is missing.

    Raises
    ------
    ThinPartError
        See `check_profile_file`; kind ``failed`` if the file cannot be written.
    """
    check_profile_file(file)
    text = json.dumps(content, indent=2, ensure_ascii=False) + "\n"
    try:
        if Path(os.path.abspath(file)).parent == user_profiles_folder():
            os.makedirs(user_profiles_folder(), exist_ok=True)
        write_atomically(file, text.encode("utf-8", "backslashreplace"))
    except OSError as error:
        raise ThinPartError(message("The profile {file} could not be written ({problem}): choose another place for it.",
                                    file=os.fspath(file), problem=error.strerror)) from None


def _is_profile(file):
    try:
        profile_from(read_json(file))
    except (FileNotFoundError, UnreadableJson, ProfileError):
        return False
    return True
