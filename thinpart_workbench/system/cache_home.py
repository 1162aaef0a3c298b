"""The folder in which programs keep what can be made again."""

import os
import sys


def cache_home():
    """``$XDG_CACHE_HOME``, or where the system has such things; str, begins with ~ where there is no home."""
    chosen = os.environ.get("XDG_CACHE_HOME")
    if chosen:
        return chosen
    if sys.platform == "win32":
        return os.environ.get("LOCALAPPDATA") or os.path.expanduser(os.path.join("~", "AppData", "Local"))
    if sys.platform == "darwin":
        return os.path.expanduser(os.path.join("~", "Library", "Caches"))
    return os.path.expanduser(os.path.join("~", ".cache"))
