# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells against solids, with the real solver: tip deflection and first natural frequency of parts made of thin walls.

    python3 benchmarks/shell_study.py [PART...] [--json FILE]

Each part is clamped at one end and loaded at the other. The solid has tetrahedra of second order as large as its thinnest
wall is thick; the change from a mesh twice as coarse says how far it has converged. The shell is that of ``thinpart size
--shell`` with its default element size. Needs Gmsh and CalculiX (``ccx``); prints a table.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.second_order import straightened
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.storage.exchange.shell_files import inp_text
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program, mesh_volume
from thinpart_workbench.workflow.meshing.shell_meshing import shell_of_part

COLUMNS = ("part", "shell nodes", "solid nodes", "degrees of freedom", "deflection", "of shell", "frequency Hz", "of shell",
           "solid twice as coarse: deflection", "frequency")

STEEL = "*MATERIAL, NAME=STEEL\n*ELASTIC\n210000,0.3\n*DENSITY\n7.85e-9\n"
FORCE = 100.0
SECONDS = 900.0


def made_parts():
    """Name, solid, thinnest wall, clamped end and loaded end (axis, side), direction of the force."""
    App = load_freecad()
    import Part

    def box(x, y, z, *at):
        return Part.makeBox(x, y, z, App.Vector(*at))

    def solid(shape):
        return shape.removeSplitter().Solids[0]

    ends = (0, 0), (0, 1)
    yield "plate", box(200, 60, 4), 4.0, *ends, 2
    yield "L profile", solid(box(240, 40, 4).fuse(box(240, 4, 50))), 4.0, *ends, 2
    yield "U profile", solid(box(240, 50, 4).fuse([box(240, 4, 40), box(240, 4, 40, 0, 46, 0)])), 4.0, *ends, 2
    yield "I-beam", solid(box(300, 60, 6).fuse([box(300, 4, 80, 0, 28, 0), box(300, 60, 6, 0, 0, 74)])), 4.0, *ends, 1
    along = App.Vector(1, 0, 0)
    tube = Part.makeCylinder(30, 300, App.Vector(), along).cut(Part.makeCylinder(27, 300, App.Vector(), along))
    yield "tube", tube.Solids[0], 3.0, *ends, 2
    ribs = [box(3, 92, 30, 52, 4, 0), box(3, 92, 30, 105, 4, 0), box(152, 3, 24, 4, 48.5, 0)]
    yield ("box with ribs", solid(box(160, 100, 40).cut(box(152, 92, 40, 4, 4, 4)).fuse(ribs)), 3.0, *ends, 2)
    yield "bent bracket with holes", _bracket(), 3.0, (2, 1), (0, 1), 2


def _bracket():
    import FreeCAD
    import Part

    thick, inner, wide = 3.0, 4.0, 60.0
    outer = inner + thick

    def at(x, z):
        return FreeCAD.Vector(x, 0, z)

    def bend(radius):
        middle = outer - radius * math.sqrt(0.5)
        return Part.Arc(at(outer, outer - radius), at(middle, middle), at(outer - radius, outer)).toShape()

    corners = [at(outer, 0), at(100, 0), at(100, thick), at(outer, thick)]
    upper = [at(thick, outer), at(thick, 70), at(0, 70), at(0, outer)]
    edges = [Part.makeLine(*ends) for row in (corners, upper) for ends in zip(row, row[1:])]
    wire = Part.Wire(Part.__sortEdges__([*edges, bend(inner), bend(outer)]))
    sheet = Part.Face(wire).extrude(FreeCAD.Vector(0, wide, 0))
    for x, y in ((40, 20), (40, 40), (75, 30)):
        sheet = sheet.cut(Part.makeCylinder(6, 20, FreeCAD.Vector(x, y, -5)))
    return sheet.cut(Part.makeCylinder(8, 20, FreeCAD.Vector(-5, 30, 45), FreeCAD.Vector(1, 0, 0))).Solids[0]


