"""Parts of an open document put on disk as they are now, for a worker process to measure."""

import json
import os

import numpy as np

from .part import MeshedPart, SolidPart

JOB = "job.json"


def write_snapshot(parts, folder, settings, profile, maps=False):
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
    maps : bool
        Whether thickness maps are wanted beside the records.

    Notes
    -----
    A B-Rep is written in milliseconds, while meshing it holds Python's lock for seconds: the worker
    meshes, and the user goes on working on the document.
    """
    entries = []
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
    job = {"parts": entries, "settings": settings.content(), "profile": profile, "maps": maps}
    with open(os.path.join(folder, JOB), "w", encoding="utf-8") as file:
        json.dump(job, file)


def read_snapshot(folder):
    """The job and a list of functions that read its parts one after the other.

    Returns
    -------
    job : dict
        ``parts``, ``settings``, ``profile``, ``maps``.
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
