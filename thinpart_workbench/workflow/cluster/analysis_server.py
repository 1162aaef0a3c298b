# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process that does one task after the other, such as analysing a file, as requested on its standard input.

A Dask worker starts it (`cluster_worker`), since it cannot have worker processes of its own, and must not be affected
by a damaged file or another version of ThinPart. For every line of JSON that comes in, the ``content`` of a task of its
`ClusterWork`, a line goes out, the outcome. For example::

    {"file": ..., "info_file": ..., ...}    ->    the outcome of `analyse_file`

With ``--check`` it prints a line with the software versions of the machine and ends.
"""

import json
import os
import platform
import sys
from contextlib import suppress

from ... import __version__, requirements
from ...core.analysis_limits import Limits
from ...core.errors import Cancelled, ThinPartError
from ...core.run_control import RunControl
from ...freecad_adapter.bootstrap import has_home, load_freecad
from ...storage.temporary_folder import temporary_folder
from ...system.pipe_input import is_readable
from .cluster_work import work_named

IDLE_SECONDS = 120
"""The process ends after so many seconds without a request: its Dask worker may have been killed."""


def software():
    """Versions of the software on this machine that affects results: dict.

    ``thinpart``, ``freecad``, ``python`` (str), or ``lacks`` (str): why it cannot analyse files.
    """
    missing = requirements.missing("classify")
    if missing:
        return {"lacks": f"it lacks {', '.join(package for package, _ in missing)}: install that there"}
    with temporary_folder() as folder:
        if not has_home():
            os.environ["FREECAD_USER_HOME"] = folder
        try:
            freecad = load_freecad()
        except ThinPartError as error:
            return {"lacks": str(error).rstrip(".")}
        return {"thinpart": __version__, "freecad": ".".join(freecad.Version()[:3]),
                "python": platform.python_version()}


def serve(requests, responses, work, limits):
    """Process requests until they end, or until none has come for `IDLE_SECONDS`.

    Parameters
    ----------
    requests, responses : binary files
        The next request is sent only after the response.
    work : ClusterWork
    limits : Limits
    """
    control = _RequestControl(requests)
    with work.doer(limits) as do, suppress(Cancelled):
        while is_readable(requests.fileno(), IDLE_SECONDS):
            line = requests.readline()
            if not line:
                return
            responses.write(json.dumps(do(work.task(json.loads(line)), control)).encode() + b"\n")
            responses.flush()


class _RequestControl(RunControl):
    """Stops a task when the Dask worker has closed the pipe."""

    def __init__(self, requests):
        super().__init__()
        self._requests = requests

    def check(self):
        # No second request comes before the response, so readable input means end of file.
        if is_readable(self._requests.fileno(), 0):
            self.stop()
        super().check()


def main(arguments):
    """Run as ``python -m thinpart_workbench.workflow.cluster.analysis_server WORK LIMITS`` or ``--check``."""
    # Output of libraries belongs in the log of the Dask worker, not among the responses.
    responses = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with responses:
        if arguments == ["--check"]:
            responses.write(json.dumps(software()).encode() + b"\n")
        else:
            serve(sys.stdin.buffer, responses, work_named(arguments[0]), Limits(**json.loads(arguments[1])))


if __name__ == "__main__":
    main(sys.argv[1:])