def solid_model(program, shape, size, folder, clamped, loaded, around=16):
    """Head of the solver's input for tetrahedra of second order, number of nodes, clamped nodes and share of the force by
    node."""
    from thinpart_workbench.storage.exchange import msh_file

    file, output = os.path.join(folder, "solid.brep"), os.path.join(folder, "solid.msh")
    shape.exportBrep(file)
    reason, _ = mesh_volume(program, [file], output, SECONDS, folder, ("-clmax", repr(size), "-clcurv", str(around),
                                                                      "-order", "2"))
    if reason:
        raise SystemExit(reason)
    points, triangles, _ = msh_file.read_triangles(output, 2)
    tetrahedra = msh_file.read_tetrahedra(output, 2)[1]
    points, _ = straightened(points, tetrahedra)  # else, CalculiX refuses some of real parts
    # Gmsh has the last two nodes of a tetrahedron the other way round.
    tetrahedra = tetrahedra[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
    text = "*NODE, NSET=ALL\n" + "".join(
        f"{row + 1},{x:.10g},{y:.10g},{z:.10g}\n" for row, (x, y, z) in enumerate(points.tolist()))
    text += "*ELEMENT, TYPE=C3D10, ELSET=SOLID\n" + "".join(
        ",".join(map(str, row)) + "\n" for row in np.column_stack([np.arange(1, len(tetrahedra) + 1), tetrahedra + 1]))
    text += STEEL + "*SOLID SECTION, ELSET=SOLID, MATERIAL=STEEL\n"
    force, low, high = np.zeros(len(points)), points.min(axis=0), points.max(axis=0)
    near, axis, end = 1e-6 * np.ptp(points), *_plane(loaded, low, high)
    outer = triangles[(np.abs(points[triangles][:, :, axis] - end) < near).all(axis=1)]
    a, b, c = points[outer[:, :3].T]
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    for column in (3, 4, 5):  # the consistent load of a quadratic triangle is all on the middles of its sides
        np.add.at(force, outer[:, column], areas / 3.0)
    axis, end = _plane(clamped, low, high)
    held = np.flatnonzero(np.abs(points[:, axis] - end) < near)
    return text, len(points), held, force / force.sum()


def _plane(place, low, high):
    """Axis and coordinate of a place: an axis and either a side, int, or a coordinate, float."""
    axis, at = place
    return axis, (low, high)[at][axis] if isinstance(at, int) else at


def shell_model(shell, about, box, clamped, loaded):
    """The same for the shell of a part, whose clamped and loaded walls lie half a thickness inside."""
    mesh = shell.mesh
    points, triangles = mesh.points, mesh.triangles
    near = 0.51 * max(wall["thickness"] for wall in shell.walls)
    (axis, side), force = loaded, np.zeros(len(points))
    at_end = np.abs(points[:, axis] - box[side][axis]) < near
    whole = at_end[triangles].all(axis=1)
    if whole.any():
        for column in (3, 4, 5):
            np.add.at(force, triangles[whole][:, column], mesh.areas[whole] / 3.0)
    else:
        for first, second, middle in ((0, 1, 3), (1, 2, 4), (2, 0, 5)):
            sides = triangles[:, [first, middle, second]]
            own = at_end[sides].all(axis=1)
            length = np.linalg.norm(points[sides[own, 2]] - points[sides[own, 0]], axis=1)
            thick = length * mesh.thickness[own]
            for column, share in zip(range(3), (1 / 6, 2 / 3, 1 / 6)):
                np.add.at(force, sides[own, column], share * thick)
    axis, side = clamped
    held = np.flatnonzero(np.abs(points[:, axis] - box[side][axis]) < near)
    return inp_text(mesh, about), len(points), held, force / force.sum()


def solved(model, direction, folder, rotations):
    """Mean deflection under the force, mm, and the first natural frequency, Hz."""
    text, _, held, share = model
    text += "*NSET, NSET=HELD\n" + "".join(f"{node + 1},\n" for node in held)
    text += f"*BOUNDARY\nHELD,1,{6 if rotations else 3}\n"
    nodes = np.flatnonzero(share)
    static = "*STEP\n*STATIC\n*CLOAD\n" + "".join(
        f"{node + 1},{direction + 1},{FORCE * share[node]:.12g}\n" for node in nodes)
    static += "*NODE FILE" + (", OUTPUT=2D" if rotations else "") + "\nU\n*END STEP\n"
    displaced = displacements(run_solver(text + static, folder, "static") + ".frd")
    deflection = sum(share[node] * displaced[node + 1][direction] for node in nodes)
    dat = run_solver(text + "*STEP\n*FREQUENCY\n2\n*END STEP\n", folder, "modes") + ".dat"
    rows = [line.split() for line in Path(dat).read_text().splitlines()]
    frequency = next(float(row[3]) for row in rows if len(row) >= 4 and row[0] == "1")
    return deflection, frequency


def run_solver(text, folder, name):
    """Solve the input that a text is; the path of its results, without ending."""
    path = os.path.join(folder, name)
    Path(path + ".inp").write_text(text, encoding="utf-8")
    end = subprocess.run([shutil.which("ccx"), name], cwd=folder, capture_output=True, text=True, timeout=SECONDS,
                         env={**os.environ, "OMP_NUM_THREADS": "2"})
    if "Job finished" not in end.stdout:
        raise SystemExit(f"ccx failed:\n{end.stdout[-2000:]}")
    return path


def displacements(path):
    """Displacements of a file of results by node: dict of lists, mm."""
    found, is_on = {}, False
    with open(path, encoding="ascii", errors="replace") as file:
        for line in file:
            if line.startswith(" -4"):
                is_on = "DISP" in line
            elif line.startswith(" -3"):
                is_on = False
            elif is_on and line.startswith(" -1"):
                found[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k]) for k in range(3)]
    return found


