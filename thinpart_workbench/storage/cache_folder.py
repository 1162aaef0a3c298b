"""The folder for what can be made again: the search index and pictures of parts."""

import errno
import os
from pathlib import Path

from ..system.cache_home import cache_home


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
    chosen = os.path.expanduser(os.environ.get("THINPART_CACHE") or os.path.join(cache_home(), "thinpart"))
    if chosen.startswith("~"):
        raise FileNotFoundError(errno.ENOENT, "There is no home folder", chosen)
    return Path(chosen)
