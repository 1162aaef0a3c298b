"""A process that analyses one file after the other, asked through its standard input.

A Dask worker starts it (`cluster_worker`): it cannot have worker processes of its own, and a damaged file
or another version of ThinPart must not touch it. Per line of JSON that comes in, a line goes out::

    {"file": ..., "info_file": ..., ...}    ->    the outcome of `analyse_file`

With ``--check`` it prints a line about the software of the machine and ends.
"""

import json
import os
import platform
import sys
from contextlib import suppress
from dataclasses import asdict

from .. import __version__, requirements
from ..core.analysis_settings import AnalysisSettings
from ..core.errors import ThinPartError
from ..freecad_adapter.bootstrap import has_home, load_freecad
from ..system.pipe_input import is_readable
from .analyse_file import FileTask
from .run_control import RunControl
from .temporary_folder import temporary_folder
from .worker_pool import Limits, file_analyser

IDLE_SECONDS = 120
"""A process that nobody asked for so long ends: whoever wanted it may have been killed."""


def task_line(task):
    """A `FileTask` as a line of JSON, its paths made absolute: a process elsewhere has to find them."""
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
    """Versions of what decides about results on this machine.

    Returns
    -------
    dict
        ``thinpart``, ``freecad``, ``python`` (str), or ``lacks`` (str): what keeps it from analysing.
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


def serve(requests, answers, limits):
    """Answer until the requests end, or none comes for long.

    Parameters
    ----------
    requests, answers : binary files
        The next request is sent only after the answer.
    limits : Limits
    """
    asker = _Asker(requests)
    with file_analyser(limits) as analyse, suppress(KeyboardInterrupt):
        while is_readable(requests.fileno(), IDLE_SECONDS):
            line = requests.readline()
            if not line:
                return
            answers.write(json.dumps(analyse(task_from(line), asker)).encode() + b"\n")
            answers.flush()


class _Asker(RunControl):
    """Stops an analysis when nobody waits for its answer any more."""

    def __init__(self, requests):
        super().__init__()
        self._requests = requests

    def check(self):
        # There is no second request before the answer; so this is the end.
        if is_readable(self._requests.fileno(), 0):
            raise KeyboardInterrupt


def main(arguments):
    """Run as ``python -m thinpart_workbench.workflow.analysis_server LIMITS`` or ``--check``."""
    # What libraries print belongs in the log of whoever started this, not among the answers.
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    with answers:
        if arguments == ["--check"]:
            answers.write(json.dumps(software()).encode() + b"\n")
        else:
            serve(sys.stdin.buffer, answers, Limits(**json.loads(arguments[0])))


if __name__ == "__main__":
    main(sys.argv[1:])
