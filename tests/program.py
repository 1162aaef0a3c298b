"""The program as people start it, for the tests of its command line."""

import json
import os
import subprocess
import sys
from pathlib import Path

import time_limit

ROOT = Path(__file__).resolve().parents[1]
SAMPLES = ROOT / "resources" / "samples"
SCHEMA = json.loads((ROOT / "resources" / "info-file.schema.json").read_text(encoding="utf-8"))


BARE_PYTHON = ROOT / "tests" / "bare_python"
"""On PYTHONPATH it makes of a Python that of a FreeCAD bundle."""


def environment(**more):
    """The environment of the program: $THINPART_TEST_PATH holds folders for its PYTHONPATH beside the checkout."""
    path = os.pathsep.join(filter(None, (os.environ.get("THINPART_TEST_PATH"), str(ROOT))))
    return dict(os.environ, PYTHONPATH=path, **more)


def thinpart(*arguments, cwd=None, variables=None, **options):
    """Run a command to its end, with further environment variables; where it has none, the test's time limit ends and names
    it."""
    return subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", *map(str, arguments)], cwd=cwd,
        env=environment(COLUMNS="200", **variables or {}), capture_output=True, encoding="utf-8", stdin=subprocess.DEVNULL,
        **options,
    )


def records(run):
    return [json.loads(line) for line in run.stdout.splitlines()]


def failures(run):
    return {Path(line["file"]).name: line["error"]["kind"] for line in records(run)
            if "error" in line}


def group_ended(group):
    """Wait until no process of a group is left; True, so that it can be asserted."""
    def is_over():
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        return False

    time_limit.wait_until(is_over, f"the end of all processes of group {group}", 20)
    return True
