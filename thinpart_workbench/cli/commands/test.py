# SPDX-License-Identifier: LGPL-2.1-or-later
"""``thinpart test``: run the whole test suite, including the tests of the window."""

import compileall
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from ...core.errors import ThinPartError

ROOT = Path(__file__).resolve().parents[3]
GUI_RUNNER = ROOT / "tests" / "gui" / "run_in_freecad.py"

MOST_AGAIN = 5
"""Where more tests than this fail, something is broken that a second run would only hide."""


def add_arguments(parser):
    """Declare the options; further arguments go to pytest."""
    parser.add_argument("--no-gui", action="store_true", help="leave out the tests of the window")
    parser.add_argument("--processes", type=int, metavar="N",
                        help="run the tests without window in N processes (default: one per core, and one where further "
                             "arguments choose some)")
    parser.add_argument("--quick", action="store_true",
                        help="leave out those that tests/long_tests.txt names: one in eight, which take most of the time")
    parser.add_argument("--again", action="store_true",
                        help=f"where up to {MOST_AGAIN} tests fail, run those once more on their own, and say which passed "
                             "only then")
    parser.epilog = "Further arguments go to pytest."


def spread(options):
    """pytest's arguments for as many processes as were asked for: none for one, or where pytest-xdist is missing.

    Files stay whole: their tests share what is costly to make.
    """
    processes = options.processes or (1 if options.rest else os.cpu_count() or 1)
    if processes < 2 or importlib.util.find_spec("xdist") is None:
        return []
    return ["-n", str(processes), "--dist", "loadfile"]


def run(options):
    """Run the suite and return its exit status.

    The tests of the window run in parallel to the others; their output is printed last.
    """
    if not GUI_RUNNER.is_file():
        raise ThinPartError("The tests are not part of this installation: use a checkout.", "usage")
    # The tests start hundreds of processes that write no bytecode, so compile once beforehand.
    compileall.compile_dir(ROOT / "thinpart_workbench", quiet=2)
    environment = dict(os.environ, PYTHONPATH=os.fspath(ROOT), PYTHONDONTWRITEBYTECODE="1")
    # pytest adds the folders of its ini file to the path itself.
    environment.pop("PYTHONSAFEPATH", None)
    same = {"cwd": ROOT, "env": environment, "stdin": subprocess.DEVNULL}
    if options.no_gui or options.rest:
        return _without_window(options, same)
    command = [sys.executable, os.fspath(GUI_RUNNER), *(["--again"] if options.again else []), *_quick(options)]
    with tempfile.TemporaryFile() as output, subprocess.Popen(
            command, stdout=output, stderr=subprocess.STDOUT, **same) as window:
        status = _without_window(options, same)
        window.wait()
        output.seek(0)
        print("\nThe tests of the window:", flush=True)
        sys.stdout.buffer.write(output.read())
        sys.stdout.flush()
    return status or window.returncode


def _without_window(options, same):
    """Run the tests without window, those that fail once more where that was asked for; pytest's exit status."""
    with tempfile.TemporaryDirectory(prefix="thinpart-tests-") as cache:
        pytest = [sys.executable, "-m", "pytest", "-o", f"cache_dir={cache}", *_quick(options)]
        status = subprocess.run([*pytest, *spread(options), *options.rest], **same).returncode
        failed = failed_tests(cache) if options.again and status == 1 else []
        if not 0 < len(failed) <= MOST_AGAIN:
            return status
        print(AGAIN.format("\n".join(failed)), flush=True)
        return subprocess.run([*pytest, "--last-failed", *options.rest], **same).returncode


def _quick(options):
    return ["--quick"] if options.quick else []


AGAIN = "These tests failed and run once more, on their own. Those that pass now depend on how busy the machine is:\n{}\n"


def failed_tests(cache):
    """The tests that have failed in the run whose cache folder is given, by pytest's names: list of str."""
    try:
        return list(json.loads((Path(cache) / "v" / "cache" / "lastfailed").read_text(encoding="utf-8")))
    except (OSError, ValueError):  # it ended before
        return []
