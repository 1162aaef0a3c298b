"""Wall time of the program as people start it: one small part, and a folder on one and on two cores."""

import os
import shutil
import subprocess
import tempfile
import time
from itertools import cycle
from pathlib import Path

from .child_process import ROOT, ChildError

SAMPLES = ROOT / "resources" / "samples"
SMALL_PART = SAMPLES / "tube.step"
FOLDER_PARTS = 40
FOLDER_TURNS = 3
"""A folder takes long enough that few turns do."""


def measure_command_line(repeat, say):
    """Time the command line.

    Parameters
    ----------
    repeat : int
        Turns of the small part.
    say : callable
        Told what is going on.

    Returns
    -------
    dict
        ``small_part``, ``folder_one_job`` and ``folder_two_jobs``: lists of seconds, from the start of the
        program to its end.

    Raises
    ------
    ChildError
        where the program fails.
    """
    times = {"small_part": [], "folder_one_job": [], "folder_two_jobs": []}
    with tempfile.TemporaryDirectory() as folder:
        part = Path(folder) / SMALL_PART.name
        shutil.copyfile(SMALL_PART, part)
        say("the command line on one small part")
        for _ in range(repeat):
            times["small_part"].append(_classify(part, "--force"))
        parts = Path(folder) / "parts"
        _fill(parts)
        say(f"the command line on a folder of {FOLDER_PARTS} parts")
        for _ in range(min(repeat, FOLDER_TURNS)):
            for jobs, key in (("1", "folder_one_job"), ("2", "folder_two_jobs")):
                times[key].append(_classify(parts, "--force", "--no-info", "--jobs", jobs))
    return times


def _fill(folder):
    """Copies of the single parts among the samples; the program does not know that they are copies."""
    folder.mkdir()
    samples = [file for file in sorted(SAMPLES.glob("*.step")) if "assembly" not in file.name]
    for number, sample in zip(range(FOLDER_PARTS), cycle(samples)):
        shutil.copyfile(sample, folder / f"{number:02}_{sample.name}")


def _classify(path, *options):
    environment = dict(os.environ, THINPART_NO_INSTALL="1")
    command = [ROOT / "thinpart", "classify", path, *options]
    start = time.perf_counter()
    run = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    seconds = time.perf_counter() - start
    if run.returncode:
        reason = (run.stderr.strip().splitlines() or ["no reason given"])[-1]
        raise ChildError(f"The command line failed: {reason[:200]}")
    return seconds
