# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart's element sizes beside other ways to mesh the same parts, on labelled parts.

    python3 benchmarks/meshing_peers.py FOLDER [--digits 37] [--parts 30] [--normal 11] [--mesh-timeout S] [-o FILE]

FOLDER has ``manifest.csv`` with the columns ``file`` and ``expert_label``, and file names that begin with a letter and a
number. Taken are the first parts whose number ends in one of the digits: so many that an engineer called thin or
thin-featured, and so many normal ones; no files of triangles. Each part has a process of its own, and each mesh another one,
with limits of processor time and memory. What is done is kept, so that a run that was stopped goes on. Results name no part.
"""

import argparse
import csv
import hashlib
import json
import os
import re
import subprocess
import sys
from datetime import date
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.children.child_process import ChildError
from benchmarks.children.peer_environment import installed_python
from benchmarks.machine import machine, product_version
from benchmarks.meshing_tables import meshing_tables
from benchmarks.places import CACHE, DEBIAN_PYTHON, RESULTS, ROOT
from benchmarks.table_text import plain, titled

GROUPS = {"thin": "thin", "thin_features": "thin", "normal": "normal"}
"""Group of parts by the engineer's label."""

PART_FACTOR = 30.0
"""Limit of the time of a part by that of a mesh: all tries and peers by the clock of a busy machine."""


def main(arguments=None):
    """Run, keep the results, and print the tables; the exit status."""
    options = _options(arguments)
    parts = chosen_parts(options.folder, options.digits, {"thin": options.parts, "normal": options.normal})
    if not parts:
        print(f"benchmarks: {options.folder} has no such parts.", file=sys.stderr)
        return 1
    failures, netgen = {}, "missing"
    if options.without_netgen:
        failures["Netgen"] = "left out"
    else:
        try:
            netgen = installed_python(CACHE / "netgen", [sys.executable, DEBIAN_PYTHON], ("netgen-mesher",), _say)
        except ChildError as error:
            failures["Netgen"] = str(error)
    rows = []
    for number, (file, group) in enumerate(parts):
        _say(f"{number + 1} of {len(parts)}")
        found = _figures(file, options, str(netgen))
        if found is None:
            break
        rows.append({"group": group, **found})
    results = {"date": date.today().isoformat(), "machine": machine(),
               "versions": {**product_version(), **_versions(netgen)},
               "meshing": {"digits": options.digits, "seconds": options.mesh_timeout, "megabytes": options.memory,
                           "chosen": len(parts), "parts": rows}, "failures": failures}
    options.output.parent.mkdir(parents=True, exist_ok=True)
    options.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print("\n\n".join(titled(table, plain) for table in meshing_tables(results)))
    return 0


def chosen_parts(folder, digits, counts):
    """Path and group of the parts that are taken, list; see the module.

    Parameters
    ----------
    folder : Path
    digits : str
    counts : dict
        How many at most by group.
    """
    left, chosen = dict(counts), []
    with open(Path(folder) / "manifest.csv", encoding="utf-8", newline="") as file:
        rows = [(Path(folder) / row["file"], row["expert_label"]) for row in csv.DictReader(file)]
    for path, label in sorted(rows):
        number, group = re.match(r"[a-z](\d+)", path.name), GROUPS.get(label)
        if number and number[1][-1] in digits and path.suffix.lower() != ".stl" and left.get(group, 0) > 0:
            left[group] -= 1
            chosen.append((path, group))
    return chosen


def _figures(file, options, netgen):
    """Figures of a part, or why there are none; those of an earlier run with the same settings where there are any. None
    where only these are wanted."""
    what = [str(file.resolve()), file.stat().st_mtime, options.mesh_timeout, options.memory, _sources()]
    kept = CACHE / "meshing_peers" / f"{hashlib.sha256(json.dumps(what).encode()).hexdigest()[:32]}.json"
    if kept.is_file():
        return json.loads(kept.read_text(encoding="utf-8"))
    if options.kept:
        return None
    command = [DEBIAN_PYTHON, os.fspath(ROOT / "benchmarks" / "children" / "meshed_part.py"), os.fspath(file),
               str(options.mesh_timeout), str(options.memory), netgen]
    try:
        run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True,
                             timeout=PART_FACTOR * options.mesh_timeout)
        found = json.loads(run.stdout) if run.returncode == 0 else {"error": "failed", "meshes": {}}
        if run.returncode:
            print(run.stderr[-2000:], file=sys.stderr)
    except subprocess.TimeoutExpired:
        found = {"error": "too long", "meshes": {}}
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text(json.dumps(found), encoding="utf-8")
    return found


def _sources():
    """A hash of what decides the figures."""
    files = sorted(path for folder in ("core", "workflow/meshing")
                   for path in (ROOT / "thinpart_workbench" / folder).rglob("*.py"))
    return hashlib.sha256(b"".join(path.read_bytes() for path in files)).hexdigest()[:16]


def _versions(netgen):
    versions = {}
    for name, command in (("Gmsh", ["gmsh", "--version"]), ("Netgen", [str(netgen), "-m", "pip", "show", "netgen-mesher"])):
        try:
            run = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=60)
        except (OSError, subprocess.TimeoutExpired):
            continue
        found = re.search(r"(?:Version: )?(\d+\.\d[\w.]*)", run.stdout + run.stderr)
        if found:
            versions[name] = found[1]
    return versions


def _options(arguments):
    parser = argparse.ArgumentParser(prog="benchmarks/meshing_peers.py", description=__doc__.partition("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--digits", default="37", help="last digits of the numbers of the parts (default: %(default)s)")
    parser.add_argument("--parts", type=int, default=30, metavar="N",
                        help="thin and thin-featured ones (default: %(default)s)")
    parser.add_argument("--normal", type=int, default=11, metavar="N", help="normal ones (default: %(default)s)")
    parser.add_argument("--mesh-timeout", type=float, default=40.0, metavar="S",
                        help="processor time of each mesh (default: %(default)g)")
    parser.add_argument("--memory", type=int, default=6000, metavar="MB", help="of each process (default: %(default)s)")
    parser.add_argument("--without-netgen", action="store_true", help="do not install and run Netgen")
    parser.add_argument("--kept", action="store_true",
                        help="only the parts that earlier runs have done, up to the first that is missing")
    parser.add_argument("-o", "--output", type=Path, default=RESULTS / f"{date.today().isoformat()}-meshing.json")
    return parser.parse_args(arguments)


def _say(text):
    print(text, file=sys.stderr, flush=True)


if __name__ == "__main__":
    sys.exit(main())
