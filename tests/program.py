"""The program as people start it, for the tests of its command line."""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SAMPLES = ROOT / "resources" / "samples"
SCHEMA = json.loads((ROOT / "resources" / "info-file.schema.json").read_text(encoding="utf-8"))


def thinpart(*arguments, cwd=None, **options):
    environment = dict(os.environ, PYTHONPATH=str(ROOT), COLUMNS="200")
    return subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", *map(str, arguments)], cwd=cwd,
        env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL, timeout=300,
        **options,
    )


def records(run):
    return [json.loads(line) for line in run.stdout.splitlines()]


def failures(run):
    return {Path(line["file"]).name: line["error"]["kind"] for line in records(run)
            if "error" in line}


def group_ended(group):
    """Whether no process of a group is left, within ten seconds."""
    for _ in range(100):
        try:
            os.killpg(group, 0)
        except ProcessLookupError:
            return True
        time.sleep(0.1)
    return False
