"""Parts of an open document put on disk as they are now, for a worker process to measure."""

import json
import os

import numpy as np

from .feature_history import Feature, feature_history
from .part import MeshedPart, SolidPart

JOB = "job.json"

MOST_SHAPES = 200
"""Shapes of histories in one snapshot; parts whose history does not fit any more go without."""

MOST_FACES = 20_000
"""Faces of the history of one part."""


def write_snapshot(parts, folder, settings, profile, thin_limit=None, maps=False):
    """Write parts and what is to be done with them.

    Parameters
    ----------
    parts : list of SolidPart or MeshedPart
        In the order in which they are wanted.
    folder : str
        An empty folder.
    settings : AnalysisSettings
    profile : dict
        Content of a profile.
    thin_limit : dict, optional
        See `preferred_thin_limit`.
    maps : bool
        Whether thickness maps are wanted beside the records, and what made each face.

    Returns
    -------
    iterator
        Each step writes one more shape of what the parts were made from; stopping early loses only that. The
        parts can be read before the first step, the rest by `read_history` after the last.

    Notes
    -----
    A B-Rep is written in milliseconds, while meshing it holds Python's lock for seconds: the worker
    meshes, and the user goes on working on the document.
    """
    entries, waiting = [], []
    for number, part in enumerate(parts):
        if isinstance(part, SolidPart):
            file = f"{number}.brep"
            part.shape.exportBrep(os.path.join(folder, file))
        else:
            file = f"{number}.npz"
            np.savez(os.path.join(folder, file), points=part.points, triangles=part.triangles)
        entries.append({
            "file": file, "name": part.name, "label": part.label, "instances": part.instances,
            "warnings": list(part.warnings),
        })
        if maps:
            entries[-1]["history"], shapes = _planned_history(part, number, MOST_SHAPES - len(waiting))
            waiting += [(os.path.join(folder, name), shape) for name, shape in shapes]
    job = {"parts": entries, "settings": settings.content(), "profile": profile,
           "thin_limit": thin_limit, "maps": maps}
    with open(os.path.join(folder, JOB), "w", encoding="utf-8") as file:
        json.dump(job, file)
    return _written(waiting)


def _planned_history(part, number, room):
    """Entries for the features of a part, and the shapes that are to be written, each with its file."""
    history = feature_history(part)
    if not history or len(history) > room or len(history) * len(part.shape.Faces) > MOST_FACES:
        return [], []
    files = [f"{number}-{step}.bin" for step in range(len(history))]
    return [
        {"label": each.label, "file": file, "frame": each.frame.tolist(), "sources": each.sources}
        for each, file in zip(history, files)
    ], [(file, each.shape) for file, each in zip(files, history)]


def _written(waiting):
    for path, shape in waiting:
        shape.exportBinary(path)
        yield path


def read_snapshot(folder):
    """The job and a list of functions that read its parts one after the other.

    Returns
    -------
    job : dict
        ``parts``, ``settings``, ``profile``, ``thin_limit``, ``maps``.
    read : callable
        From an entry of ``job["parts"]`` to a part.
    """
    with open(os.path.join(folder, JOB), encoding="utf-8") as file:
        job = json.load(file)

    def read(entry):
        path = os.path.join(folder, entry["file"])
        # Where the part stands is known to the caller; only how often enters the record.
        places, warnings = [None] * entry["instances"], tuple(entry["warnings"])
        if entry["file"].endswith(".npz"):
            with np.load(path) as arrays:
                return MeshedPart(entry["name"], entry["label"], places, warnings,
                                  arrays["points"], arrays["triangles"])
        import Part

        shape = Part.Shape()
        shape.importBrep(path)
        return SolidPart(entry["name"], entry["label"], places, warnings, shape)

    return job, read


def read_history(folder, entry):
    """What a part was made from, as far as it was written.

    Parameters
    ----------
    folder : str
    entry : dict
        Of ``job["parts"]``.

    Returns
    -------
    list of Feature
        See `feature_history`; empty where not all of it is there.
    """
    import Part

    steps = [(os.path.join(folder, each["file"]), each) for each in entry.get("history", ())]
    if not all(os.path.exists(path) for path, _ in steps):
        return []
    history = []
    for path, each in steps:
        shape = Part.Shape()
        shape.importBinary(path)
        history.append(Feature(each["label"], shape, np.array(each["frame"]), each["sources"]))
    return history
