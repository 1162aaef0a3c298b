"""The folder for what can be made again: the search index and pictures of parts."""

import os
from pathlib import Path


def cache_folder():
    """``$THINPART_CACHE``, else ``thinpart`` in the user's cache; need not exist.

    Returns
    -------
    Path
    """
    chosen = os.environ.get("THINPART_CACHE")
    if chosen:
        return Path(chosen).expanduser()
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(base, "thinpart")
