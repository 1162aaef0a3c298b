# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between a part of an open document and one of a library, in pieces to be drawn; found in a worker process."""

import base64
from dataclasses import dataclass

import numpy as np

from ...core.analysis_settings import ACCURACIES, LINEAR_DEFLECTIONS, AnalysisSettings
from ...core.errors import ThinPartError
from ...core.forms.comparison import GEOMETRY_SAME, Side, laid_closely
from ...core.forms.form import Form
from ...core.forms.laying import laid_partly
from ...core.forms.nearest_on_mesh import NearestOnMesh
from ...core.kinds.compound_kinds import Record
from ...core.kinds.value_kinds import Number, Text
from ...core.maps.surface_difference import surface_difference
from ...core.message import message
from ..workers.preparation import require_preparation
from ..workers.task_run import run_tasks
from .comparison_task import TRIANGLES_SAME, ComparedPart, part_of

_CHORDS = 2.0
"""Times the error of facets that two surfaces which are the same may be apart."""

_FITTED = 1000
"""Points by which the two are fitted: a turn that is a little wrong is seen at the ends of a long part."""

_ARRAYS = {"corners": (9, "<f4"), "normals": (9, "<f4"), "is_apart": (1, "?"), "lines": (6, "<f4")}

_LONGEST = 1 << 30
"""Greatest number of characters of an array in base64."""

_SIDE = Record({"share": Number(0.0, 1.0), "greatest_mm": Number(0.0),
                **{name: Text(_LONGEST, "[A-Za-z0-9+/=]*") for name in _ARRAYS}})
_ANSWER = Record({"tolerance_mm": Number(0.0), "part": _SIDE, "reference": _SIDE})


@dataclass(frozen=True)
class DifferenceTask:
    """Compare a part, as a snapshot holds it, with another.

    Attributes
    ----------
    snapshot : str
        Folder of the snapshot, see `freecad_adapter.objects.snapshot.write_snapshot`.
    form : Form
        Of the part.
    reference : ComparedPart
    """

    snapshot: str
    form: Form
    reference: ComparedPart

    @property
    def file(self):
        """Document of the other part, which may not be readable."""
        return self.reference.file


def part_difference(task, limits, control=None):
    """Find what differs, after the part is turned and moved to where most of the two is the same; neither is scaled.

    Returns a dict: ``tolerance_mm``, up to which surfaces are the same, and ``part`` and ``reference``, each with ``share``,
    which lies apart, ``greatest_mm``, and the arrays of a `SurfaceDifference`, in the coordinates of the part; of the
    reference only what lies apart. Raises ThinPartError if the documents cannot be compared or no worker can be started;
    Cancelled when `control` was asked to stop.

    Parameters
    ----------
    task : DifferenceTask
    limits : Limits
    control : RunControl, optional
    """
    done, = run_tasks([task], _answer, _checked, limits, control=control)
    if done.failure is not None:
        raise ThinPartError(done.failure["error"]["message"], done.failure["error"]["kind"])
    return done.result


def _answer(task):
    """Runs in a worker."""
    require_preparation()
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.objects.snapshot import read_snapshot

    job, read = read_snapshot(task.snapshot)
    part, reference = read(job["parts"][0]), part_of(task.reference)
    side, other = Side(task.form, part.nearest_points()), Side(task.reference.form, reference.nearest_points())
    motion = laid_closely(side.asked(), other, laid_partly(task.form, task.reference.form, 0.0).motion, _FITTED)
    (mesh, error), (other_mesh, other_error) = _mesh(part), _mesh(reference)
    are_solids = part.can_be_finer and reference.can_be_finer
    tolerance = max((GEOMETRY_SAME if are_solids else TRIANGLES_SAME) * task.reference.form.extent,
                    _CHORDS * (error + other_error))
    found = surface_difference(mesh, _distances(mesh, side, other_mesh, other, motion), tolerance)
    there = surface_difference(other_mesh, _distances(other_mesh, other, mesh, side, motion.inverse()), tolerance)
    return {"tolerance_mm": tolerance,
            "part": _told(found.share, found, side.placed, mesh.origin - task.form.moments.centroid),
            "reference": _told(there.share, there.only_apart(), side.placed,
                               other_mesh.origin - task.reference.form.moments.centroid, motion.inverse())}


def _mesh(part):
    """The surface mesh of a part, and how far it lies beside its geometry, mm."""
    mesh, deflections = part.surface_mesh(
        AnalysisSettings(angular_deflection=ACCURACIES["fine"].angular_deflection), LINEAR_DEFLECTIONS[0])
    return mesh, float(np.max(deflections, initial=0.0))


def _distances(mesh, side, other_mesh, other, motion):
    """A function that says how far points of the one mesh lie from the other."""
    nearest = NearestOnMesh(other_mesh)

    def distances(points):
        moved = other.placed(motion.points(side.centred(points + mesh.origin))) - other_mesh.origin
        return np.linalg.norm(moved - nearest.nearest(moved), axis=1)

    return distances


def _told(share, found, placed, origin, motion=None):
    """A `SurfaceDifference` as JSON values, moved from the coordinates of its mesh to those of the document."""
    def moved(points):
        points = points.reshape(-1, 3) + origin
        return placed(points if motion is None else motion.points(points))

    normals = found.normals.reshape(-1, 3)
    arrays = {"corners": moved(found.corners), "normals": normals if motion is None else motion.directions(normals),
              "is_apart": found.is_apart, "lines": moved(found.lines)}
    return {"share": share, "greatest_mm": found.greatest, **{
        name: base64.b64encode(np.ascontiguousarray(array, dtype=_ARRAYS[name][1]).tobytes()).decode("ascii")
        for name, array in arrays.items()}}


def _checked(_task, answer):
    """What an answer holds, its arrays unpacked."""
    fault = _ANSWER.fault(answer, "")
    if fault:
        raise ValueError(fault)
    return {"tolerance_mm": answer["tolerance_mm"], **{name: _unpacked(answer[name]) for name in ("part", "reference")}}


def _unpacked(side):
    arrays = {}
    for name, (width, kind) in _ARRAYS.items():
        array = np.frombuffer(base64.b64decode(side[name], validate=True), dtype=kind)
        arrays[name] = array if width == 1 else array.reshape(-1, width // 3, 3)
    if not len(arrays["corners"]) == len(arrays["normals"]) == len(arrays["is_apart"]):
        raise ValueError(message("it is damaged or incomplete"))
    return {"share": side["share"], "greatest_mm": side["greatest_mm"], **arrays}
