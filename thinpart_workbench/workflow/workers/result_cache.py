# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of tasks that are kept in the cache, so that an interrupted run goes on where it was."""

import hashlib
import json
from contextlib import suppress

from ...core.kinds.json_file import UnreadableJson, read_json
from ...storage.cache_folder import cache_folder, write_cached


class ResultCache:
    """The kept results of tasks of one kind.

    Parameters
    ----------
    name : str
        Of the folder within the cache.
    key : callable
        ``key(task)``: a text that differs where results do.
    most : int
        Bytes of a result above which it is not read.
    lasts : callable, optional
        ``lasts(result)``: whether another run would have the same result.
    renew : bool, optional
        Whether results are only kept, and none is taken.
    """

    def __init__(self, name, key, most, lasts=lambda result: True, renew=False):
        self._key, self._most, self._lasts, self._renew = key, most, lasts, renew
        try:
            self._folder = cache_folder() / name
        except OSError:
            self._folder = None  # results are not kept

    def result(self, task):
        """The kept result of a task, any JSON value, which has to be checked; None if there is none."""
        if self._folder is None or self._renew:
            return None
        try:
            return read_json(self._path(task), self._most)
        except (FileNotFoundError, UnreadableJson):
            return None

    def keep(self, task, result):
        """Keep a result; a full disk only costs time later."""
        if self._folder is not None and self._lasts(result):
            with suppress(OSError):
                write_cached(self._path(task), json.dumps(result).encode())

    def _path(self, task):
        return self._folder / f"{hashlib.sha256(self._key(task).encode()).hexdigest()[:32]}.json"
