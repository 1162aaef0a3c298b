# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shell and solid in one model against solids, with the real solver: deflection and frequencies of walls on thick bodies.

    python3 benchmarks/mixed_study.py [PART...] [--json FILE] [--training FOLDER]

Each part is held at one place and loaded at another; the six first elastic frequencies are those of the free part. The solid
has tetrahedra of second order about as large as its thinnest wall is thick; the change from a mesh twice as coarse says how
far it has converged. Shell and solid are those of ``thinpart size --shell FILE.inp``. Real parts are compared by their
frequencies. Needs Gmsh and CalculiX (``ccx``); prints a table.
"""

import argparse
import json
import os
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.shell_study import FORCE, SECONDS, displacements, run_solver, solid_model
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.shells.shell_settings import ShellSettings
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.freecad_adapter.bootstrap import load_freecad
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart
from thinpart_workbench.storage.exchange.shell_files import mixed_text
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program
from thinpart_workbench.workflow.meshing.shell_meshing import shell_of_part

COLUMNS = ("part", "walls", "nodes of shell", "of the rest", "of the solid", "deflection", "off", "first frequency held, Hz",
           "off", "six frequencies free: most off", "solid twice as coarse: deflection", "frequency", "six")

REAL = {"plug aligner": ("t262_plug-aligner.stp", 0.5)}
"""Real parts that are walls on a thick body, by name: their file, and the size of the elements of the solid, mm."""

AROUND_REAL = 6
"""Elements around circles of the solid of a real part, which has small ones."""

MODES = 12


def made_parts():
    """Name, solid, size of its elements, where it is held and loaded (axis, coordinate), direction of the force."""
    App = load_freecad()
    import Part

    def box(x, y, z, *at):
        return Part.makeBox(x, y, z, App.Vector(*at))

    def pin(radius, height, *at):
        return Part.makeCylinder(radius, height, App.Vector(*at))

    def solid(shape):
        return shape.removeSplitter().Solids[0]

    yield "plate with boss", solid(box(160, 100, 4).fuse(pin(15, 30, 80, 50, 0))), 4.0, (0, 0.0), (2, 30.0), 0
    ribs = [box(100, 4, 50, 0, y, 20) for y in (6, 28, 50)]
    yield "ribbed block", solid(box(100, 60, 20).fuse(ribs)), 4.0, (2, 0.0), (2, 70.0), 1
    along = App.Vector(1, 0, 0)
    outer = Part.makeCylinder(30, 200, App.Vector(), along).fuse(Part.makeCylinder(55, 16, App.Vector(), along))
    yield ("flanged tube", solid(outer.cut(Part.makeCylinder(27, 200, App.Vector(), along))), 4.5, (0, 0.0), (0, 200.0), 2)
    bracket = box(150, 80, 5).fuse([box(5, 80, 60), pin(22, 40, 150, 40, 0)]).cut(pin(10, 40, 150, 40, 0))
    yield "bracket with hub", solid(bracket), 4.0, (0, 0.0), (2, 40.0), 2


def mixed_model(shell, name, held, loaded):
    """Head of the solver's input, held nodes of shell and solid, and share of the force by node, shell first."""
    mesh, solid = shell.mesh, shell.solid
    count = len(mesh.points)
    points = np.concatenate([mesh.points, solid.points])
    is_shell = np.arange(len(points)) < count
    near, exact = 0.51 * mesh.thickness.max(), 1e-6 * np.ptp(points)

    def on(place):
        axis, at = place
        return np.abs(points[:, axis] - at) < np.where(is_shell, near, exact)

    force = np.zeros(len(points))
    corners = np.concatenate([solid.tetrahedra[:, nodes] for nodes in (
        (0, 1, 2, 4, 5, 6), (0, 1, 3, 4, 9, 7), (1, 2, 3, 5, 8, 9), (0, 2, 3, 6, 8, 7))]) + count
    faces = corners[on(loaded)[corners].all(axis=1)]
    if len(faces):
        a, b, c = points[faces[:, :3]].transpose(1, 0, 2)
        areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
        for column in (3, 4, 5):
            np.add.at(force, faces[:, column], areas / 3.0)
    else:
        for nodes in ((0, 1, 3), (1, 2, 4), (2, 0, 5)):
            sides = mesh.triangles[:, nodes]
            own = (np.abs(mesh.points[sides][..., loaded[0]] - loaded[1]) < exact).all(axis=1)
            weight = np.linalg.norm(mesh.points[sides[own, 1]] - mesh.points[sides[own, 0]], axis=1) * mesh.thickness[own]
            for column, share in zip(range(3), (1 / 6, 1 / 6, 2 / 3)):
                np.add.at(force, sides[own, column], share * weight)
    fixed = np.flatnonzero(on(held))
    return mixed_text(mesh, solid, name), fixed[fixed < count], fixed[fixed >= count], force / force.sum()


