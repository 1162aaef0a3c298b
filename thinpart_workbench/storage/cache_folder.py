# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder for files that can be regenerated: the search index, thumbnails of parts, and results of meshing."""

import errno
import os
from pathlib import Path

from ..system.user_folders import cache_home
from .atomic_file import OWNER_ONLY, write_atomically


def cache_folder():
    """``$THINPART_CACHE``, else ``thinpart`` in the user's cache folder: Path, which may not exist yet.

    Raises OSError if there is no home folder, as for some services.
    """
    chosen = os.path.expanduser(os.environ.get("THINPART_CACHE") or os.path.join(cache_home(), "thinpart"))
    if chosen.startswith("~"):
        raise FileNotFoundError(errno.ENOENT, "There is no home folder", chosen)
    return Path(chosen)


def write_cached(path, content):
    """Write a file of the cache, and its folder where that is missing: readable by this user alone, as are some parts.

    Raises OSError: no partial file is left, and an existing file stays.
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(path, content, durable=False, access=OWNER_ONLY)
