#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a mesh is worth: nodes and seconds against the error of its solution, for ThinPart's sizes and other ways to mesh.

    /usr/bin/python3 benchmarks/mesh_worth.py [--parts FOLDER] [--most N] [--write]

Solved by CalculiX are the first six elastic frequencies of the free part, and how far it bends where it is held at one end
of its greatest length and bears a force across the other. The reference is the finest mesh of all; a part counts where the
two finest differ by 1 % at most. All meshes are tetrahedra of second order. Of parts that the folder's `manifest.csv` names,
all repositories come in turn; each has a process of its own, and each mesh and each solution a limit of processor time. What
was solved is kept, by the content of the file, so that a run that was stopped goes on. Results name no part. Needs Gmsh,
CalculiX and Netgen (installed from PyPI on first use); for the plot matplotlib.
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.agreement import default_folder
from benchmarks.children.peer_environment import installed_python
from benchmarks.places import CACHE, DEBIAN_PYTHON, RESULTS, ROOT
from benchmarks.solver_truth import in_turn, with_tables
from benchmarks.table_text import plain, titled
from benchmarks.worth_tables import ERRORS, UNIFORM, WorthPart, worth_tables

KEPT = CACHE / "mesh_worth"

PEERS = (*(f"uniform {share:g}" for share in UNIFORM), "curvature", "netgen 2")

DOCUMENT, PLOT = "docs/meshing.md", "docs/plots/mesh_worth.svg"
SHIPPED = RESULTS / "mesh_worth.json"
MARKS = ("<!-- mesh worth -->", "<!-- end of mesh worth -->")

MOST_SECONDS = 3000.0
"""For a part."""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    parser.add_argument("--most", type=int, default=80, metavar="N", help="number of parts")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--minutes", type=float, default=float("inf"), metavar="M", help="start no part after this time")
    parser.add_argument("--only", metavar="WAY", help="solve only meshes whose name begins so")
    parser.add_argument("--write", action="store_true", help=f"put the tables into {DOCUMENT}, and the plot beside it")
    options = parser.parse_args()
    if options.parts is None or not (options.parts / "manifest.csv").is_file():
        parser.error("There is no folder with a manifest.csv: name one with --parts.")
    netgen = installed_python(CACHE / "netgen", [sys.executable, DEBIAN_PYTHON], ("netgen-mesher",), print)
    names = [name for name in (*PEERS, *(f"ThinPart {error:g}" for error in ERRORS)) if name.startswith(options.only or "")]
    until = time.monotonic() + 60.0 * options.minutes
    with ThreadPoolExecutor(options.jobs) as pool:
        files = [options.parts / name for name in in_turn(options.parts)[:options.most]]
        parts = list(filter(None, pool.map(lambda file: _solved(file, names, str(netgen), until), files)))
    print("\n\n".join(titled(table, plain) for table in worth_tables(parts)))
    if options.write:
        from benchmarks.worth_plot import write_plot

        SHIPPED.write_text(json.dumps([{"category": part.category, "meshes": part.meshes} for part in parts]) + "\n",
                           encoding="utf-8")
        document = ROOT / DOCUMENT
        document.write_text(with_tables(document.read_text(encoding="utf-8"), worth_tables(parts), MARKS), encoding="utf-8")
        write_plot(parts, ROOT / PLOT)


def _solved(file, names, netgen, until):
    """What is known of a part, WorthPart; None where nothing is."""
    kept = KEPT / f"{hashlib.sha256(file.read_bytes()).hexdigest()[:32]}.json"
    known = json.loads(kept.read_text(encoding="utf-8")) if kept.exists() else {"category": None, "meshes": {}}
    missing = [name for name in names if name not in known["meshes"]]
    if missing and time.monotonic() < until:
        command = [DEBIAN_PYTHON, str(ROOT / "benchmarks" / "children" / "solved_meshes.py"), str(file), netgen, *missing]
        try:
            text = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                                  timeout=MOST_SECONDS).stdout
        except subprocess.TimeoutExpired as end:
            text = (end.stdout or b"").decode()
        for line in text.splitlines():
            found = json.loads(line)
            if "name" in found:
                known["meshes"][found.pop("name")] = found
            else:
                known.update(found)
        for name in missing:
            known["meshes"].setdefault(name, {"nodes": 0, "elements": 0, "reason": "the part took too long or failed",
                                              "frequencies": [], "deflection": None})
        kept.parent.mkdir(parents=True, exist_ok=True)
        temporary = kept.with_suffix(".new")
        temporary.write_text(json.dumps(known), encoding="utf-8")
        temporary.replace(kept)
        print(file.name, {name: mesh["nodes"] for name, mesh in known["meshes"].items()}, file=sys.stderr, flush=True)
    return WorthPart(known["category"], known["meshes"]) if known["meshes"] else None


if __name__ == "__main__":
    main()
