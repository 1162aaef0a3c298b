# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program as people start it, for the tests of its command line."""

import json
import os
import subprocess
import sys
from contextlib import suppress
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


def descendants(process):
    """Numbers of the processes that a process has started, and of those that these have started: list of int.

    Workers have groups of their own, so that all that they start ends with them.
    """
    found, parents = [process], {}
    for status in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):  # it has ended meanwhile
            parents.setdefault(int(status.read_text().rpartition(")")[2].split()[1]), []).append(int(status.parent.name))
    for number in found:
        found += parents.get(number, ())
    return found[1:]


def all_ended(processes):
    """Wait until none of these processes runs; True, so that it can be asserted."""
    def is_over():
        return not any(_runs(number) for number in processes)

    time_limit.wait_until(is_over, f"the end of the processes {processes}", 20)
    return True


def _runs(process):
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


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
