"""The folder for files that can be regenerated: the search index and thumbnails of parts."""

import errno
import os
from pathlib import Path

from ..system.user_folders import cache_home


def cache_folder():
    """``$THINPART_CACHE``, else ``thinpart`` in the user's cache folder; may not exist yet.

    Returns
    -------
    Path

    Raises
    ------
    OSError
        If there is no home folder, as for some services.
    """
    chosen = os.path.expanduser(os.environ.get("THINPART_CACHE") or os.path.join(cache_home(), "thinpart"))
    if chosen.startswith("~"):
        raise FileNotFoundError(errno.ENOENT, "There is no home folder", chosen)
    return Path(chosen)
