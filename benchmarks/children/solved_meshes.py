# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes a part in several ways, solves each mesh, and prints a JSON object a line: FILE NETGEN_PYTHON NAME...

Names: ``uniform SHARE``, of the diagonal; ``curvature``, Gmsh's sizes from it; ``netgen FACTOR``, its `closeedgefac`;
``ThinPart ERROR``, its sizes for an error aimed at. Meshes are made, and solved, by programs of their own with limits of
processor time.
"""

import json
import os
import sys
import tempfile
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.errors import ThinPartError
from thinpart_workbench.core.judging.classification import classify
from thinpart_workbench.core.judging.criteria import load_profile
from thinpart_workbench.core.mesh.second_order import straightened
from thinpart_workbench.core.mesh.tetrahedra import POOR, radius_ratios
from thinpart_workbench.core.sizing.size_proposal import propose_sizes
from thinpart_workbench.core.sizing.sizing_settings import SizingSettings
from thinpart_workbench.freecad_adapter.bootstrap import load_meshing
from thinpart_workbench.freecad_adapter.reading.part_files import read_parts
from thinpart_workbench.storage.exchange.msh_file import read_tetrahedra, read_triangles
from thinpart_workbench.system.process_limits import limit_memory, run_limited
from thinpart_workbench.workflow.analysis.analyse_part import analyse_part
from thinpart_workbench.workflow.meshing.gmsh_program import gmsh_program, mesh_volume, stated_error
from thinpart_workbench.workflow.meshing.mesh_check import MESH, checked_sizes
from thinpart_workbench.workflow.solving.calculix_program import calculix_program
from thinpart_workbench.workflow.solving.elastic_frequencies import COUNT, elastic_frequencies
from thinpart_workbench.workflow.solving.tip_deflection import tip_deflection

MEMORY = 8 << 30

MESH_SECONDS, SOLVER_SECONDS, MOST_NODES = 60.0, 120.0, 25_000

AROUND = 12
"""Elements around a circle, of Gmsh's sizes from curvature, as FreeCAD proposes them."""

END = 0.1
"""Share of the length within which a face at an end lies."""


@dataclass
class Mesh:
    """A mesh of second order; without points, `reason` says why there is none.

    `surface` has the numbers of the faces on which `triangles` lie, from 1.
    """

    points: np.ndarray
    tetrahedra: np.ndarray
    triangles: np.ndarray
    surface: np.ndarray
    reason: str = ""


def no_mesh(reason):
    """A `Mesh` without points."""
    return Mesh(np.zeros((0, 3)), np.zeros((0, 10), int), np.zeros((0, 6), int), np.zeros(0, int), reason)


