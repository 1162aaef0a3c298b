#!/usr/bin/env python3
"""The benchmark: ThinPart beside its peers, in one run.

    python3 benchmarks/run.py [--quick] [--markdown] [-o FILE]

Any Python will do: with rich, or where Debian's has it. See README.md in this folder.
"""

import argparse
import hashlib
import importlib.util
import json
import os
import subprocess
import sys
from contextlib import ExitStack
from datetime import datetime, timezone
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, os.fspath(ROOT))

DEBIAN_PYTHON = "/usr/bin/python3"
RESULTS = ROOT / "benchmarks" / "results"
CACHE = Path(os.environ.get("THINPART_CACHE") or "~/.cache/thinpart").expanduser() / "benchmarks"

if importlib.util.find_spec("rich") is None:
    if os.path.exists(DEBIAN_PYTHON) and os.path.realpath(sys.executable) != os.path.realpath(DEBIAN_PYTHON):
        os.execv(DEBIAN_PYTHON, [DEBIAN_PYTHON, *sys.argv])
    sys.exit("benchmarks: rich is missing, which prints the tables: apt-get install python3-rich")

from rich.console import Console  # noqa: E402

from benchmarks.child_process import Child, ChildError  # noqa: E402
from benchmarks.command_line import measure_command_line  # noqa: E402
from benchmarks.comparison import Contestants, compare  # noqa: E402
from benchmarks.machine import machine, product_version  # noqa: E402
from benchmarks.peer_environment import open_peers  # noqa: E402
from benchmarks.solids import SOLIDS  # noqa: E402
from benchmarks.tables import markdown, print_results  # noqa: E402
from benchmarks.targets import summary  # noqa: E402

ALL_SIZES = (1_000, 10_000, 100_000, 1_000_000)
QUICK_SIZES = (1_000, 10_000)
NARROWEST = 170
"""Columns of the tables where output is no terminal."""


def main(arguments=None):
    """Run the benchmark; the exit status: 1 where a mesh or the command line failed, 2 for wrong usage."""
    options = _options(arguments)
    say = Console(stderr=True, highlight=False, soft_wrap=True).print
    try:
        results = _stored(options.show) if options.show else _measured(options, say)
    except (ChildError, OSError) as error:
        say(f"benchmarks: {error}", markup=False)
        return 1
    except KeyboardInterrupt:
        say("benchmarks: interrupted, nothing was written")
        return 130
    console = Console()
    if not console.is_terminal:
        console = Console(width=max(console.width, NARROWEST))
    if options.markdown:
        print(markdown(results))
    else:
        print_results(console, results)
    return 1 if results["failures"] else 0


def _options(arguments):
    parser = argparse.ArgumentParser(
        prog="benchmarks/run.py", description="Measure ThinPart and its peers side by side.")
    parser.add_argument("--sizes", type=int, nargs="+", metavar="N",
                        help="triangles wanted (default: 1000 10000 100000 1000000)")
    parser.add_argument("--solids", nargs="+", choices=list(SOLIDS), default=list(SOLIDS), metavar="NAME",
                        help=f"some of: {', '.join(SOLIDS)} (default: all)")
    parser.add_argument("--quick", action="store_true", help="small sizes only: 1000 10000")
    parser.add_argument("--repeat", type=int, default=5, metavar="N", help="turns each (default: 5)")
    parser.add_argument("--no-peers", action="store_true", help="ThinPart and FreeCAD alone")
    parser.add_argument("--no-command-line", action="store_true", help="leave out the command line")
    parser.add_argument("--markdown", action="store_true", help="print the ratios as Markdown instead")
    parser.add_argument("--show", type=Path, metavar="FILE",
                        help="print an earlier results file, measure nothing")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE",
                        help="results file (default: benchmarks/results/TIME.json)")
    options = parser.parse_args(arguments)
    if options.quick and options.sizes:
        parser.error("use either --quick or --sizes")
    if options.repeat < 1 or any(size < 1 for size in options.sizes or ()):
        parser.error("--repeat and --sizes take numbers from 1 on")
    options.sizes = sorted(options.sizes or (QUICK_SIZES if options.quick else ALL_SIZES))
    return options


def _stored(file):
    try:
        results = json.loads(file.read_text(encoding="utf-8"))
    except ValueError:
        results = None
    if not isinstance(results, dict) or not {"meshes", "failures", "summary"} <= results.keys():
        raise ChildError(f"{file} is no results file of this benchmark.")
    return results


def _measured(options, say):
    """Measure, and write the results file."""
    started = datetime.now(timezone.utc)
    output = options.output or RESULTS / f"{started:%Y-%m-%d_%H%M}.json"
    output.parent.mkdir(parents=True, exist_ok=True)
    python = _product_python()
    with ExitStack() as stack:
        freecad = stack.enter_context(Child(python, "tessellation"))
        with Child(python, "product") as product:
            versions = {**product_version(), **product.ask("versions"), **freecad.ask("version")}
        peers, missing, pair_loop = {}, {}, None
        if not options.no_peers:
            peers, found, missing = open_peers(CACHE / "peers", [python, sys.executable], say)
            for child in peers.values():
                stack.enter_context(child)
            versions.update(found)
            pair_loop = stack.enter_context(Child(python, "pair_loop"))
        rows, failures = compare(
            Contestants(freecad, pair_loop, peers), python, options.solids, options.sizes, options.repeat,
            CACHE / f"meshes-{_recipe(versions)}", say,
        )
    times = None
    if not options.no_command_line:
        try:
            times = measure_command_line(options.repeat, say)
        except ChildError as error:
            failures["command line"] = str(error)
    results = {
        "date": started.isoformat(timespec="seconds"), "machine": machine(), "versions": versions,
        "options": {"sizes": options.sizes, "solids": options.solids, "repeat": options.repeat},
        "meshes": rows, "command_line": times, "missing_peers": missing, "failures": failures,
    }
    results["summary"] = summary(results)
    output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    say(f"written to {output}")
    return results


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


def _recipe(versions):
    """Changes with whatever makes other meshes: the solids and FreeCAD."""
    sources = [(ROOT / "benchmarks" / name).read_bytes() for name in ("solids.py", "tessellation.py")]
    text = "".join(str(versions[name]) for name in ("FreeCAD", "OCCT")).encode()
    return hashlib.sha256(b"".join([text, *sources])).hexdigest()[:10]


if __name__ == "__main__":
    sys.exit(main())
