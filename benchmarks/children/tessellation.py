# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: FreeCAD makes the meshes that all others measure, and is timed at it."""

import json
import math
from pathlib import Path

import numpy as np

from thinpart_workbench.freecad_adapter.bootstrap import load_freecad

from .child_process import serve, timed
from .solids import make_solid, rotated

PLACEMENTS = ("aligned", "rotated")

ANGULAR_DEFLECTION = 1.0
"""Radians; so coarse that the linear deflection alone decides how many triangles there are."""

CLOSE_ENOUGH = math.log(1.15)
MOST_TRIES = 14
GREATEST_STEP = math.log(4.0)
"""Per try the number of triangles is meant to grow by no more: far too fine costs minutes."""

SLOPE = -0.5
"""Of log triangles over log deflection, on cylinders; until two tries tell it of this solid."""

FINEST = 150_000
"""Triangles to which FreeCAD tessellates; beyond it takes minutes to an hour, as large plane faces cost
more than their share. Finer meshes are these with each triangle split into four."""

COARSER_STEP = math.log(2.0)
"""Towards fewer triangles: coarse tries are quick, and beyond a hole's radius the number rises again."""

SMALLEST_STEP = 0.02

_shapes = {}
_tries = {}
"""By solid: log of the deflection to log of the triangles that it gave."""


def freecad_version():
    """dict with the versions of FreeCAD and of its geometry kernel."""
    freecad = load_freecad()
    import Part

    return {"FreeCAD": ".".join(freecad.Version()[:3]).split()[0], "OCCT": Part.OCC_VERSION}


def make_meshes(solid, wanted, folder):
    """Make the meshes of a solid with about so many triangles, or take them from the folder.

    Parameters
    ----------
    solid : str
    wanted : int
        Triangles.
    folder : str

    Returns
    -------
    dict
        ``files`` by placement, ``triangles``, ``linear_deflection`` (mm), ``angular_deflection``
        (radians), ``splits``: how often each triangle was split into four after that.
    """
    folder = Path(folder)
    facts_file = folder / f"{solid}_{wanted}.json"
    files = {place: folder / f"{solid}_{wanted}_{place}.npz" for place in PLACEMENTS}
    if not all(file.is_file() for file in (facts_file, *files.values())):
        folder.mkdir(parents=True, exist_ok=True)
        splits = max(0, math.ceil(math.log(wanted / FINEST, 4)))
        deflection = _deflection_for(solid, wanted / 4 ** splits)
        facts = {"linear_deflection": deflection, "angular_deflection": ANGULAR_DEFLECTION}
        for place, file in files.items():
            mesh = _tessellated(_fresh(solid, place), **facts)
            points, triangles = mesh.Topology
            points = np.array([tuple(point) for point in points])
            triangles = np.array(triangles, dtype=np.int64)
            for _ in range(splits):
                points, triangles = _split(points, triangles)
            np.savez(file, points=points, triangles=triangles)
        facts.update(triangles=len(triangles), splits=splits)
        facts_file.write_text(json.dumps(facts), encoding="utf-8")
    facts = json.loads(facts_file.read_text(encoding="utf-8"))
    return {"files": {place: str(file) for place, file in files.items()}, **facts}


def time_tessellation(solid, placement, linear_deflection, angular_deflection):
    """Tessellate a fresh shape once; dict with ``seconds``."""
    shape = _fresh(solid, placement)
    seconds, _ = timed(_tessellated, shape, linear_deflection, angular_deflection)
    return {"seconds": seconds}


def _fresh(solid, placement):
    """A copy without triangles: FreeCAD silently takes those that are there, if they are finer."""
    load_freecad()
    if solid not in _shapes:
        _shapes[solid] = make_solid(solid)
    shape = _shapes[solid]
    return rotated(shape) if placement == "rotated" else shape.copy(True, False)


def _tessellated(shape, linear_deflection, angular_deflection):
    import MeshPart

    return MeshPart.meshFromShape(
        Shape=shape, LinearDeflection=linear_deflection, AngularDeflection=angular_deflection,
        Relative=False,
    )


def _split(points, triangles):
    """Split each triangle into four by the middles of its sides."""
    sides = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    sides, middle = np.unique(sides, axis=0, return_inverse=True)
    middle = middle.reshape(-1, 3) + len(points)
    corners = [np.column_stack([triangles[:, k], middle[:, k], middle[:, k - 1]]) for k in range(3)]
    return np.concatenate([points, points[sides].mean(axis=1)]), np.concatenate([*corners, middle])


def _deflection_for(solid, wanted):
    """The linear deflection, mm, that gives nearly so many triangles, or the nearest that can be had."""
    goal = math.log(wanted)
    diagonal = _fresh(solid, "aligned").BoundBox.DiagonalLength
    tries = _tries.setdefault(solid, {})
    level = _next_level(tries, goal) if tries else math.log(0.005 * diagonal)
    for _ in range(MOST_TRIES):
        if level is None or level >= math.log(diagonal):
            break
        mesh = _tessellated(_fresh(solid, "aligned"), math.exp(level), ANGULAR_DEFLECTION)
        tries[level] = math.log(mesh.CountFacets)
        if abs(tries[level] - goal) < CLOSE_ENOUGH:
            break
        level = _next_level(tries, goal)
    return math.exp(min(tries, key=lambda level: abs(tries[level] - goal)))


def _next_level(tries, goal):
    """Where to go on, or None where nothing lies between; numbers stay equal over whole ranges.

    Parameters
    ----------
    tries : dict of float to float
        Log of the deflection to log of the triangles that it gave.
    goal : float
        Log of the triangles wanted.
    """
    too_few = min((level for level in tries if tries[level] < goal), default=None)
    too_many = max((level for level in tries if tries[level] >= goal), default=None)
    if too_few is None:
        return too_many + COARSER_STEP
    if too_many is None:
        return too_few - min(goal - tries[too_few], GREATEST_STEP) / -_slope(tries)
    if too_few - too_many < SMALLEST_STEP:
        return None
    share = (goal - tries[too_few]) / (tries[too_many] - tries[too_few])
    return too_few + min(max(share, 0.1), 0.9) * (too_many - too_few)


def _slope(tries):
    """Of log triangles over log deflection between the two finest tries that differ."""
    finest = sorted(tries)
    for level in finest[1:]:
        if tries[level] < tries[finest[0]] - SMALLEST_STEP:
            return min(-0.2, (tries[level] - tries[finest[0]]) / (level - finest[0]))
    return SLOPE


if __name__ == "__main__":
    serve({"version": freecad_version, "meshes": make_meshes, "time": time_tessellation})
