#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prisms against tetrahedra and shells: nodes against the error of the first six elastic frequencies, by CalculiX.

    /usr/bin/python3 benchmarks/prism_study.py PART...
    /usr/bin/python3 benchmarks/prism_study.py --count [--parts FOLDER]

For each part, a line of a table: its width by its thickness, nodes and error of ThinPart's proposal (second order, for
2 %), of one layer of prisms of second order (C3D15) with the fewest nodes that are within 2 %, and of the shell of
``thinpart size --shell`` at its own size, and with the fewest nodes within 2 %. Prisms are made where the part is one
extrusion: a plane face by the part's extent along its normal is the volume. The reference has tetrahedra of one size,
refined until frequencies change by less than 0.5 % at twice the nodes of the proposal, or to 25,000 nodes. --count says how
many of the clear thin parts of a folder are one extrusion.
"""

import argparse
import csv
import os
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.agreement import default_folder
from benchmarks.children.solved_meshes import MESH_SECONDS, MOST_NODES, SOLVER_SECONDS, SolvedPart
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.shells.shell_settings import ShellSettings
from thinpart_workbench.freecad_adapter.bootstrap import load_meshing
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.freecad_adapter.shapes.brep_file import write_brep
from thinpart_workbench.storage.exchange.geo_file import faces_text
from thinpart_workbench.storage.exchange.msh_file import read_triangles
from thinpart_workbench.storage.exchange.shell_files import inp_text
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program, mesh_surface
from thinpart_workbench.workflow.meshing.shell_meshing import shell_of_part
from thinpart_workbench.workflow.solving.automatic_mesh import CONVERGED, largest_change
from thinpart_workbench.workflow.solving.calculix_program import calculix_program, solve
from thinpart_workbench.workflow.solving.elastic_frequencies import COUNT, RIGID, SIZE, ZERO
from thinpart_workbench.workflow.solving.solid_model import STEEL

ERROR = 0.02

SHARES = (0.2, 0.14, 0.1, 0.07, 0.05, 0.035, 0.025, 0.018, 0.0125)
"""Sizes of elements, of the diagonal, from the coarsest."""

OF_SHELL = (2.0, 1.4, 1.0, 0.7, 0.5)
"""Sizes of elements of shells, of their own."""

AROUND = 6
"""Prisms around a circle at least."""

SAME = 1e-4
"""Relative difference of volumes that counts as none."""

COLUMNS = ("part", "width by thickness", "reference nodes", "its change", "proposal: nodes", "error", "prisms: nodes",
           "error", "shell: nodes", "error", "fewest of shell", "error")


def extruded(shape):
    """The largest plane face by which a solid is one extrusion, and the vector to the other end; None where it is none."""
    diagonal, volume = shape.BoundBox.DiagonalLength, shape.Volume
    planes = [face for face in shape.Faces
              if face.Area * diagonal > volume and face.Surface.isDerivedFrom("Part::GeomPlane")]
    areas = np.array([face.Area for face in planes])
    # The other end is as large.
    ends = [row for row, area in enumerate(areas) if np.sum(np.abs(areas / area - 1.0) < SAME) > 1]
    corners = np.array(shape.tessellate(0.01 * diagonal)[0]) if ends else None
    for face in (planes[row] for row in sorted(ends, key=lambda row: -areas[row])):
        normal = face.normalAt(0.0, 0.0)
        heights = (corners - np.array(face.CenterOfMass)) @ np.array(normal)
        depth = np.ptp(heights)
        if abs(face.Area * depth / volume - 1.0) < SAME:
            return face, normal * float(heights[np.argmax(np.abs(heights))])
    return None


def prisms(face, vector, size, folder):
    """Points and prisms of second order, in the order of CalculiX, of one layer; None where Gmsh makes none."""
    script, output = os.path.join(folder, "face.geo"), os.path.join(folder, "face.msh")
    write_brep(face, os.path.join(folder, "face.brep"))
    Path(script).write_text(faces_text("face.brep", [size]), encoding="ascii")
    reason, _ = mesh_surface(gmsh_program()[0], script, output, MESH_SECONDS, folder, AROUND, 2)
    if reason:
        return None
    points, triangles, _ = read_triangles(output, 2)
    first, second, third = points[triangles[:, :3].T]
    turned = np.cross(second - first, third - first) @ vector < 0.0
    triangles[turned] = triangles[turned][:, [0, 2, 1, 5, 4, 3]]
    count, corners = len(points), triangles[:, :3]
    nodes = np.concatenate([points, points + vector, points + 0.5 * vector])
    middles = triangles[:, 3:]
    numbers = np.concatenate([corners, corners + count, middles, middles + count, corners + 2 * count], axis=1)
    used, numbers = np.unique(numbers, return_inverse=True)
    return nodes[used], numbers.reshape(-1, 15)


def prism_text(points, elements):
    """The model as CalculiX reads it, str."""
    nodes = "".join(f"{row},{x:.12g},{y:.12g},{z:.12g}\n" for row, (x, y, z) in enumerate(points.tolist(), start=1))
    rows = "".join(f"{row},{','.join(map(str, own))}\n" for row, own in enumerate((elements + 1).tolist(), start=1))
    return (f"*NODE, NSET=ALL\n{nodes}*ELEMENT, TYPE=C3D15, ELSET=SOLID\n{rows}{STEEL}"
            "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL\n")


def frequencies(text, folder):
    """The first six elastic frequencies of a free body, ndarray, Hz; fewer where there are none."""
    Path(folder, "free.inp").write_text(f"{text}*STEP\n*FREQUENCY\n{RIGID + COUNT}\n*END STEP\n", encoding="ascii")
    if solve(calculix_program()[0], "free", SOLVER_SECONDS, folder):
        return np.zeros(0)
    text = Path(folder, "free.dat").read_text(encoding="ascii", errors="replace").partition("P A R T I C I P A T I O N")[0]
    rows = [line.split() for line in text.splitlines()]
    found = np.sort([float(row[3]) for row in rows if len(row) == 5 and row[0].isdigit()])
    return found[found > ZERO * found.max(initial=0.0)][:COUNT]


def study(file, folder):
    """The cells of a part's line, list of str."""
    part, = read_parts(file).parts
    solved = SolvedPart(file, "", folder)
    scale = solved.diagonal / SIZE
    proposal = solved.solved(solved.by_thinpart(ERROR))
    reference, change, nodes = _reference(solved, 2 * proposal["nodes"])
    tetrahedra = np.array(proposal["frequencies"])
    box = solved.measurement.descriptors.box.dimensions
    wall = solved.record["descriptors"]["thickness_mm"]["median"]
    cells = [Path(file).stem[:4], f"{box[1] / wall:.0f}", f"{nodes:,}", f"{change:.1%}", f"{proposal['nodes']:,}",
             _error(tetrahedra, reference)]
    found = extruded(part.shape)
    rows = []
    for share in SHARES if found else ():
        made = prisms(found[0], np.array(found[1]), share * solved.diagonal, folder)
        if made is not None and len(made[0]) <= MOST_NODES:
            rows.append((len(made[0]), scale * frequencies(prism_text(*made), folder)))
            if _is_within(rows[-1][1], reference):
                break
    cells += _fewest(rows, reference) if found else ["no extrusion", ""]
    try:
        rows = _shells(part, solved, scale, folder)
    except ThinPartError as error:
        return [*cells, f"none: {error}", "", "", ""]
    own = rows[OF_SHELL.index(1.0)]
    return [*cells, f"{own[0]:,}", _error(own[1], reference), *_fewest(rows, reference)]


