# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's folders for settings and for cached data."""

import os
import sys

_CHOSEN = {"settings": "XDG_CONFIG_HOME", "cache": "XDG_CACHE_HOME"}
"""Variables that name a folder, on all systems."""

_WINDOWS = {"settings": ("APPDATA", "~/AppData/Roaming"), "cache": ("LOCALAPPDATA", "~/AppData/Local")}
"""Variables of Windows, and the folders where they are not set."""

_BELOW_HOME = {"darwin": {"settings": "~/Library/Application Support", "cache": "~/Library/Caches"}}
_BELOW_HOME_ELSEWHERE = {"settings": "~/.config", "cache": "~/.cache"}


def settings_home():
    """``$XDG_CONFIG_HOME``, or the system's folder for settings; str, begins with ~ if there is no home folder."""
    return _folder("settings")


def cache_home():
    """``$XDG_CACHE_HOME``, or the system's cache folder; str, begins with ~ if there is no home folder."""
    return _folder("cache")


def _folder(purpose):
    chosen = os.environ.get(_CHOSEN[purpose])
    if chosen:
        return chosen
    if sys.platform == "win32":
        variable, default = _WINDOWS[purpose]
        return os.environ.get(variable) or _expanded(default)
    return _expanded(_BELOW_HOME.get(sys.platform, _BELOW_HOME_ELSEWHERE)[purpose])


def _expanded(folder):
    return os.path.expanduser(os.path.join(*folder.split("/")))
