# SPDX-License-Identifier: LGPL-2.1-or-later
"""Write the current parts of an open document to disk, for a worker process to measure."""

import json
import os

import numpy as np

from ...core.message import restored, with_messages
from ..features.feature_history import Feature, feature_history
from ..shapes.part import MeshedPart, SolidPart

JOB = "job.json"

MOST_SHAPES = 200
"""Most history shapes in one snapshot. A part whose history no longer fits is written without one."""

MOST_FACES = 20_000
"""Most faces in the history of one part."""


def write_snapshot(parts, folder, settings, profile, thin_limit=None, maps=None, first_maps=False):
    """Write parts and the job description for the worker.

    Returns an iterator: each step writes one more shape of the parts' histories; stopping early loses only the histories.
    The parts can be read before the first step, the histories by `read_history` after the last.

    Writing a B-Rep takes milliseconds, but meshing it holds Python's lock for seconds. So the worker meshes
    it while the user goes on working on the document.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
        In the order in which the worker measures them.
    folder : str
        An empty folder.
    settings : AnalysisSettings
    profile : dict
        Content of a profile.
    thin_limit : dict, optional
        See `preferred_thin_limit`.
    maps : str, optional
        One of `SHOWN_MEASURES`: the worker also makes thickness maps by it and finds the feature that made each face.
    first_maps : bool, optional
        Whether it makes coarse maps of all parts before; only with `maps`.
    """
    entries, pending = [], []
    for number, part in enumerate(parts):
        if isinstance(part, SolidPart):
            file = f"{number}.brep"
            part.shape.exportBrep(os.path.join(folder, file))
        else:
            file = f"{number}.npz"
            np.savez(os.path.join(folder, file), points=part.points, triangles=part.triangles)
        entries.append({
            "file": file, "name": part.name, "label": part.label, "instances": part.instances,
            "warnings": list(part.warnings), "diagonal": _diagonal(part),
        })
        if maps:
            entries[-1]["history"], shapes = _planned_history(part, number, MOST_SHAPES - len(pending))
            pending += [(os.path.join(folder, name), shape) for name, shape in shapes]
    job = {"parts": entries, "settings": settings.content(), "profile": profile,
           "thin_limit": thin_limit, "maps": maps, "first_maps": bool(maps) and first_maps}
    with open(os.path.join(folder, JOB), "w", encoding="utf-8") as file:
        json.dump(with_messages(job), file)
    return _write_shapes(pending)


def _diagonal(part):
    """Of the box of a part along the axes, mm: it says how large the part is in a view, not how large it is."""
    if isinstance(part, SolidPart):
        return float(part.shape.BoundBox.DiagonalLength)
    return float(np.linalg.norm(np.ptp(part.points, axis=0))) if len(part.points) else 0.0


def _planned_history(part, number, limit):
    """Entries for the features of a part, and the shapes to write as (file, shape)."""
    history = feature_history(part)
    if not history or len(history) > limit or len(history) * len(part.shape.Faces) > MOST_FACES:
        return [], []
    files = [f"{number}-{step}.bin" for step in range(len(history))]
    return [
        {"label": feature.label, "file": file, "frame": feature.frame.tolist(), "sources": feature.sources}
        for feature, file in zip(history, files)
    ], [(file, feature.shape) for file, feature in zip(files, history)]


def _write_shapes(pending):
    for path, shape in pending:
        shape.exportBinary(path)
        yield path


def read_snapshot(folder):
    """Read the job, and get a function that reads its parts.

    Returns `job` (dict; ``parts``, ``settings``, ``profile``, ``thin_limit``, ``maps``, ``first_maps``) and `read`
    (callable; from an entry of ``job["parts"]`` to a part).
    """
    with open(os.path.join(folder, JOB), encoding="utf-8") as file:
        job = restored(json.load(file))

    def read(entry):
        path = os.path.join(folder, entry["file"])
        # The caller knows the occurrences; only their number enters the record.
        occurrences, warnings = [None] * entry["instances"], tuple(entry["warnings"])
        if entry["file"].endswith(".npz"):
            with np.load(path) as arrays:
                return MeshedPart(entry["name"], entry["label"], occurrences, warnings,
                                  arrays["points"], arrays["triangles"])
        import Part

        shape = Part.Shape()
        shape.importBrep(path)
        return SolidPart(entry["name"], entry["label"], occurrences, warnings, shape)

    return job, read


def read_history(folder, entry):
    """Read the history of a part, as far as it was written: list of Feature.

    See `feature_history`; empty if any of its files is missing.

    Parameters
    ----------
    folder : str
    entry : dict
        Of ``job["parts"]``.
    """
    import Part

    steps = [(os.path.join(folder, step["file"]), step) for step in entry.get("history", ())]
    if not all(os.path.exists(path) for path, _ in steps):
        return []
    history = []
    for path, step in steps:
        shape = Part.Shape()
        shape.importBinary(path)
        history.append(Feature(step["label"], shape, np.array(step["frame"]), step["sources"]))
    return history