def solved(text, held_shell, held_solid, share, direction, folder):
    """Mean deflection under the force, mm, and the first natural frequency, Hz."""
    for name, nodes, freedom in (("HELDSHELL", held_shell, 6), ("HELDSOLID", held_solid, 3)):
        if len(nodes):
            text += f"*NSET, NSET={name}\n" + "".join(f"{node + 1},\n" for node in nodes)
            text += f"*BOUNDARY\n{name},1,{freedom}\n"
    nodes = np.flatnonzero(share)
    static = "*STEP\n*STATIC\n*CLOAD\n" + "".join(
        f"{node + 1},{direction + 1},{FORCE * share[node]:.12g}\n" for node in nodes)
    static += "*NODE FILE, OUTPUT=2D\nU\n*END STEP\n"
    displaced = displacements(run_solver(text + static, folder, "static") + ".frd")
    deflection = sum(share[node] * displaced[node + 1][direction] for node in nodes)
    return deflection, frequencies(text, folder, 2)[0]


def frequencies(text, folder, count):
    """Natural frequencies, ndarray, Hz."""
    dat = run_solver(text + f"*STEP\n*FREQUENCY\n{count}\n*END STEP\n", folder, "modes") + ".dat"
    lines = Path(dat).read_text().split("P A R T I C I P A T I O N")[0].splitlines()
    return np.array([float(words[3]) for words in map(str.split, lines) if len(words) == 5 and words[0].isdigit()])


def study(program, name, part, size, held, loaded, direction, folder):
    """Figures of a part, dict; without those of the part that is held where no place is named."""
    settings = AnalysisSettings()
    surface, _ = part.surface_mesh(settings, settings.linear_deflection)
    shell = shell_of_part(part, measure(surface, settings), program, SECONDS, ShellSettings(has_rest=True))
    if shell.solid is None:
        raise SystemExit(f"{name}: {shell.warnings}")
    found = {"part": name, "walls": 1.0 - shell.solid.volume_share, "shell_nodes": len(shell.mesh.points),
             "rest_nodes": len(shell.solid.points)}
    free = frequencies(mixed_text(shell.mesh, shell.solid, name), folder, MODES)[6:]
    box = surface.vertices.min(axis=0) + surface.origin, surface.vertices.max(axis=0) + surface.origin
    axis = int(np.argmax(box[1] - box[0]))
    held_at, loaded_at = held or (axis, box[0][axis]), loaded or (axis, box[1][axis])
    around = 16 if held else AROUND_REAL
    solids = [solid_model(program, part.shape, each, folder, held_at, loaded_at, around) for each in (size, 2.0 * size)]
    six = [frequencies(solid[0], folder, MODES)[6:] for solid in solids]
    found.update(solid_nodes=solids[0][1], six_off=_most_off(free, six[0]), coarse_six_off=_most_off(six[1], six[0]))
    if held is not None:
        mixed = solved(*mixed_model(shell, name, held, loaded), direction, folder)
        fine, coarse = (solved(text, np.zeros(0, int), nodes, share, direction, folder) for text, _, nodes, share in solids)
        found.update(
            deflection=fine[0], deflection_off=mixed[0] / fine[0] - 1.0, frequency=fine[1],
            frequency_off=mixed[1] / fine[1] - 1.0, coarse_deflection_off=coarse[0] / fine[0] - 1.0,
            coarse_frequency_off=coarse[1] / fine[1] - 1.0)
    return found


def _most_off(values, reference):
    off = values / reference - 1.0
    return float(off[np.argmax(np.abs(off))])


def _row(found):
    def off(key):
        return f"{found[key]:+.1%}" if key in found else "-"

    cells = [found["part"], f"{found['walls']:.0%}", *(f"{found[key]:,}" for key in (
        "shell_nodes", "rest_nodes", "solid_nodes")), f"{found['deflection']:.4g} mm" if "deflection" in found else "-",
        off("deflection_off"), f"{found['frequency']:.4g}" if "frequency" in found else "-", off("frequency_off"),
        off("six_off"), off("coarse_deflection_off"), off("coarse_frequency_off"), off("coarse_six_off")]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("parts", nargs="*", metavar="PART")
    parser.add_argument("--json", metavar="FILE")
    parser.add_argument("--training", metavar="FOLDER", help="folder of the real parts")
    options = parser.parse_args()
    if shutil.which("ccx") is None:
        raise SystemExit("This needs CalculiX: install it (Debian: 'apt-get install calculix-ccx').")
    program, _ = gmsh_program()
    wanted = [(name, SolidPart("part", name, shape=shape), *rest) for name, shape, *rest in made_parts()]
    if options.training:
        wanted += [(name, read_parts(os.path.join(options.training, file)).parts[0], size, None, None, 0)
                   for name, (file, size) in REAL.items()]
    print("| " + " | ".join(COLUMNS) + " |\n|" + " --- |" * len(COLUMNS))
    rows = []
    for each in wanted:
        if not options.parts or each[0] in options.parts:
            with tempfile.TemporaryDirectory() as folder:
                rows.append(study(program, *each, folder))
            print(_row(rows[-1]), flush=True)
    if options.json:
        Path(options.json).write_text(json.dumps(rows), encoding="utf-8")


if __name__ == "__main__":
    main()
