"""``thinpart test``: the whole suite, the part that needs a window included."""

import os
import subprocess
import sys
from pathlib import Path

from ..core.errors import ThinPartError

ROOT = Path(__file__).resolve().parents[2]
GUI_RUNNER = ROOT / "tests" / "gui" / "run_in_freecad.py"


def add_arguments(parser):
    """Further arguments go to pytest."""
    parser.add_argument("--no-gui", action="store_true", help="leave out the tests of the window")
    parser.epilog = "Further arguments are handed to pytest."


def run(options):
    """Run the suite and return its exit status."""
    if not GUI_RUNNER.is_file():
        raise ThinPartError("The tests are not part of this installation: use a checkout.", "usage")
    environment = dict(os.environ, PYTHONPATH=os.fspath(ROOT), PYTHONDONTWRITEBYTECODE="1")
    # pytest puts the folders of its ini file on the path itself.
    environment.pop("PYTHONSAFEPATH", None)
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *options.rest]
    status = subprocess.run(command, cwd=ROOT, env=environment, stdin=subprocess.DEVNULL).returncode
    if options.no_gui or options.rest:
        return status
    window = subprocess.run([sys.executable, os.fspath(GUI_RUNNER)], cwd=ROOT, env=environment,
                            stdin=subprocess.DEVNULL).returncode
    return status or window
