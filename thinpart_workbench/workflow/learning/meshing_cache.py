"""Results of meshing that are kept in the cache, so that an interrupted run goes on where it was."""

import hashlib
import json
from contextlib import suppress

from ...core.mesh.tetrahedra import POOR
from ...core.regular_file import open_regular
from ...storage.cache_folder import cache_folder, write_cached
from .gmsh_mesh import SIZE, results_fault

_LARGEST = 64 << 20


class MeshingCache:
    """The kept results of documents.

    Parameters
    ----------
    version : str
        Of Gmsh.
    limits : Limits
        With others, what took too long might not.
    """

    def __init__(self, version, limits):
        self._what = ["1", version, SIZE, POOR, float(limits.seconds), limits.megabytes]
        try:
            self._folder = cache_folder() / "meshing"
        except OSError:
            self._folder = None  # results are not kept

    def results(self, source, task):
        """The kept results of a document, or None.

        Parameters
        ----------
        source : dict
            Of the info file: the same content has the same results.
        task : MeshingTask
        """
        if self._folder is None:
            return None
        try:
            with open_regular(self._path(source, task)) as file:
                results = json.loads(file.read(_LARGEST))
        except (OSError, ValueError):
            return None
        return None if results_fault(results, task) else results

    def keep(self, source, task, results):
        """Keep the results of a document; a full disk only costs time later."""
        if self._folder is not None:
            with suppress(OSError):
                write_cached(self._path(source, task), json.dumps(results).encode())

    def _path(self, source, task):
        content = [self._what, source["sha256"], [link["sha256"] for link in source.get("links", ())], task.diagonals]
        return self._folder / f"{hashlib.sha256(json.dumps(content).encode()).hexdigest()[:32]}.json"
