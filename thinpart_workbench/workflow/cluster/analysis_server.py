# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process that analyses one file after the other, as requested on its standard input.

A Dask worker starts it (`cluster_worker`), since it cannot have worker processes of its own, and must not be affected
by a damaged file or another version of ThinPart. For every line of JSON that comes in, a line goes out::

    {"file": ..., "info_file": ..., ...}    ->    the outcome of `analyse_file`

With ``--check`` it prints a line with the software versions of the machine and ends.
"""

import json
import os
import platform
import sys
from contextlib import suppress
from dataclasses import asdict

from ... import __version__, requirements
from ...core.analysis_limits import Limits
from ...core.analysis_settings import AnalysisSettings
from ...core.errors import Cancelled, ThinPartError
from ...core.run_control import RunControl
from ...freecad_adapter.bootstrap import has_home, load_freecad
from ...storage.temporary_folder import temporary_folder
from ...system.pipe_input import is_readable
from ..analysis.analyse_file import FileTask
from ..workers.worker_pool import file_analyser

IDLE_SECONDS = 120
"""The process ends after so many seconds without a request: its Dask worker may have been killed."""


def task_line(task):
    """A `FileTask` as a line of JSON, with absolute paths, so that a process on another machine finds them."""
    content = asdict(task)
    for key in ("file", "info_file"):
        if content[key] is not None:
            content[key] = os.path.abspath(content[key])
    return json.dumps(content)


def task_from(line):
    """The `FileTask` of a line from `task_line`."""
    content = json.loads(line)
    return FileTask(**{**content, "settings": AnalysisSettings(**content["settings"])})


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


def serve(requests, responses, limits):
    """Process requests until they end, or until none has come for `IDLE_SECONDS`.

    Parameters
    ----------
    requests, responses : binary files
        The next request is sent only after the response.
    limits : Limits
    """
    control = _RequestControl(requests)
    with file_analyser(limits) as analyse, suppress(Cancelled):
        while is_readable(requests.fileno(), IDLE_SECONDS):
            line = requests.readline()
            if not line:
                return
            responses.write(json.dumps(analyse(task_from(line), control)).encode() + b"\n")
            responses.flush()


class _RequestControl(RunControl):
    """Stops an analysis when the Dask worker has closed the pipe."""

    def __init__(self, requests):
        super().__init__()
        self._requests = requests

    def check(self):
        # No second request comes before the response, so readable input means end of file.
        if is_readable(self._requests.fileno(), 0):
            self.stop()
        super().check()


def main(arguments):
    """Run as ``python -m thinpart_workbench.workflow.cluster.analysis_server LIMITS`` or ``--check``."""
    # Output of libraries belongs in the log of the Dask worker, not among the responses.
    responses = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with responses:
        if arguments == ["--check"]:
            responses.write(json.dumps(software()).encode() + b"\n")
        else:
            serve(sys.stdin.buffer, responses, Limits(**json.loads(arguments[0])))


if __name__ == "__main__":
    main(sys.argv[1:])
