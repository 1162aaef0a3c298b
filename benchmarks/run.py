#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The benchmark: ThinPart beside its peers, in one run.

    python3 benchmarks/run.py [--quick] [--parts FOLDER] [-o FILE]

Any Python will do. See README.md in this folder.
"""

import argparse
import hashlib
import json
import os
import subprocess
import sys
import tempfile
from contextlib import ExitStack
from datetime import datetime, timezone
from pathlib import Path

sys.path.insert(0, os.fspath(Path(__file__).resolve().parents[1]))

from benchmarks.children.child_process import Child, ChildError, environment
from benchmarks.children.peer_environment import open_peers
from benchmarks.children.solids import SOLIDS
from benchmarks.comparison import Contestants, compare
from benchmarks.machine import machine, product_version
from benchmarks.places import CACHE, DEBIAN_PYTHON, RESULTS, ROOT
from benchmarks.tables import all_text
from benchmarks.targets import summary
from benchmarks.verdict_times import measure_verdicts

PARTS = ("verdicts", "large", "rays", "peers", "cores", "accuracy")
"""What can be left out: times to a verdict; that of a part of a million triangles; the core's rays; beside them the other
programs, and one core against two; how accurate the values are."""

ALL_SIZES = (1_000, 10_000, 100_000, 1_000_000)
QUICK_SIZES = (1_000, 10_000)
QUICK_SOLIDS = ("casting", "heat_sink")
REPEAT, QUICK_REPEAT = 5, 2


def main(arguments=None):
    """Run the benchmark; the exit status: 1 where a part of it failed, 2 for wrong usage."""
    options = _options(arguments)
    try:
        results = _measured(options)
    except (ChildError, OSError) as error:
        _say(f"benchmarks: {error}")
        return 1
    except KeyboardInterrupt:
        _say("benchmarks: interrupted, nothing was written")
        return 130
    print(all_text(results))
    return 1 if results["failures"] else 0


def _say(text):
    print(text, file=sys.stderr, flush=True)


def _options(arguments):
    parser = argparse.ArgumentParser(
        prog="benchmarks/run.py", description="Measure ThinPart and its peers side by side.")
    parser.add_argument("--quick", action="store_true", help="small sets only, about two minutes")
    parser.add_argument("--only", nargs="+", choices=PARTS, metavar="PART", help=f"some of: {', '.join(PARTS)}")
    parser.add_argument("--without", nargs="+", choices=PARTS, default=[], metavar="PART", help="leave out some of these")
    parser.add_argument("--parts", type=Path, metavar="FOLDER", help="a folder of real parts, beside the made ones")
    parser.add_argument("--sizes", type=int, nargs="+", metavar="N",
                        help="triangles of the meshes (default: 1000 10000 100000 1000000)")
    parser.add_argument("--solids", nargs="+", choices=list(SOLIDS), metavar="NAME",
                        help=f"of which meshes are made, some of: {', '.join(SOLIDS)} (default: all)")
    parser.add_argument("--repeat", type=int, metavar="N", help=f"turns each (default: {REPEAT})")
    parser.add_argument("--classify", default="", metavar="OPTIONS",
                        help="further options of thinpart classify, as one argument")
    parser.add_argument("--reference", type=Path, default=CACHE / "reference", metavar="FOLDER",
                        help="where the accurate measurement is kept (default: in the cache)")
    parser.add_argument("-o", "--output", "--json", type=Path, metavar="FILE",
                        help="results file (default: benchmarks/results/TIME.json)")
    options = parser.parse_args(arguments)
    options.repeat = options.repeat if options.repeat is not None else QUICK_REPEAT if options.quick else REPEAT
    options.sizes = sorted(options.sizes or (QUICK_SIZES if options.quick else ALL_SIZES))
    options.solids = options.solids or list(QUICK_SOLIDS if options.quick else SOLIDS)
    if options.repeat < 1 or any(size < 1 for size in options.sizes):
        parser.error("--repeat and --sizes take numbers from 1 on")
    if options.parts is not None and not options.parts.is_dir():
        _say(f"benchmarks: {options.parts} is no folder, so no real parts are measured")
        options.parts = None
    options.wanted = set(options.only or PARTS) - set(options.without)
    return options


def _measured(options):
    """Measure, and write the results file."""
    started = datetime.now(timezone.utc)
    output = options.output or RESULTS / f"{started:%Y-%m-%d_%H%M}.json"
    output.parent.mkdir(parents=True, exist_ok=True)
    python = _product_python()
    results = {
        "date": started.isoformat(timespec="seconds"), "machine": machine(), "versions": _versions(python),
        "options": {"sizes": options.sizes, "solids": options.solids, "repeat": options.repeat,
                    "parts": sorted(options.wanted), "classify": options.classify},
        "verdicts": [], "meshes": [], "accuracy": [], "missing_peers": {}, "failures": {},
    }
    for name, measure in (("verdicts", _verdicts), ("rays", _rays), ("accuracy", _accuracy)):
        if name not in options.wanted:
            continue
        try:
            measure(results, python, options)
        except ChildError as error:
            results["failures"][name] = str(error)
    results["summary"] = summary(results)
    output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    _say(f"written to {output}")
    return results


def _versions(python):
    with Child(python, "product") as product, Child(python, "tessellation") as freecad:
        return {**product_version(), **product.ask("versions"), **freecad.ask("version")}


def _verdicts(results, python, options):
    results["verdicts"] = measure_verdicts(
        python, CACHE / f"parts-{_recipe(results['versions'], 'made_parts')}", options.parts, options.repeat, options.quick,
        "large" in options.wanted, options.classify.split(), _say)


def _rays(results, python, options):
    with ExitStack() as stack:
        freecad = stack.enter_context(Child(python, "tessellation"))
        peers, pair_loop = {}, None
        if "peers" in options.wanted:
            peers, found, results["missing_peers"] = open_peers(CACHE / "peers", [python, sys.executable], _say)
            for child in peers.values():
                stack.enter_context(child)
            results["versions"].update(found)
            pair_loop = stack.enter_context(Child(python, "pair_loop"))
        results["meshes"], failures = compare(
            Contestants(freecad, pair_loop, peers, "cores" in options.wanted), python, options.solids, options.sizes,
            options.repeat, CACHE / f"meshes-{_recipe(results['versions'], 'tessellation')}", _say)
        results["failures"].update(failures)


def _accuracy(results, python, options):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "accuracy.json"
        command = [python, ROOT / "benchmarks" / "accuracy.py", "--reference", options.reference, "-o", file]
        command += ["--parts", options.parts] if options.parts else []
        run = subprocess.run([*map(str, command), *(["--quick"] if options.quick else [])], env=environment(),
                             stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        if not file.is_file():
            raise ChildError(f"benchmarks/accuracy.py ended with status {run.returncode}.")
        results["accuracy"] = json.loads(file.read_text(encoding="utf-8"))["accuracy"]


def _product_python():
    """The interpreter that the launcher would take: one that lacks nothing that ``classify`` needs."""
    requirements = ROOT / "thinpart_workbench" / "requirements.py"
    lacks = "python3"
    for python in filter(None, (os.environ.get("THINPART_PYTHON"), DEBIAN_PYTHON, sys.executable)):
        try:
            run = subprocess.run([python, requirements, "classify"], capture_output=True, text=True,
                                 stdin=subprocess.DEVNULL)
        except OSError:
            continue
        if run.returncode == 0 and not run.stdout.strip():
            return python
        lacks = " ".join(line.split("\t")[0] for line in run.stdout.splitlines()) or lacks
    raise ChildError(f"No Python here has all that ThinPart needs: apt-get install {lacks}")


def _recipe(versions, module):
    """Changes with whatever makes other files: the solids, FreeCAD, and the module that makes them; str."""
    sources = [(ROOT / "benchmarks" / "children" / f"{name}.py").read_bytes() for name in ("solids", module)]
    text = "".join(str(versions[name]) for name in ("FreeCAD", "OCCT")).encode()
    return hashlib.sha256(b"".join([text, *sources])).hexdigest()[:10]


if __name__ == "__main__":
    sys.exit(main())
