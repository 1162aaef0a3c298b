#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the automatic mesh is good enough, by the solver: first six elastic frequencies of every part of a folder.

    /usr/bin/python3 benchmarks/solver_truth.py [--parts FOLDER] [--info-dir FOLDER] [--kept] [--markdown] [--write]

The automatic mesh has tetrahedra of second order, a tenth of the diagonal in size, by Gmsh; the reference is refined until
its frequencies stay. CalculiX solves both, nothing held. Each part has a process of its own, each mesh and each solution a
limit of processor time. What was solved is kept, by the content of the file, so that a run that was stopped goes on; that of
`results/solver_truth.json` need not be solved anew. Of the parts that the folder's
`manifest.csv` names (see agreement.py), all repositories come in turn.

Then the parts are classified, and the tables say how often the automatic mesh is in trouble by label and by verdict, and how
well labels, verdicts and quantities foretell it. Needs Gmsh and CalculiX, for the plot matplotlib.
"""

import argparse
import hashlib
import json
import os
import random
import subprocess
import sys
import tempfile
import time
from collections import defaultdict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields
from itertools import chain, zip_longest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.agreement import default_folder, labelled_parts, manifest
from benchmarks.places import CACHE, DEBIAN_PYTHON, RESULTS, ROOT
from benchmarks.solver_tables import solved_part, tables
from benchmarks.table_text import markdown, plain, titled
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.workflow.solving.automatic_mesh import NOT_SOLVED, AutomaticMesh

KINDS = ("solver_truth", "solver_truth_straight")
"""What is solved: the automatic mesh; and with straight edges where the solver refuses it otherwise."""

LIMITS = ("60", "240", "32000")
"""Seconds for a mesh, seconds for a solution, and nodes of a reference mesh."""

MOST_SECONDS = 1500.0
"""For a part."""

DOCUMENT, PLOT = "docs/method.md", "docs/plots/solver_truth.svg"
SHIPPED = RESULTS / "solver_truth.json"
"""What was solved, by what and by the content of the file, of parts that are not named."""

MARKS = ("<!-- solver truth -->", "<!-- end of solver truth -->")

PROFILES = ("calibrated", "paper")


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--most", type=int, metavar="N", help="number of parts; by default all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--minutes", type=float, default=float("inf"), metavar="M", help="start no part after this time")
    parser.add_argument("--kept", action="store_true", help="solve nothing: take what was solved before")
    parser.add_argument("--profile", action="append", metavar="NAME-or-FILE",
                        help=f"whose verdicts are compared; may be given several times (default: {', '.join(PROFILES)})")
    parser.add_argument("--info-dir", metavar="FOLDER", help="keeps what was measured there for the next run")
    parser.add_argument("--markdown", action="store_true", help="tables as in docs/method.md")
    parser.add_argument("--plot", metavar="FILE", help="write the plot, as SVG")
    parser.add_argument("--write", action="store_true", help=f"put the tables into {DOCUMENT}, and the plot beside it")
    parser.add_argument("--json", metavar="FILE", help="write a row for each part")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        parser.error("There is no folder with a manifest.csv: name one with --parts.")
    truth = solved(options.parts, options.most, options.jobs, 0.0 if options.kept else options.minutes)
    if not truth:
        parser.error("No part was solved yet: leave --kept out.")
    profiles = [load_profile(name) for name in options.profile or PROFILES]
    with tempfile.TemporaryDirectory() as temporary:
        labelled = labelled_parts(options.parts, profiles[0], options.info_dir or temporary, truth)
    parts = [solved_part(part, truth[part.file], profiles) for part in labelled]
    show = markdown if options.markdown else plain
    print("\n\n".join(titled(table, show) for table in tables(parts, profiles)))
    if options.write:
        document = ROOT / DOCUMENT
        SHIPPED.write_text(json.dumps(_all_kept(), indent=0, sort_keys=True) + "\n", encoding="utf-8")
        document.write_text(with_tables(document.read_text(encoding="utf-8"), tables(parts, profiles)), encoding="utf-8")
    for file in filter(None, (options.plot, options.write and ROOT / PLOT)):
        from benchmarks.solver_plot import write_plot

        write_plot(parts, profiles, file)
    if options.json:
        Path(options.json).write_text(json.dumps([part.row(profiles) for part in parts], indent=1), encoding="utf-8")


def with_tables(text, results, marks=MARKS):
    """A document with other tables between two marks, str."""
    start, end = (text.index(mark) for mark in marks)
    shown = "\n\n".join(f"**{table.title}**\n\n{markdown(table)}" for table in results)
    return f"{text[:start]}{marks[0]}\n\n{shown}\n\n{text[end:]}"


def solved(folder, most, jobs, minutes):
    """What became of the automatic meshes of parts, dict of AutomaticMesh by file.

    Parameters
    ----------
    folder : Path
    most : int or None
        Number of parts.
    jobs : int
        Parts that are solved at the same time.
    minutes : float
        After which no part is started.
    """
    until = time.monotonic() + 60.0 * minutes
    shipped = json.loads(SHIPPED.read_text(encoding="utf-8")) if SHIPPED.exists() else {}

    def result(name, kind, *more):
        kept = _kept(folder / name, kind)
        if not kept.exists() and f"{kind}/{kept.stem}" in shipped:
            return shipped[f"{kind}/{kept.stem}"]
        if not kept.exists() and time.monotonic() < until:
            _solve(folder / name, kept, more)
            print(name, kept.read_text()[:110], file=sys.stderr, flush=True)
        return json.loads(kept.read_text()) if kept.exists() else None

    def one(name):
        found = result(name, KINDS[0])
        if found and found["outcome"] == NOT_SOLVED and "is_straight" not in found:  # by a version that did not try that
            found = result(name, KINDS[1], "straight")
        return found and (name, _automatic_mesh(found))

    with ThreadPoolExecutor(jobs) as pool:
        return dict(filter(None, pool.map(one, in_turn(folder)[:most])))


def in_turn(folder):
    """Files of the manifest with a shape, one of every repository in turn: list of str."""
    of_repository = defaultdict(list)
    for name, row in manifest(folder).items():
        if row["kind"] != "mesh":
            of_repository[row["source_repo"]].append(name)
    order = random.Random(1)
    for files in of_repository.values():
        order.shuffle(files)
    return list(filter(None, chain.from_iterable(zip_longest(*of_repository.values()))))


def _automatic_mesh(content):
    return AutomaticMesh(**{field.name: content[field.name] for field in fields(AutomaticMesh) if field.name in content})


def _kept(file, kind):
    key = hashlib.sha256("|".join(LIMITS).encode() + file.read_bytes()).hexdigest()
    return CACHE / kind / f"{key[:32]}.json"


def shipped_reference(file):
    """What was solved of a part before, dict; None where its solid has no converged frequencies."""
    found = _all_kept().get(f"{KINDS[0]}/{_kept(file, KINDS[0]).stem}")
    return found if found and found.get("reference") else None


def _all_kept():
    """All results, dict: those of before and those that were kept since."""
    found = json.loads(SHIPPED.read_text(encoding="utf-8")) if SHIPPED.exists() else {}
    for kind in KINDS:
        for kept in (CACHE / kind).glob("*.json"):
            found[f"{kind}/{kept.stem}"] = json.loads(kept.read_text(encoding="utf-8"))
    return found


def _solve(file, kept, more):
    command = [DEBIAN_PYTHON, str(ROOT / "benchmarks" / "children" / "solved_part.py"), str(file), *LIMITS, *more]
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
