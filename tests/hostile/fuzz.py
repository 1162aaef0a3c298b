#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged files by the hundred through ``classify``, and what has to hold whatever is in them.

    python3 tests/hostile/fuzz.py --files 10000 --seed 1 FOLDER

makes the files in FOLDER, which must be new, classifies them, and says what became of them. It stops at the first thing
that does not hold; the files stay where they are.
"""

import argparse
import hashlib
import json
import os
import random
import subprocess
import sys
import time
import warnings
from collections import Counter
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parents[1]),
                str(Path(__file__).resolve().parent)]

import jsonschema  # noqa: E402
from mutations import damaged  # noqa: E402
from program import SAMPLES, SCHEMA, environment  # noqa: E402

from thinpart_workbench.core.errors import KINDS  # noqa: E402

OTHER_FORMATS = ("brep", "iges", "stl", "obj", "ply", "off", "3mf")
SECONDS, MEGABYTES = 10, 3000
"""What one damaged file may cost."""


def make_seeds(folder):
    """Write whole parts, one at least in each format: list of Path."""
    from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

    freecad = load_freecad()
    import Mesh
    import MeshPart
    import Part

    seeds = [SAMPLES / name for name in (
        "plate.step", "tube.step", "worm_run_out.step", "assembly_of_three.step", "tube.FCStd",
        "assembly_of_three.FCStd", "ribbed_block.FCStd")]
    shape = Part.read(str(SAMPLES / "tube.step"))
    mesh = MeshPart.meshFromShape(shape, 0.5, 0.5)
    for ending in OTHER_FORMATS:
        path = folder / f"seed.{ending}"
        if ending == "brep":
            shape.exportBrep(str(path))
        elif ending == "iges":
            shape.exportIges(str(path))
        else:
            mesh.write(str(path)) if ending != "3mf" else Mesh.export([_mesh_object(freecad, mesh)], str(path))
        if path.exists():
            seeds.append(path)
    return seeds


def _mesh_object(freecad, mesh):
    made = freecad.newDocument("Seed").addObject("Mesh::Feature", "Mesh")
    made.Mesh = mesh
    return made


def make_files(folder, seeds, count, seed):
    """Write damaged files: list of Path."""
    chance, made = random.Random(seed), []
    contents = [(path, path.read_bytes()) for path in seeds]
    for number in range(count):
        path, content = chance.choice(contents)
        own = chance.randrange(1 << 60)
        made.append(folder / f"{number:05}-{path.stem}{path.suffix}")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # entries of the same name are meant
            made[-1].write_bytes(damaged(content, path.name, own))
    return made


def classify(folder, work, jobs):
    """Classify a folder, everything temporary in `work`: the finished process and its seconds."""
    for name in ("home", "temporary"):
        (work / name).mkdir(parents=True, exist_ok=True)
    started = time.monotonic()
    run = subprocess.run(
        [sys.executable, "-m", "thinpart_workbench", "classify", str(folder), "--json", "--jobs", str(jobs),
         "--timeout", str(SECONDS), "--memory", str(MEGABYTES)],
        env=environment(HOME=str(work / "home"), TMPDIR=str(work / "temporary")), capture_output=True, encoding="utf-8",
        stdin=subprocess.DEVNULL, errors="surrogateescape", cwd=work)
    return run, time.monotonic() - started


def check(run, files, folder, work):
    """Hold what has to hold of a run.

    Returns
    -------
    Counter
        Of categories and kinds of failures, by file.
    """
    assert "Traceback" not in run.stderr + run.stdout, run.stderr[-3000:]
    rows = {}
    for line in run.stdout.splitlines():
        row = json.loads(line, parse_constant=lambda name: _fail(f"{name} among the numbers"))
        rows.setdefault(row["file"], []).append(row)
    assert set(rows) == set(map(str, files)), set(rows) ^ set(map(str, files))
    failed = any("error" in row for of_file in rows.values() for row in of_file)
    assert run.returncode == (1 if failed else 0), (run.returncode, run.stderr[-2000:])
    became = Counter()
    for of_file in rows.values():
        for row in of_file:
            if "error" in row:
                assert row["error"]["kind"] in KINDS and _is_sentence(row["error"]["message"]), row
        found = {row["error"]["kind"] if "error" in row else row["category"] for row in of_file}
        became[min(found)] += 1
    for path in folder.glob("*.thinpart.json"):
        jsonschema.validate(json.loads(path.read_bytes()), SCHEMA)
    assert not list(folder.glob(".thinpart-*")) and not os.listdir(work / "temporary")
    left = [path for path in (work / "home").rglob("*") if path.is_file() and ".cache/thinpart" not in str(path)]
    assert left == [], left
    return became


def _fail(message):
    raise AssertionError(message)


def _is_sentence(text):
    return text[:1].isprintable() and text.rstrip()[-1:] in ".?!)" and "\n" not in text and "Traceback" not in text


def hashes(paths):
    """dict from path to what is in it."""
    return {path: hashlib.sha256(path.read_bytes()).hexdigest() for path in paths}


def fuzz(folder, count, seed, jobs=2):
    """Make files, classify them twice, and hold what has to hold.

    Returns
    -------
    became : Counter
    seconds : float
        Of the first run.
    """
    parts, work, victims = folder / "parts", folder / "work", folder / "victims"
    for each in (parts, work, victims):
        each.mkdir(parents=True)
    seeds = make_seeds(work)
    files = make_files(parts, seeds, count, seed)
    for name in ("etc", "passwd"):
        (victims / name).write_text("not to be touched")
    before = hashes([*files, *victims.iterdir()])
    run, seconds = classify(parts, work, jobs)
    became = check(run, files, parts, work)
    assert hashes(before) == before, "a file was changed"
    assert not {each.name for each in folder.iterdir()} - {"parts", "work", "victims"}
    return became, seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--files", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    became, seconds = fuzz(options.folder.absolute(), options.files, options.seed, options.jobs)
    print(f"{options.files} damaged files, seed {options.seed}: {seconds:.0f} s, a row each, nothing lost or left")
    for name, count in became.most_common():
        print(f"  {name:16} {count}")


if __name__ == "__main__":
    main()