def study(program, name, shape, thin, clamped, loaded, direction, folder):
    """Figures of a part, dict."""
    part = SolidPart("part", name, shape=shape)
    settings = AnalysisSettings()
    surface, _ = part.surface_mesh(settings, settings.linear_deflection)
    shell = shell_of_part(part, measure(surface, settings), program, SECONDS)
    box = surface.vertices.min(axis=0) + surface.origin, surface.vertices.max(axis=0) + surface.origin
    middle = shell_model(shell, name, box, clamped, loaded)
    fine, coarse = (solid_model(program, shape, size, folder, clamped, loaded) for size in (thin, 2.0 * thin))
    of_shell = solved(middle, direction, folder, True)
    of_fine, of_coarse = (solved(each, direction, folder, False) for each in (fine, coarse))
    return {"part": name, "shell_nodes": middle[1], "solid_nodes": fine[1], "freedom": 2.0 * middle[1] / fine[1],
            "deflection": of_fine[0], "deflection_off": of_shell[0] / of_fine[0] - 1.0,
            "frequency": of_fine[1], "frequency_off": of_shell[1] / of_fine[1] - 1.0,
            "coarse_deflection_off": of_coarse[0] / of_fine[0] - 1.0,
            "coarse_frequency_off": of_coarse[1] / of_fine[1] - 1.0}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--json", metavar="FILE")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        raise SystemExit("This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx').")
    program, _ = gmsh_program()
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS))
    rows = []
    for made in made_parts():
        if not options.parts or made[0] in options.parts:
            with tempfile.TemporaryDirectory() as folder:
                row = study(program, *made, folder)
            rows.append(row)
            print(f"| {row['part']} | {row['shell_nodes']:,} | {row['solid_nodes']:,} | {row['freedom']:.1%} | "
                  f"{row['deflection']:.4g} mm | {row['deflection_off']:+.1%} | {row['frequency']:.4g} | "
                  f"{row['frequency_off']:+.1%} | {row['coarse_deflection_off']:+.1%} | "
                  f"{row['coarse_frequency_off']:+.1%} |",
                  flush=True)
    if options.json:
        Path(options.json).write_text(json.dumps(rows), encoding="utf-8")


if __name__ == "__main__":
    main()
