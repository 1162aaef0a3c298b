# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes one part in each way of the table of peers, and prints a JSON object: FILE SECONDS MEGABYTES NETGEN_PYTHON.

Each mesh is made by a program of its own with a limit of processor time; all have the limit of memory of this process.
"""

import json
import os
import shutil
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from benchmarks.meshing_tables import family_of
from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.categories import NORMAL
from thinpart_workbench.core.file_formats import is_shape
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.sizing.element_estimate import PER_CUBE
from thinpart_workbench.core.sizing.size_proposal import propose_sizes
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.freecad_adapter.bootstrap import load_meshing
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.storage.exchange.gmsh_shape import gmsh_ending
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra
from thinpart_workbench.system.process_limits import limit_memory, run_limited
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program, mesh_volume
from thinpart_workbench.workflow.meshing.mesh_check import checked_sizes, mesh_figures, thin_places

AROUND = 20
"""Elements around a circle, of Gmsh's `MeshSizeFromCurvature`."""

CLOSE_EDGES = (2.0, 5.0)
"""Netgen's `closeedgefac`: of its settings *moderate* and *very fine*."""

EQUAL = 1.15
"""Greatest ratio of numbers of elements that are called equal."""

CLOSE = 0.75
"""Share of the elements that are estimated for a uniform mesh from which on that is made, and its elements are counted."""

SEARCHES = 2
"""Meshes that are made at most to find a size with as many elements: the second corrects the first."""


def main():
    """Print the figures of a part."""
    file, seconds, megabytes, netgen = sys.argv[1], float(sys.argv[2]), int(sys.argv[3]), sys.argv[4]
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what FreeCAD prints must not mix with the result
    load_meshing()
    limit_memory(megabytes * 1024 * 1024)
    part, = read_parts(file).parts
    with tempfile.TemporaryDirectory() as folder:
        json.dump(_PartMeshes(part, file, seconds, folder).figures(netgen), out)
    out.close()


class _PartMeshes:
    def __init__(self, part, file, seconds, folder):
        profile = load_profile()
        self._measurement, record = analyse_part(part, AnalysisSettings(), profile)
        self._category, self._seconds, self._folder = record["category"], seconds, folder
        diagonal = self._measurement.descriptors.box.diagonal
        limit = classify(self._measurement.descriptors, profile).thin_limit_x * diagonal
        settings = SizingSettings(order=1, growth=1.4)  # layers are compared
        self._proposal = propose_sizes(self._measurement, limit, settings, only_chosen=self._category == NORMAL)
        # Layers are counted for all meshes at the same places, also where none were asked for.
        *places, _ = thin_places(self._measurement, self._proposal)
        self._walls = (*places, round(settings.wanted_layers))
        self._solid = os.path.join(folder, "part.brep")
        part.write_brep(self._solid)
        self._shape = self._solid
        if is_shape(file):
            self._shape = os.path.join(folder, f"document{gmsh_ending(file)}")
            shutil.copyfile(file, self._shape)
        self._gmsh = gmsh_program()[0]

    def figures(self, netgen):
        """dict: of the part, and of each mesh."""
        kept = {}
        check, tried = checked_sizes(
            self._gmsh, self._shape, self._measurement, self._proposal, self._seconds, self._folder, solid=self._solid,
            on_mesh=lambda name, *mesh: kept.update({name: mesh}))
        one_size, proposed = check["default"], check["proposed"]
        for name, mesh in (("default", one_size), ("proposed", proposed)):
            own = kept.get(name) or kept.get("default")
            if mesh["elements"]:
                mesh["layers_share"] = mesh_figures(0.0, "", *own, self._walls)["layers_share"]
        used = tried.proposal
        found = {"one size": one_size, "ThinPart": proposed, "equal": self._as_many(proposed["elements"], one_size),
                 "curvature": self._gmsh_mesh("-clmax", repr(used.global_size), "-clcurv", str(AROUND), "-setnumber",
                                              "Mesh.CharacteristicLengthExtendFromBoundary", "1")}
        for factor in CLOSE_EDGES:
            found[f"Netgen {factor:g}"] = self._netgen_mesh(netgen, factor)
        uniform = used.uniform_elements
        if proposed["elements"] > CLOSE * uniform and not used.is_uniform:
            # With the method of the proposed mesh: others make more or fewer elements of the same size.
            options = [word for name, value in tried.options.items() for word in ("-setnumber", name, str(value))]
            uniform = self._gmsh_mesh("-clmax", repr(used.least_size), *options)["elements"] or uniform
        family = family_of((each.region.kind, each.region.area) for each in self._proposal.regions)
        return {"category": self._category, "family": family, "estimate": self._proposal.elements,
                "uniform_elements": uniform, "meshes": found}

    def _as_many(self, wanted, one_size):
        """Figures of a mesh of one size with as many elements; None where no number is wanted."""
        if not wanted:
            return None
        if one_size["elements"] and max(wanted, one_size["elements"]) <= EQUAL * min(wanted, one_size["elements"]):
            return one_size
        size = (PER_CUBE * self._measurement.volume_mm3 / wanted) ** (1.0 / 3.0)
        for _ in range(SEARCHES):
            figures = self._gmsh_mesh("-clmax", repr(size))
            count = figures["elements"]
            if not count or max(count, wanted) <= EQUAL * min(count, wanted):
                break
            size *= (count / wanted) ** (1.0 / 3.0)
        return figures

    def _gmsh_mesh(self, *options):
        output, started = os.path.join(self._folder, "peer.msh"), time.perf_counter()
        reason, _ = mesh_volume(self._gmsh, [self._shape], output, self._seconds, self._folder, options)
        mesh = (None, None) if reason else read_tetrahedra(output)
        return self._figures_of(started, reason, *mesh)

    def _netgen_mesh(self, python, factor):
        output, started = os.path.join(self._folder, "peer.npz"), time.perf_counter()
        if os.path.exists(output):
            os.remove(output)
        if not os.path.exists(python):
            return self._figures_of(started, "Netgen is missing")
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_mesh.py")
        end = run_limited([python, script, self._solid, output, repr(self._proposal.global_size), repr(factor)],
                          self._seconds, self._folder)
        if not os.path.exists(output):
            return self._figures_of(started, "too long" if end.timed_out else "failed")
        with np.load(output) as mesh:
            return self._figures_of(started, "", mesh["points"], mesh["tetrahedra"])

    def _figures_of(self, started, reason, points=None, tetrahedra=None):
        took = time.perf_counter() - started
        if tetrahedra is None or not len(tetrahedra):
            return mesh_figures(took, reason or "no volume was filled")
        return mesh_figures(took, "", points, tetrahedra, self._walls)


if __name__ == "__main__":
    main()
