# SPDX-License-Identifier: LGPL-2.1-or-later
"""Time to a verdict: the whole program as people start it, against a bare process that reads and tessellates the same files.

Whole process against whole process, in turns: start, reading, tessellating and the end belong to both. What ThinPart adds is
everything else: a confined worker, measuring, judging, info files and pictures.
"""

import json
import os
import shutil
import subprocess
import tempfile
import threading
import time
from collections import namedtuple
from itertools import cycle
from pathlib import Path
from statistics import median

from .children.bare_tessellation import ENDINGS
from .children.child_process import Child, ChildError, environment, pinned_to
from .children.made_parts import LARGE, family_of, made_files
from .places import ROOT

SAMPLES = ROOT / "resources" / "samples"
SMALL_PART = SAMPLES / "tube.step"
SMALL_PARTS = 40

LIMIT = 4 * 3600.0
"""Seconds that one process may take."""

BARE, ONE_CORE, TWO_CORES, TABLE = "bare", "one_core", "two_cores", "table"
"""The contestants: the bare process on one core, the program on one and on two, and, on a small part, with its table."""

SMALL, COPIES, MADE, LARGE_PART, REAL = (
    "one small part", "copies of the samples", "made solids", "a large part", "real parts")
"""What is judged."""

QUICK_LARGE, QUICK_PARTS = ("studs", 4), 10
"""The large part, and about how many real ones, where it has to be quick."""

MOST_TURNS = 3
"""Beyond one small part turns are long enough."""

Run = namedtuple("Run", "seconds files lines")
"""A process: its time; seconds per file, as its lines came; and what it said, as list of dict."""


def measure_verdicts(python, cache, parts, repeat, is_quick, has_large, options, say):
    """Time the program and the bare process on each set of files.

    Parameters
    ----------
    python : str
        Interpreter of the bare process.
    cache : Path
        Where made files are kept.
    parts : Path or None
        A folder of real parts.
    repeat : int
        Turns.
    is_quick, has_large : bool
        Small sets only; with the part of a million triangles.
    options : list of str
        Further ones of ``thinpart classify``.
    say : callable
        Told what is going on.

    Returns
    -------
    list of dict
        One per set: ``name``, ``files``, ``triangles`` of the bare process, ``seconds`` (list by contestant), ``stages`` (s,
        of the program on one core, as it says), ``failed`` (files by contestant) and ``groups``: by size, family and format.

    Raises
    ------
    ChildError
        where a process fails.
    """
    found = []
    has_threads = "--threads" in _help()
    with tempfile.TemporaryDirectory() as temporary:
        for name, files in _sets(python, cache, parts, is_quick, has_large):
            folder = Path(temporary) / "parts"
            _copy(files, folder)
            say(f"{name}: {len(files)} files")
            start = {}
            if found:
                start = {key: median(times) for key, times in found[0]["seconds"].items()}
            turns = repeat if name == SMALL else min(repeat, MOST_TURNS)
            found.append(_measured(name, folder, python, turns, options, has_threads, start))
            shutil.rmtree(folder)
    return found


def _sets(python, cache, parts, is_quick, has_large):
    """Pairs of a name and a list of (file, its name below the folder).

    The small part comes first: its time is the start-up of all others.
    """
    samples = [file for file in sorted(SAMPLES.glob("*.step")) if "assembly" not in file.name]
    yield SMALL, [(SMALL_PART, SMALL_PART.name)]
    if not is_quick:
        yield COPIES, [(file, f"{number:02}_{file.name}") for number, file in zip(range(SMALL_PARTS), cycle(samples))]
    made = made_files(is_quick)
    family, size = QUICK_LARGE if is_quick else LARGE
    large = [(f"{family}_{size}.step", family, size)] if has_large else []
    with Child(python, "made_parts") as freecad:
        freecad.ask("write", LIMIT, folder=str(cache), files=[*made, *large])
    for title, files in ((MADE, made), (LARGE_PART, large)):
        if files:
            yield title, [(cache / name, name) for name, *_ in files]
    if parts is not None:
        real = [file for file in sorted(parts.rglob("*")) if file.suffix.lower() in ENDINGS]
        every = max(1, len(real) // QUICK_PARTS) if is_quick else 1
        yield REAL, [(file, file.relative_to(parts).as_posix()) for file in real[::every]]


def _copy(files, folder):
    for file, name in files:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, folder / name)


def _measured(name, folder, python, turns, options, has_threads, start):
    count = sum(1 for path in folder.rglob("*") if path.is_file())
    bare = [python, "-m", "benchmarks.children.bare_tessellation", folder]

    def program(cores, *more):
        # A second core takes a second file, or helps with the only one where the program can do that.
        threads = ["--threads", cores] if has_threads and count == 1 else []
        return [ROOT / "thinpart", "classify", folder, "--jobs", cores, *threads, *more, *options]

    contestants = {
        BARE: lambda: _run(bare, folder, 1),
        ONE_CORE: lambda: _run(program(1, "--json"), folder, 1, is_program=True),
        TWO_CORES: lambda: _run(program(2, "--json"), folder, 2, is_program=True),
    }
    if name == SMALL:
        contestants[TABLE] = lambda: _run(program(1), folder, 1, is_program=True)
    runs = {key: [] for key in contestants}
    for _ in range(turns):
        for key, run in contestants.items():
            runs[key].append(run())
    said = {line["file"]: line for line in runs[BARE][0].lines}
    records = [line for line in runs[ONE_CORE][0].lines if "category" in line]
    return {
        "name": name, "files": count, "triangles": sum(line.get("triangles", 0) for line in said.values()),
        "own_triangles": sum(record["triangles"] for record in records),
        "seconds": {key: [run.seconds for run in own] for key, own in runs.items()},
        "stages": {stage: sum(record["seconds"].get(stage, 0.0) for record in records)
                   for stage in ("read", "tessellate", "measure")},
        "failed": {BARE: sum("error" in line for line in said.values()),
                   ONE_CORE: len({line["file"] for line in runs[ONE_CORE][0].lines if "error" in line})},
        "groups": _groups(name, said, runs, start) if count > 1 else [],
    }


