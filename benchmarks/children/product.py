# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: ThinPart measures one mesh."""

import pickle
import platform
from dataclasses import replace
from functools import lru_cache

import numpy as np
import scipy

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.descriptors.distribution import distribution
from thinpart_workbench.core.mesh.mass_properties import volume
from thinpart_workbench.core.mesh.sampling import centroid_samples, surface_samples
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh
from thinpart_workbench.core.rays.inward_rays import InwardRays
from thinpart_workbench.core.thickness.measurement import _box, measure
from thinpart_workbench.core.thickness.nonparallel import nonparallel_minimum
from thinpart_workbench.core.walls.thickness_field import ThicknessField, measure_rays
from thinpart_workbench.core.walls.walls import walls_under

from .child_process import peak_memory, serve, timed

CUBE_POINTS = np.array([[x, y, z] for x in (0, 9) for y in (0, 9) for z in (0, 9)], dtype=float)
CUBE_TRIANGLES = np.array([
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
])


def core(mesh):
    """The core: tree, first hit of one ray per triangle, angles, distribution and volume.

    What a measurement does beyond that (four samples and more per triangle, corners probed for the
    minimum, the box, slanted walls, the check for a surface that passes through itself) is in `whole`.

    Parameters
    ----------
    mesh : SurfaceMesh
        Clean, and without anything that it keeps for later.

    Returns
    -------
    ThicknessField
    """
    rays, samples = InwardRays(mesh), centroid_samples(mesh)
    walls, _ = walls_under(mesh, rays, samples)
    field = ThicknessField(mesh, samples, *walls, np.empty(0, dtype=np.int64))
    distribution(field, mesh.extent, mesh.extent)
    volume(mesh)
    return field


def whole(points, triangles):
    """Everything that is measured on a part as delivered, cleaning included; a `Measurement`."""
    return measure(surface_mesh(points, triangles), AnalysisSettings())


def versions():
    """dict of what the product runs on."""
    return {"Python": platform.python_version(), "numpy": np.__version__, "scipy": scipy.__version__}


@lru_cache(maxsize=1)
def _raw(file):
    with np.load(file) as arrays:
        return arrays["points"], arrays["triangles"]


@lru_cache(maxsize=1)
def _clean(file):
    return surface_mesh(*_raw(file))


def load(file, clean_file, peers_file):
    """Read a mesh, clean it, and leave it for the other contestants and for `memory`.

    Parameters
    ----------
    file : str
        npz with ``points`` (v, 3), mm, and ``triangles`` (n, 3).
    clean_file : str
        Where the clean mesh goes.
    peers_file : str
        Where its arrays go, with a centroid and an inward direction per triangle.

    Returns
    -------
    dict
        ``triangles``, after cleaning.
    """
    mesh = _clean(file)
    with open(clean_file, "wb") as stream:
        pickle.dump(replace(mesh), stream, protocol=5)
    field = core(replace(mesh))
    np.savez(peers_file, vertices=mesh.vertices, triangles=mesh.triangles,
             centroids=mesh.corners.mean(axis=1), inward=-mesh.normals,
             distance=field.distance)
    warm_up()
    return {"triangles": mesh.count}


def time_core(file):
    """dict with ``seconds``."""
    seconds, _ = timed(core, replace(_clean(file)))
    return {"seconds": seconds}


def time_whole(file):
    """dict with ``seconds`` and ``samples``: how many rays were cast."""
    seconds, measurement = timed(whole, *_raw(file))
    return {"seconds": seconds, "samples": len(measurement.field.distance)}


def time_box(file):
    """dict with ``seconds`` and ``volume``, mm3, of the minimum box alone."""
    seconds, box = timed(_box, replace(_clean(file)), "minimal")
    return {"seconds": seconds, "volume": box.volume}


def time_nonparallel(file):
    """Time the non-parallel minimum alone, from the field of a whole measurement; dict with ``seconds``."""
    mesh = replace(_clean(file))
    rays = InwardRays(mesh)
    field = measure_rays(mesh, surface_samples(mesh, AnalysisSettings().minimum_samples), rays=rays)
    seconds, _ = timed(nonparallel_minimum, mesh, rays, field, mesh.extent)
    return {"seconds": seconds}


def memory(kind, file):
    """What a task adds to the memory of this process, which must be fresh: the peak never falls.

    Parameters
    ----------
    kind : {"core", "whole"}
    file : str
        The clean mesh for the core, the raw one for the whole.

    Returns
    -------
    dict
        ``bytes``.
    """
    warm_up()
    if kind == "core":
        with open(file, "rb") as stream:
            arguments = (pickle.load(stream),)
    else:
        arguments = _raw(file)
    before = peak_memory()
    {"core": core, "whole": whole}[kind](*arguments)
    return {"bytes": peak_memory() - before}


def warm_up():
    """Import what is imported on first use, so that neither time nor memory of it is counted; an empty dict.

    A few samples only: the peak of the memory stays, and would hide what a small mesh takes.
    """
    cube = surface_mesh(CUBE_POINTS, CUBE_TRIANGLES)
    measure(cube, AnalysisSettings(minimum_samples=1))
    core(replace(cube))
    return {}


if __name__ == "__main__":
    serve({
        "versions": versions, "load": load, "core": time_core, "whole": time_whole, "box": time_box,
        "nonparallel": time_nonparallel, "memory": memory, "warm_up": warm_up,
    })
