"""The folder for what can be made again: the search index and pictures of parts."""

import errno
import os
from pathlib import Path


def cache_folder():
    """``$THINPART_CACHE``, else ``thinpart`` in the user's cache; need not exist.

    Returns
    -------
    Path

    Raises
    ------
    OSError
        Where there is no home, as for some services.
    """
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join("~", ".cache")
    chosen = os.path.expanduser(os.environ.get("THINPART_CACHE") or os.path.join(base, "thinpart"))
    if chosen.startswith("~"):
        raise FileNotFoundError(errno.ENOENT, "There is no home folder", chosen)
    return Path(chosen)