def _reference(solved, least):
    """Frequencies, the change to those of the mesh before, and nodes, at least so many where that can be solved."""
    last, change, nodes = None, np.inf, 0
    for share in SHARES[2:]:
        found = solved.solved(solved.uniform(share))
        if found["nodes"] > MOST_NODES:
            break
        if len(found["frequencies"]) == COUNT:
            own = np.array(found["frequencies"])
            change = np.inf if last is None else largest_change(last, own)
            last, nodes = own, found["nodes"]
            if change < CONVERGED / 2.0 and nodes >= least:
                break
    return last, change, nodes


def _shells(part, solved, scale, folder):
    gmsh, rows = gmsh_program()[0], []
    own = shell_of_part(part, solved.measurement, gmsh, MESH_SECONDS)
    for factor in OF_SHELL:
        shell = own if factor == 1.0 else shell_of_part(part, solved.measurement, gmsh, MESH_SECONDS,
                                                        ShellSettings(size=factor * own.size))
        rows.append((len(shell.mesh.points), scale * frequencies(inp_text(shell.mesh, "part"), folder)))
    return rows


def _fewest(rows, reference):
    """Nodes and error of the coarsest mesh that is within the error, or of the best."""
    rows = [row for row in rows if len(row[1]) == COUNT]
    if not rows or reference is None:
        return ["failed", ""]
    within = [row for row in rows if _is_within(row[1], reference)]
    nodes, own = min(within or rows, key=lambda row: row[0] if within else largest_change(row[1], reference))
    return [f"{nodes:,}", _error(own, reference)]


def _is_within(own, reference):
    return reference is not None and len(own) == COUNT and largest_change(own, reference) <= ERROR


def _error(own, reference):
    return "" if reference is None or len(own) < COUNT else f"{largest_change(own, reference):.1%}"


def count_extrusions(folder):
    """Names of the clear thin parts of a folder, and of those that are one extrusion: two lists."""
    with open(folder / "manifest.csv", encoding="utf-8", newline="") as file:
        names = [row["file"] for row in csv.DictReader(file) if (row["expert_label"], row["confidence"]) == ("thin", "sure")]
    found = []
    for name in names:
        shapes = [part.shape for part in read_parts(str(folder / name)).parts if hasattr(part, "shape")]
        if len(shapes) == 1 and extruded(shapes[0]):
            found.append(name)
    return names, found


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("files", nargs="*", metavar="PART")
    parser.add_argument("--count", action="store_true", help="count the parts that are one extrusion")
    parser.add_argument("--parts", type=Path, default=default_folder(), metavar="FOLDER")
    options = parser.parse_args()
    load_meshing()
    if options.count:
        names, found = count_extrusions(options.parts)
        print(f"{len(found)} of {len(names)} clear thin parts are one extrusion:", *found, sep="\n")
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS), flush=True)
    for file in options.files:
        with tempfile.TemporaryDirectory() as folder:
            print("| " + " | ".join(study(file, folder)) + " |", flush=True)


if __name__ == "__main__":
    main()
