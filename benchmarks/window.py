#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How soon a part is coloured in FreeCAD's window, how long the window stands still for it, and how fast it turns.

    /usr/bin/python3 benchmarks/window.py [--turns 3] [--markdown] [-o FILE]
    /usr/bin/python3 benchmarks/window.py --parts FILE... [--markdown] [-o FILE]

Starts the FreeCAD of this machine on a screen of its own. Takes about two minutes; with parts, for each the seconds from the
click to the first colours and to the final map, about a quarter of a minute for each.
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

SECONDS = 3600
"""After which FreeCAD is ended."""


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--turns", type=int, default=3, metavar="N", help="clicks that are timed (default: 3)")
    parser.add_argument("--markdown", action="store_true", help="print a table in Markdown")
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write every single time as JSON")
    parser.add_argument("--parts", nargs="+", type=Path, default=[], metavar="FILE",
                        help="parts that are coloured instead, one after the other")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="thinpart-window-", ignore_cleanup_errors=True) as home:
        found = Path(home, "found.json")
        status = run(ROOT / "benchmarks" / "in_window.py",
                     [os.fspath(ROOT), os.fspath(found), options.turns,
                      [os.fspath(part.resolve()) for part in options.parts]], Path(home), SECONDS)
        if status or not found.is_file():
            print(Path(home, "freecad.log").read_text(encoding="utf-8", errors="replace")[-4000:], file=sys.stderr)
            print(f"window.py: FreeCAD ended with status {status} before all was measured", file=sys.stderr)
            return 1
        results = {"machine": machine(), "versions": product_version(), **json.loads(found.read_text())}
    if options.output is not None:
        options.output.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    print(json.dumps({**results["machine"], **results["versions"]}), file=sys.stderr)
    if options.parts:
        _print_parts(options.parts, results["parts"], options.markdown)
        return 0
    for what, value in _rows(results):
        print(f"| {what} | {value} |" if options.markdown else f"{what:<72} {value:>18}")
    return 0


def _print_parts(files, parts, markdown):
    """One line for each part: how soon it is coloured coarsely and finely. Only the text for a terminal names them."""
    titles = "kB", "faces", "facets at first", "in the map", "first colours, s", "final map, s", "cancelled in, ms"
    rows = [(part["kilobytes"], part["faces"], f"{part['first_facets']:,}", f"{part['facets']:,}", f"{part['first']:.1f}",
             f"{part['final']:.1f}", f"{1000 * part['cancel']:.0f}") for part in parts]
    if markdown:
        for row in (titles, 7 * ["---:"], *rows):
            print("| " + " | ".join(map(str, row)) + " |")
        return
    for name, row in zip(("part", *(file.name for file in files)), (titles, *rows)):
        print(f"{name:<45}" + "".join(f"{value!s:>18}" for value in row))


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
