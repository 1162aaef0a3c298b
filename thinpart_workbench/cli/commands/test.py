"""``thinpart test``: run the whole test suite, including the tests of the window."""

import compileall
import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from ...core.errors import ThinPartError

ROOT = Path(__file__).resolve().parents[3]
GUI_RUNNER = ROOT / "tests" / "gui" / "run_in_freecad.py"


def add_arguments(parser):
    """Declare the options; further arguments go to pytest."""
    parser.add_argument("--no-gui", action="store_true", help="leave out the tests of the window")
    parser.add_argument("--processes", type=int, metavar="N",
                        help="run the tests without window in N processes (default: one per core, and one where further "
                             "arguments choose some)")
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
    others = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *spread(options), *options.rest]
    same = {"cwd": ROOT, "env": environment, "stdin": subprocess.DEVNULL}
    if options.no_gui or options.rest:
        return subprocess.run(others, **same).returncode
    with tempfile.TemporaryFile() as output, subprocess.Popen(
            [sys.executable, os.fspath(GUI_RUNNER)], stdout=output, stderr=subprocess.STDOUT, **same) as window:
        status = subprocess.run(others, **same).returncode
        window.wait()
        output.seek(0)
        print("\nThe tests of the window:", flush=True)
        sys.stdout.buffer.write(output.read())
        sys.stdout.flush()
    return status or window.returncode
