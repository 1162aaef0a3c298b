# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shells of real parts against their solids: the first six elastic frequencies of the free part, by CalculiX.

    python3 benchmarks/shell_truth.py FOLDER

FOLDER has a ``manifest.csv``; parts count that people are sure are thin, and whose solid ``benchmarks/solver_truth.py`` has
solved. Prints a row for each part and quantiles of the greatest deviation. Needs Gmsh and CalculiX (``ccx``).
"""

import argparse
import csv
import shutil
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from benchmarks.solver_truth import shipped_reference
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.shells.shell_mesh import ShellMesh
from thinpart_workbench.core.thickness.measurement import measure
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.storage.exchange.shell_files import inp_text
from thinpart_workbench.workflow.meshing.shell_meshing import shell_of_part
from thinpart_workbench.workflow.solving.calculix_program import solve
from thinpart_workbench.workflow.solving.elastic_frequencies import COUNT, RIGID, SIZE, all_frequencies

SECONDS = 120.0
SAME = 1.01
"""Ratio of the diagonals of the part and of its triangles up to which the scale of the solid's frequencies is known: OCC's
box of free-form faces is wider than they are."""


def shell_frequencies(shell, diagonal, calculix):
    """Elastic frequencies of a ShellMesh, free and scaled to the diagonal `SIZE`: ndarray, Hz; and why there are none."""
    scale = SIZE / diagonal
    points = scale * (shell.points - shell.points.mean(axis=0))
    mesh = ShellMesh(points, shell.triangles, shell.wall, scale * shell.thickness)
    with tempfile.TemporaryDirectory(prefix="thinpart-truth-") as folder:
        Path(folder, "modes.inp").write_text(inp_text(mesh, "shell") + f"*STEP\n*FREQUENCY\n{RIGID + COUNT}\n*END STEP\n",
                                             encoding="ascii")
        reason = solve(calculix, "modes", SECONDS, folder)
        return (np.zeros(0) if reason else all_frequencies(str(Path(folder, "modes.dat")))[RIGID:]), reason


def row_of(file, reference, programs):
    """What is printed of a part: dict, or None where its scale is not known."""
    part, = read_parts(str(file)).parts
    settings, diagonal = AnalysisSettings(), part.shape.BoundBox.DiagonalLength
    surface, _ = part.surface_mesh(settings, settings.linear_deflection)
    measurement = measure(surface, settings)
    own = float(np.linalg.norm(np.ptp(measurement.field.mesh.vertices, axis=0)))
    if not own / SAME < diagonal < own * SAME:
        return None
    try:
        shell = shell_of_part(part, measurement, programs[0], SECONDS)
    except ThinPartError as error:
        return {"shell": "none", "error": np.inf, "said": str(error)}
    found, reason = shell_frequencies(shell.mesh, diagonal, programs[1])
    error = np.abs(found / reference["reference"] - 1.0).max() if len(found) == COUNT else np.inf
    return {"shell": "one side" if shell.is_moved else "mid-faces", "nodes": len(shell.mesh.points),
            "solid nodes": reference["reference_nodes"], "volume": shell.volume_share, "error": error,
            "said": reason or ("" if not shell.warnings else "warned")}


def main():
    """Run the study."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    programs = shutil.which("gmsh"), shutil.which("ccx")
    if None in programs:
        raise SystemExit("gmsh and ccx are needed.")
    with open(folder / "manifest.csv", encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if (row["expert_label"], row["confidence"]) == ("thin", "sure")]
    errors = {False: [], True: []}
    for row in rows:
        reference = shipped_reference(folder / row["file"])
        found = reference and row_of(folder / row["file"], reference, programs)
        if not found:
            continue
        errors[bool(found["said"])].append(found["error"])
        print(f"{Path(row['file']).name[:40]:42}{found['shell']:10}{found.get('nodes', 0):8}{found.get('solid nodes', 0):8}"
              f"{found.get('volume', 0.0):7.2f}{100.0 * found['error']:9.1f} %  {found['said'][:40]}", flush=True)
    for is_warned, found in errors.items():
        found = np.array(found)
        print(f"{'warned of' if is_warned else 'without a warning'}: {len(found)} parts, median "
              f"{100.0 * np.median(found):.1f} %, {(found <= 0.05).sum()} within 5 %, {(found <= 0.1).sum()} within 10 %")


if __name__ == "__main__":
    main()
