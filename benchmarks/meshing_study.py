# SPDX-License-Identifier: LGPL-2.1-or-later
"""How parts mesh at one element size and with the proposed ones, by category and by family, with the real Gmsh.

    python3 benchmarks/meshing_study.py FOLDER [--json FILE] [--plot FILE.svg] [--jobs N] [--mesh-timeout S]
    python3 benchmarks/meshing_study.py --of FILE.json [--plot FILE.svg]

Prints two tables; results of earlier runs are taken from the cache. Verdicts, sizes and figures are those of
``thinpart size --check``. The family of a part is the kind of wall that has most of its thin area. The second form
makes tables and plot of what the first one wrote.
"""

import argparse
import json
import os
import sys
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.meshing_plot import meshing_plot
from benchmarks.meshing_tables import family_of
from benchmarks.table_text import Table, markdown
from thinpart_workbench.api.mesh_sizes import MESH_SECONDS, MeshRequest, SizeProgress, mesh_sizes
from thinpart_workbench.core.analysis_limits import Limits
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings

LAYERS = SizingSettings(order=1, growth=1.4)
"""Two layers of linear elements in thin walls."""

COLUMNS = ("parts", "no mesh at one size", "of these meshed as proposed", "no mesh as proposed",
           "poor elements at one size", "as proposed", "share of thin walls with layers", "elements", "of a uniform mesh",
           "elements / estimate")

CATEGORIES = ("thin", "thin_features", "normal")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--of", metavar="FILE",
                        help="in place of a folder: the records that --json has written, or the results of meshing_peers")
    parser.add_argument("--json", metavar="FILE", help="write the record of every part too")
    parser.add_argument("--plot", metavar="FILE", help="write a plot of all parts, SVG")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, metavar="N")
    parser.add_argument("--mesh-timeout", type=float, default=MESH_SECONDS, metavar="S")
    options = parser.parse_args()
    if (options.folder is None) == (options.of is None):
        parser.error("name a folder, or a file after --of")
    if options.of:
        parts = read_parts(json.loads(Path(options.of).read_text(encoding="utf-8")))
    else:
        parts = meshed_parts(options)
    if options.json:
        Path(options.json).write_text(json.dumps(parts), encoding="utf-8")
    of_category = [(category, [part for part in parts if part["category"] == category]) for category in CATEGORIES]
    of_family = families([part for part in parts if "regions" in part or "family" in part])
    for name, groups in (("category", of_category), ("family", of_family)):
        rows = [[group, *map(str, row_of(own))] for group, own in groups if own]
        if rows:
            print(markdown(Table("", (name, *COLUMNS), rows)), end="\n\n")
    if options.plot:
        Path(options.plot).write_text(meshing_plot(of_category), encoding="utf-8")


def meshed_parts(options):
    """The records of the parts of a folder, list of dict; where a run is interrupted, the next goes on."""
    parts, limits = [], Limits(jobs=options.jobs)
    request = MeshRequest(LAYERS, check=True, mesh_seconds=options.mesh_timeout)
    for outcome in mesh_sizes(options.folder, request, limits=limits,
                              progress=SizeProgress(counted=lambda outcome, _: print(outcome["file"], file=sys.stderr))):
        parts += outcome.get("parts", ())
    return parts


def read_parts(content):
    """The records of parts of a file: as they are, or made of the results of `meshing_peers`."""
    if isinstance(content, list):
        return content
    return [{"category": row["category"], "elements": row["estimate"], "uniform_elements": row["uniform_elements"],
             **({"family": row["family"]} if "family" in row else {}),  # results of earlier versions have none
             "check": {"default": row["meshes"]["one size"], "proposed": row["meshes"]["ThinPart"]}}
            for row in content["meshing"]["parts"] if "error" not in row]


def families(parts):
    """Family and its parts, list of pairs, the largest first."""
    found = {}
    for part in parts:
        own = part.get("family") or family_of((region["kind"], region["area"]) for region in part["regions"])
        found.setdefault(own, []).append(part)
    return sorted(found.items(), key=lambda each: -len(each[1]))


def row_of(parts):
    """The cells of a category or family, list of int and str; medians over the parts that have a mesh."""
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
