"""Proposals that are kept in the cache, so that an interrupted run goes on where it was."""

import hashlib
import json
import os
from contextlib import suppress
from dataclasses import asdict, replace

from ...core.regular_file import open_regular
from ...storage.cache_folder import cache_folder, write_cached
from ...storage.info.info_file import source_is_unchanged
from .size_result import sizes_fault

_LARGEST = 1 << 30

_VERSION = 9
"""Changes when proposals do."""


class SizeCache:
    """The kept results of documents.

    Parameters
    ----------
    version : str
        Of Gmsh; empty where nothing is meshed.
    limits : Limits
        With others, what took too long might not.
    """

    def __init__(self, version, limits):
        self._what = [_VERSION, version, float(limits.seconds), limits.megabytes]
        try:
            self._folder = cache_folder() / "sizes"
        except OSError:
            self._folder = None  # results are not kept

    def result(self, task):
        """The kept result of a `SizeTask` whose document, and those that it links to, are unchanged, or None."""
        if self._folder is None:
            return None
        try:
            with open_regular(self._path(task)) as file:
                result = json.loads(file.read(_LARGEST))
        except (OSError, ValueError, RecursionError):
            return None
        return result if sizes_fault(result, task) is None and source_is_unchanged(result["source"], task.file) else None

    def keep(self, task, result):
        """Keep a result; a full disk only costs time later."""
        if self._folder is not None:
            with suppress(OSError):
                write_cached(self._path(task), json.dumps(result).encode())

    def _path(self, task):
        content = [self._what, asdict(replace(task, file=os.path.abspath(task.file), program=bool(task.program)))]
        return self._folder / f"{hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest()[:32]}.json"