class SolvedPart:
    """Meshes and solutions of one part.

    Parameters
    ----------
    file : str
    netgen : str
        Path of a Python with Netgen.
    folder : str
        A temporary one.
    """

    def __init__(self, file, netgen, folder):
        part, = read_parts(file).parts
        profile = load_profile()
        self.measurement, self.record = analyse_part(part, AnalysisSettings(), profile)
        box = self.measurement.descriptors.box
        self._limit = classify(self.measurement.descriptors, profile).thin_limit_x * box.diagonal
        self._netgen, self.folder, self.estimate = netgen, folder, None
        self.diagonal = part.shape.BoundBox.DiagonalLength
        self.shape = os.path.join(folder, "part.brep")
        part.write_brep(self.shape)
        self._gmsh, self._calculix = gmsh_program()[0], calculix_program()[0]
        self._ends = self._faces_at_ends(box)
        self._across = np.asarray(box.axes)[int(np.argmin(box.dimensions))]

    def figures(self, name):
        """Figures of a way to mesh the part: dict."""
        kind, _, value = name.partition(" ")
        ways = {"uniform": self.uniform, "curvature": self.curvature, "netgen": self.by_netgen, "ThinPart": self.by_thinpart}
        self.estimate = None
        started = time.process_time() + _of_children()
        mesh = ways[kind](*([float(value)] if value else []))
        seconds = time.process_time() + _of_children() - started
        return {"name": name, "mesh_seconds": round(seconds, 2), "estimate": self.estimate, **self.solved(mesh)}

    def solved(self, mesh):
        """Frequencies and deflection of a mesh, and what it is made of: dict."""
        found = {"nodes": len(mesh.points), "elements": len(mesh.tetrahedra), "reason": mesh.reason, "frequencies": [],
                 "deflection": None, "solver_seconds": 0.0}
        if not len(mesh.tetrahedra) or len(mesh.points) > MOST_NODES:
            return found
        found["poor"] = float(np.mean(radius_ratios(mesh.points, mesh.tetrahedra[:, :4]) < POOR))
        started = _of_children()
        own, reason = elastic_frequencies(mesh.points, mesh.tetrahedra, self.diagonal, self._calculix, SOLVER_SECONDS,
                                          self.folder)
        found["solver_seconds"] = round(_of_children() - started, 2)
        if len(own) < COUNT:
            return {**found, "reason": reason or "too few frequencies"}
        found["frequencies"] = own.tolist()
        held, loaded = (np.isin(mesh.surface, faces) for faces in self._ends)
        if held.any() and loaded.any():
            bent, reason = tip_deflection(mesh.points, mesh.tetrahedra, mesh.triangles[held], mesh.triangles[loaded],
                                          self._across, self._calculix, SOLVER_SECONDS, self.folder)
            found.update(deflection=None if np.isnan(bent) else bent, reason=reason)
        return found

    def uniform(self, share):
        """A mesh of one size, a share of the diagonal."""
        return self._by_gmsh([self.shape], "-clmax", repr(share * self.diagonal))

    def curvature(self):
        """A mesh with Gmsh's sizes from curvature."""
        return self._by_gmsh([self.shape], "-clmax", repr(0.1 * self.diagonal), "-clcurv", str(AROUND))

    def by_netgen(self, factor):
        """A mesh by Netgen."""
        output = os.path.join(self.folder, "netgen.npz")
        if os.path.exists(output):
            os.remove(output)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_mesh.py")
        end = run_limited([self._netgen, script, self.shape, output, repr(0.1 * self.diagonal), repr(factor), "2"],
                          MESH_SECONDS, self.folder)
        if not os.path.exists(output):
            return no_mesh("too long" if end.timed_out else "failed")
        with np.load(output) as mesh:
            return Mesh(mesh["points"], mesh["tetrahedra"], mesh["triangles"], mesh["surface"])

    def by_thinpart(self, error):
        """The mesh of ``thinpart size --error``, with all that it tries."""
        proposal = propose_sizes(self.measurement, self._limit, SizingSettings(error=error))
        check, _ = checked_sizes(self._gmsh, self.shape, self.measurement, proposal, MESH_SECONDS, self.folder,
                                 {"elements": 0, "reason": ""})
        figures = check["proposed"]
        self.estimate = proposal.nodes, proposal.elements
        return self._read(figures["reason"]) if figures["elements"] else no_mesh(figures["reason"])

    def _by_gmsh(self, inputs, *options):
        """A mesh that the solver takes."""
        mesh = self._meshed(inputs, "-order", "2", *options)
        return replace(mesh, points=straightened(mesh.points, mesh.tetrahedra)[0])

    def _meshed(self, inputs, *options):
        output = os.path.join(self.folder, MESH)
        if os.path.exists(output):
            os.remove(output)
        reason, text = mesh_volume(self._gmsh, inputs, output, MESH_SECONDS, self.folder, options)
        return no_mesh(reason) if reason else self._read(stated_error(text))

    def _read(self, reason):
        output = os.path.join(self.folder, MESH)
        try:
            points, tetrahedra = read_tetrahedra(output, 2)
            _, triangles, surface = read_triangles(output, 2)
        except ThinPartError:
            return no_mesh("incomplete")
        return Mesh(points, tetrahedra, triangles, surface) if len(tetrahedra) else no_mesh(reason or "no volume")

    def _faces_at_ends(self, box):
        """Numbers, from 1, of the faces that are held and of those that bear the force."""
        mesh = self.measurement.field.mesh
        along = np.asarray(box.axes)[int(np.argmax(box.dimensions))]
        at, count = mesh.vertices @ along, int(mesh.face_of_triangle.max()) + 1
        low, high = np.full(count, np.inf), np.full(count, -np.inf)
        for corner in mesh.triangles.T:
            np.minimum.at(low, mesh.face_of_triangle, at[corner])
            np.maximum.at(high, mesh.face_of_triangle, at[corner])
        least, most = at.min(), at.max()
        margin = END * (most - least)
        held, loaded = np.flatnonzero(high < least + margin), np.flatnonzero(low > most - margin)
        middle = low + high
        if not len(held):
            held = np.array([int(np.argmin(middle))])
        if not len(loaded):
            loaded = np.array([int(np.argmax(middle))])
        return (held + 1, loaded + 1) if not np.intersect1d(held, loaded).size else (np.array([], int),) * 2


def _of_children():
    times = os.times()
    return times.children_user + times.children_system


def main():
    """Print the figures of a part, a line for each way."""
    file, netgen, *names = sys.argv[1:]
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # what FreeCAD prints must not mix with the results
    load_meshing()
    limit_memory(MEMORY)
    with tempfile.TemporaryDirectory() as folder:
        part = SolvedPart(file, netgen, folder)
        print(json.dumps({"category": part.record["category"]}), file=out, flush=True)
        for name in names:
            print(json.dumps(part.figures(name)), file=out, flush=True)


if __name__ == "__main__":
    main()
