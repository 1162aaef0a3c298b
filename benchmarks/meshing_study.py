"""How parts mesh at one element size and with the proposed ones, by category, with the real Gmsh.

    python3 benchmarks/meshing_study.py FOLDER [--json FILE] [--jobs N] [--mesh-timeout S]

Prints a table; results of earlier runs are taken from the cache. Verdicts, sizes and figures are those of
``thinpart size --check``.
"""

import argparse
import json
import os
import sys
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from thinpart_workbench.api.mesh_sizes import MESH_SECONDS, mesh_sizes
from thinpart_workbench.core.analysis_limits import Limits

COLUMNS = ("category", "parts", "no mesh at one size", "of these meshed as proposed", "no mesh as proposed",
           "poor elements at one size", "as proposed", "share of thin walls with layers", "elements", "of a uniform mesh",
           "elements / estimate")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder")
    parser.add_argument("--json", metavar="FILE", help="write the record of every part too")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--mesh-timeout", type=float, default=MESH_SECONDS, metavar="S")
    options = parser.parse_args()
    limits, parts = Limits(jobs=options.jobs), []
    for outcome in mesh_sizes(options.folder, check=True, limits=limits, mesh_seconds=options.mesh_timeout,
                              report=lambda outcome, progress: print(outcome["file"], file=sys.stderr)):
        parts += outcome.get("parts", ())
    if options.json:
        Path(options.json).write_text(json.dumps(parts), encoding="utf-8")
    print(" | ".join(("", *COLUMNS, "")).strip())
    print("|" + " --- |" * len(COLUMNS))
    for category in ("thin", "thin_features", "normal"):
        own = [part for part in parts if part["category"] == category]
        if own:
            print(" | ".join(("", category, *map(str, row_of(own)), "")).strip())


def row_of(parts):
    """The cells of a category, list of int and str; medians over the parts that have a mesh."""
    default, proposed = ([part["check"][mesh] for part in parts] for mesh in ("default", "proposed"))
    failed = [number for number, mesh in enumerate(default) if not mesh["elements"]]
    meshed = [part for part in parts if part["check"]["proposed"]["elements"]]
    layers = [mesh["layers_share"] for mesh in proposed if mesh["layers_share"] is not None]
    return [len(parts), len(failed), sum(bool(proposed[number]["elements"]) for number in failed),
            len(parts) - len(meshed), _percent(mesh["poor_share"] for mesh in default if mesh["elements"]),
            _percent(mesh["poor_share"] for mesh in proposed if mesh["elements"]), _percent(layers),
            _number(part["check"]["proposed"]["elements"] for part in meshed),
            _percent(part["elements"] / part["uniform_elements"] for part in meshed),
            _number(part["check"]["proposed"]["elements"] / part["elements"] for part in meshed)]


def _percent(values):
    values = list(values)
    return f"{100.0 * median(values):.3g} %" if values else "-"


def _number(values):
    values = list(values)
    return f"{median(values):,.3g}" if values and median(values) < 100 else f"{median(values):,.0f}" if values else "-"


if __name__ == "__main__":
    main()