def _run(command, folder, cores, is_program=False):
    """Run a process from start to end, everything made from nothing.

    Parameters
    ----------
    command : list
    folder : Path
        Of the parts.
    cores : int
    is_program : bool
        Whether it is the program; otherwise the bare process.

    Returns
    -------
    Run
        Its files are named from the folder on.
    """
    with tempfile.TemporaryDirectory() as temporary:
        own = environment()
        if is_program:
            command = [*command, "--info-dir", Path(temporary) / "info"]
            own = dict(os.environ, THINPART_NO_INSTALL="1", THINPART_CACHE=os.path.join(temporary, "cache"))
        with open(os.path.join(temporary, "output"), "w+", encoding="utf-8") as output:
            # A line per file, at once: of the bare process on its output, of the program among its messages.
            arrived, seconds, status = _timed_lines(list(map(str, command)), cores, own, output if is_program else None)
            output.seek(0)
            lines = [json.loads(line) for line in output if line.startswith("{")]
    if status not in (0, 1):  # 1: some parts failed, each named
        raise ChildError(f"{Path(command[0]).name} ended with status {status}.")
    if is_program:
        arrived = [(moment, {"file": _below(folder, line["progress"]["file"])}) for moment, line in arrived
                   if line.get("progress", {}).get("file")]
        lines = [{**line, "file": _below(folder, line["file"])} for line in lines]
    else:
        lines = [line for _, line in arrived]
    files, last = {}, 0.0
    for moment, line in arrived:
        files[line["file"]] = moment - last
        last = moment
    return Run(seconds, files, lines)


def _below(folder, file):
    return Path(file).relative_to(folder).as_posix()


def _timed_lines(command, cores, own_environment, output):
    """Its lines of JSON, each with the seconds at which it came; its whole time; its exit status.

    Parameters
    ----------
    command : list of str
    cores : int
    own_environment : dict
    output : file or None
        Where its output goes, if the lines are among its messages.
    """
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    if output is not None:
        streams = {"stdout": output, "stderr": subprocess.PIPE}
    start = time.perf_counter()
    process = subprocess.Popen(command, env=own_environment, stdin=subprocess.DEVNULL, encoding="utf-8", cwd=ROOT,
                               preexec_fn=pinned_to(cores), **streams)
    limit = threading.Timer(LIMIT, process.kill)
    limit.start()
    lines = []
    try:
        with process.stderr or process.stdout as stream:
            for line in stream:
                if line.startswith("{"):
                    lines.append((time.perf_counter() - start, json.loads(line)))
        status = process.wait()
        seconds = time.perf_counter() - start
    finally:
        limit.cancel()
        process.kill()
        process.wait()
    return lines, seconds, status


def _groups(name, said, runs, start):
    """Seconds of both by size, family and format: list of dict.

    Files that either could not read are left out. The first file of a process has its start-up too: what the small part
    takes is taken off it.
    """
    failed = {line["file"] for line in runs[ONE_CORE][0].lines if "error" in line}
    times = {key: _times_of_files(runs[key], start.get(key, 0.0)) for key in (BARE, ONE_CORE)}
    groups = {}
    for file, line in said.items():
        if file in failed or "error" in line:
            continue
        keys = [("size", 10 ** (len(str(line["triangles"])) - 1)), ("format", _format_of(file))]
        if name == MADE:
            keys.append(("family", family_of(file).replace("_", " ")))
        for key in keys:
            group = groups.setdefault(key, {"by": key[0], "group": key[1], "files": 0, BARE: 0.0, ONE_CORE: 0.0})
            group["files"] += 1
            for contestant in (BARE, ONE_CORE):
                group[contestant] += times[contestant][file]
    return sorted(groups.values(), key=lambda group: (group["by"] != "size", group["by"] != "family", group["group"]))


def _times_of_files(runs, start):
    """Medians of all turns, s, by file."""
    found = {}
    for run in runs:
        for number, (file, seconds) in enumerate(run.files.items()):
            found.setdefault(file, []).append(max(0.0, seconds - start) if number == 0 else seconds)
    return {file: median(times) for file, times in found.items()}


def _format_of(file):
    ending = Path(file).suffix.lower()
    return {".fcstd": "FCStd", ".step": "STEP", ".stp": "STEP", ".brep": "BREP", ".brp": "BREP"}.get(ending, "IGES")


def _help():
    run = subprocess.run([ROOT / "thinpart", "classify", "--help"], capture_output=True, text=True, stdin=subprocess.DEVNULL,
                         env=dict(os.environ, THINPART_NO_INSTALL="1"))
    return run.stdout
