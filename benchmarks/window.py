#!/usr/bin/env python3
"""How soon a part is coloured in FreeCAD's window, how long the window stands still for it, and how fast it turns.

    /usr/bin/python3 benchmarks/window.py [--turns 3] [--markdown] [-o FILE]

Starts the FreeCAD of this machine on a screen of its own. Takes about two minutes.
"""

import argparse
import json
import os
import sys
import tempfile
from pathlib import Path
from statistics import median

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [os.fspath(ROOT), os.fspath(ROOT / "tests" / "gui")]

from run_in_freecad import run  # noqa: E402

from benchmarks.machine import machine, product_version  # noqa: E402

SECONDS = 1200
"""After which FreeCAD is ended."""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--turns", type=int, default=3, metavar="N", help="clicks that are timed (default: 3)")
    parser.add_argument("--markdown", action="store_true", help="print a table in Markdown")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write every single time as JSON")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="thinpart-window-", ignore_cleanup_errors=True) as home:
        found = Path(home, "found.json")
        status = run(ROOT / "benchmarks" / "in_window.py",
                     [os.fspath(ROOT), os.fspath(found), options.turns], Path(home), SECONDS)
        if status or not found.is_file():
            print(Path(home, "freecad.log").read_text(encoding="utf-8", errors="replace")[-4000:], file=sys.stderr)
            print(f"window.py: FreeCAD ended with status {status} before all was measured", file=sys.stderr)
            return 1
        results = {"machine": machine(), "versions": product_version(), **json.loads(found.read_text())}
    if options.output is not None:
        options.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print(json.dumps({**results["machine"], **results["versions"]}), file=sys.stderr)
    for what, value in _rows(results):
        print(f"| {what} | {value} |" if options.markdown else f"{what:<72} {value:>18}")
    return 0


def _rows(results):
    """Pairs of texts: what was measured, and what came out."""
    turns = results["turns"]
    yield "FreeCAD", results["freecad"]
    yield "triangles of the solid", f"{turns[0]['triangles']:,}"
    for key, text in (("coloured", "click to coloured part"), ("tessellate", "tessellation"),
                      ("measure", "core: everything that is measured")):
        yield f"{text}, s (median of {len(turns)})", f"{median(turn[key] for turn in turns):.2f}"
    ratios = [turn["coloured"] / (turn["tessellate"] + turn["measure"]) for turn in turns]
    yield "click to coloured part / (tessellation + core), median, worst", f"{median(ratios):.2f}, {max(ratios):.2f}"
    yield "longest time without an event, ms, each turn", ", ".join(
        f"{1000 * turn['gap']:.0f}" for turn in turns)
    yield "the same where nothing is done, ms", f"{1000 * results['idle_gap']:.0f}"
    for name, scene in results["scenes"].items():
        times = scene["frames"]
        yield f"{name}: {scene['facets']:,} facets, ms a frame (median of {len(times)})", f"{1000 * median(times):.0f}"


if __name__ == "__main__":
    sys.exit(main())
