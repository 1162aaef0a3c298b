"""Mesh the parts of a document with Gmsh, and say how bad the mesh is. Runs in a worker process."""

import os
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.kinds.compound_kinds import ListOf, Record
from ...core.kinds.value_kinds import Number, OneOf, OrNull, Text, Whole
from ...core.mesh.tetrahedra import POOR, radius_ratios, surface_share
from ...core.message import message
from ...storage.exchange.msh_file import read_tetrahedra
from ..meshing.gmsh_program import mesh_volume, stated_error

SIZE = 0.1
"""Greatest size of elements, as a share of the diagonal: Gmsh's own default."""

MESHED, NO_MESH, NOT_MESHABLE = "meshed", "no_mesh", "not_meshable"
"""What became of a part; the last of one that cannot be given to Gmsh."""

_RESULT = Record({
    "part": Text(),
    "outcome": OneOf((MESHED, NO_MESH, NOT_MESHABLE)),
    "elements": Whole(),
    "least_ratio": OrNull(Number(0, 2)),
    "trouble_share": OrNull(Number(0, 1)),
    "reason": Text(),
})

RESULTS = ListOf(_RESULT, most=1_000_000, distinct="part")
"""Kind of what `mesh_document` returns: by part the number of tetrahedra, the least ratio of radii and the share of the
surface on bad ones, both null without a mesh, and then the reason."""


@dataclass(frozen=True)
class MeshingTask:
    """The parts of one document that are to be meshed.

    Attributes
    ----------
    file : str
        Its path.
    source : dict
        Of its info file.
    diagonals : dict of str to float
        Diagonal of the box by part name, mm.
    program : str
        Path of Gmsh.
    seconds : float
        Limit for each part.
    """

    file: str
    source: Mapping
    diagonals: dict
    program: str
    seconds: float


def mesh_document(task):
    """Mesh parts of a document: list of dict; see `RESULTS`. Raises ThinPartError if the document cannot be read."""
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.reading.part_files import read_parts

    parts = {part.name: part for part in read_parts(task.file).parts}
    return [_meshed(parts.get(name), name, diagonal, task) for name, diagonal in task.diagonals.items()]


def _meshed(part, name, diagonal, task):
    with tempfile.TemporaryDirectory(prefix="thinpart-gmsh-") as folder:
        shape, mesh = os.path.join(folder, "part.brep"), os.path.join(folder, "part.msh")
        if part is None:
            return _unmeshed(name, NOT_MESHABLE, message("The document has no such part any more: classify it again."))
        try:
            part.write_brep(shape)
        except ThinPartError as error:
            return _unmeshed(name, NOT_MESHABLE, str(error))
        reason, text = mesh_volume(task.program, [shape], mesh, task.seconds, folder, ("-clmax", repr(SIZE * diagonal)))
        if reason:
            return _unmeshed(name, NO_MESH, reason)
        points, tetrahedra = read_tetrahedra(mesh)
    if not len(tetrahedra):
        return _unmeshed(name, NO_MESH, stated_error(text) or message("Gmsh filled no volume"))
    ratios = radius_ratios(points, tetrahedra)
    return {"part": name, "outcome": MESHED, "elements": len(tetrahedra), "least_ratio": round(float(ratios.min()), 6),
            "trouble_share": round(surface_share(points, tetrahedra, ratios < POOR), 6), "reason": ""}


def _unmeshed(name, outcome, reason):
    return {"part": name, "outcome": outcome, "elements": 0, "least_ratio": None, "trouble_share": None, "reason": reason}


def results_fault(results, task):
    """Why an answer of a worker is none to a task, in a few words; None if it is one."""
    fault = RESULTS.fault(results, "")
    if fault or [each["part"] for each in results] == list(task.diagonals):
        return fault
    return message("its parts are not those of {file}", file=Path(task.file).name)
