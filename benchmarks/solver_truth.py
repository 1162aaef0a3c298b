#!/usr/bin/env python3
"""Whether the automatic mesh is good enough, by the solver: first six elastic frequencies of every part of a folder.

    /usr/bin/python3 benchmarks/solver_truth.py [--parts FOLDER] [--most N] [--jobs N] [--minutes M] [--json FILE]

The automatic mesh has tetrahedra of second order, a tenth of the diagonal in size, by Gmsh; the reference is refined until
its frequencies stay. CalculiX solves both, nothing held. Each part has a process of its own, each mesh and each solution a
limit of processor time. What was solved is kept, so that a run that was stopped goes on. Of the parts that the folder's
`manifest.csv` names, all repositories come in turn. Needs Gmsh and CalculiX.
"""

import argparse
import csv
import hashlib
import json
import os
import random
import subprocess
import sys
import time
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from itertools import chain, zip_longest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.places import CACHE, DEBIAN_PYTHON, ROOT

LIMITS = ("60", "240", "32000")
"""Seconds for a mesh, seconds for a solution, and nodes of a reference mesh."""

MOST_SECONDS = 1500.0
"""For a part."""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--most", type=int, metavar="N", help="number of parts; by default all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--minutes", type=float, default=float("inf"), metavar="M", help="start no part after this time")
    parser.add_argument("--json", metavar="FILE", help="write the results of all parts that were solved, now or before")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        parser.error("There is no folder with a manifest.csv: name one with --parts.")
    solved_parts(options)


def default_folder():
    """The folder of labelled parts that the environment names, or that lies beside the checkout: Path or None."""
    named = os.environ.get("THINPART_TRAINING")
    folder = Path(named) if named else ROOT.parent / "shared" / "training"
    return folder if folder.is_dir() else None


def solved_parts(options):
    """The results of parts by file, dict."""
    until = time.monotonic() + 60.0 * options.minutes
    names = in_turn(options.parts)[:options.most]

    def solved(name):
        kept = kept_result(options.parts / name)
        if not kept.exists() and time.monotonic() < until:
            _solve(options.parts / name, kept)
            print(name, kept.read_text()[:110], file=sys.stderr, flush=True)
        return (name, json.loads(kept.read_text())) if kept.exists() else None

    with ThreadPoolExecutor(options.jobs) as pool:
        return dict(filter(None, pool.map(solved, names)))


def in_turn(folder):
    """Files of the manifest with a shape, one of every repository in turn: list of str."""
    of_repository = defaultdict(list)
    with (folder / "manifest.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["kind"] != "mesh":
                of_repository[row["source_repo"]].append(row["file"])
    order = random.Random(1)
    for files in of_repository.values():
        order.shuffle(files)
    return list(filter(None, chain.from_iterable(zip_longest(*of_repository.values()))))


def kept_result(file):
    """The file, Path, in which the result of a part is kept."""
    key = hashlib.sha256("|".join(LIMITS).encode() + file.read_bytes()).hexdigest()
    return CACHE / "solver_truth" / f"{key[:32]}.json"


def _solve(file, kept):
    command = [DEBIAN_PYTHON, str(ROOT / "benchmarks" / "children" / "solved_part.py"), str(file), *LIMITS]
    try:
        end = subprocess.run(command, capture_output=True, text=True, timeout=MOST_SECONDS)
        text = end.stdout if end.returncode == 0 else json.dumps(
            {"outcome": "unknown", "reason": f"status {end.returncode}: {end.stderr.strip()[-200:]}"})
    except subprocess.TimeoutExpired:
        text = json.dumps({"outcome": "unknown", "reason": "the part took too long"})
    kept.parent.mkdir(parents=True, exist_ok=True)
    temporary = kept.with_suffix(".new")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(kept)


if __name__ == "__main__":
    main()
