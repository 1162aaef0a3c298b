# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares the automatic mesh of one part with a converged one, and prints a JSON object.

    solved_part.py FILE MESH_SECONDS SOLVER_SECONDS NODES [straight]

With the last word, meshes that the solver refuses get straight sides at once.

Meshes are made, and solved, by programs of their own with limits of processor time.
"""

import json
import os
import sys
import tempfile
import time
from dataclasses import asdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from thinpart_workbench.freecad_adapter.bootstrap import load_meshing
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.system.process_limits import limit_memory
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program
from thinpart_workbench.workflow.solving.automatic_mesh import SolvingLimits, automatic_mesh_error
from thinpart_workbench.workflow.solving.calculix_program import calculix_program

MEMORY = 8 << 30


def main():
    """Print the figures of a part."""
    file, *limits = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), int(sys.argv[4])
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what FreeCAD prints must not mix with the result
    load_meshing()
    limit_memory(MEMORY)
    part, = read_parts(file).parts
    started = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        shape = os.path.join(folder, "part.brep")
        part.write_brep(shape)
        found = automatic_mesh_error(shape, part.shape.BoundBox.DiagonalLength, gmsh_program()[0], calculix_program()[0],
                                     SolvingLimits(*limits), folder, untangle=sys.argv[5:] != ["straight"])
    json.dump({**asdict(found), "seconds": round(time.perf_counter() - started, 1)}, out)
    out.close()


if __name__ == "__main__":
    main()
