#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The largest ball inside at points of the surface: ThinPart's and trimesh's, value and speed.

    /usr/bin/python3 benchmarks/balls.py [--points 1000] [--markdown]

Solids of which every ball is known, then bundled samples, on which the two are compared with each other. trimesh is
``trimesh.proximity.thickness(method="max_sphere")``, in the environment of the peers; see README.md in this folder.
"""

import argparse
import json
import os
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [os.fspath(ROOT), os.fspath(ROOT / "tests")]

import made_meshes  # noqa: E402

from benchmarks.children.child_process import ChildError  # noqa: E402
from benchmarks.children.peer_environment import open_peers  # noqa: E402
from benchmarks.machine import machine  # noqa: E402
from benchmarks.places import CACHE, DEBIAN_PYTHON  # noqa: E402
from benchmarks.table_text import Table, markdown, plain  # noqa: E402
from thinpart_workbench.core.analysis_settings import AnalysisSettings  # noqa: E402
from thinpart_workbench.core.mesh.sampling import SurfaceSamples, even_samples, surface_samples  # noqa: E402
from thinpart_workbench.core.mesh.surface_mesh import surface_mesh  # noqa: E402
from thinpart_workbench.core.thickness.inscribed_balls import inscribed_balls  # noqa: E402

SAMPLES = ("gear_thin_teeth", "flange", "thin_walled_casting")
LIMIT = 900.0
"""Seconds that trimesh may take on one part."""

HEADER = ("part", "triangles", "known", "ThinPart off, median", "95 %", "trimesh off, median", "95 %", "within 1 %",
          "ThinPart s", "trimesh s", "times as fast")


def main():
    """Print a line per part."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--points", type=int, default=1000, metavar="N", help="points per part (default: 1000)")
    parser.add_argument("--markdown", action="store_true", help="print a table in Markdown")
    options = parser.parse_args()
    peers, versions, missing = open_peers(CACHE / "peers", [DEBIAN_PYTHON, sys.executable], _say, ("trimesh",))
    if missing:
        sys.exit(f"benchmarks: {missing['trimesh']}")
    print(json.dumps({**machine(), **versions}), file=sys.stderr)
    rows = []
    with peers["trimesh"] as trimesh:
        for name, mesh, known in _parts():
            rows.append(_row(name, mesh, known, options.points, trimesh))
            _say(f"{name}: done")
    print((markdown if options.markdown else plain)(Table("", HEADER, rows)))


def _say(text):
    print(text, file=sys.stderr)


def _parts():
    """Name, mesh, and a function from points and normals to the known diameters, or None."""
    yield "plate 100 x 80 x 2", surface_mesh(*made_meshes.box(100, 80, 2)), _of_box((100.0, 80.0, 2.0))
    yield "cube, 4,800 triangles", surface_mesh(*made_meshes.box(10, 10, 10, 20)), _of_box((10.0, 10.0, 10.0))
    yield "tube, wall 2", surface_mesh(*made_meshes.tube(20.0, 18.0, 60.0, 90)), _of_tube
    yield "ball of 40", surface_mesh(*made_meshes.sphere(20.0, 90)), lambda points, normals: np.full(len(points), 40.0)
    yield "hollow ball, wall 1", surface_mesh(*made_meshes.spherical_shell(20.0, 1.0, 60)), (
        lambda points, normals: np.ones(len(points)))
    yield "wedge of 30 degrees", surface_mesh(*made_meshes.wedge(30.0, 100.0, 60.0)), _of_wedge
    # Imported late: it loads FreeCAD.
    from thinpart_workbench.freecad_adapter.bootstrap import load_meshing

    load_meshing()
    from thinpart_workbench.freecad_adapter.reading.part_files import read_parts

    settings = AnalysisSettings()
    for name in SAMPLES:
        part, = read_parts(ROOT / "resources" / "samples" / f"{name}.step").parts
        yield name.replace("_", " "), part.surface_mesh(settings, settings.linear_deflection)[0], None


def _of_box(size):
    def known(points, normals):
        own = np.abs(normals).argmax(axis=1)
        to_sides = np.minimum(points, np.array(size) - points)
        to_sides[np.arange(len(points)), own] = 0.5 * np.array(size)[own]
        return 2.0 * to_sides.min(axis=1)

    return known


def _of_tube(points, normals):
    radius, along = np.linalg.norm(points[:, :2], axis=1), np.minimum(points[:, 2], 60.0 - points[:, 2])
    at_end = np.abs(normals[:, 2]) > 0.5
    return 2.0 * np.where(at_end, np.abs(np.minimum(20.0 - radius, radius - 18.0)), np.minimum(1.0, along))


def _of_wedge(points, normals):
    """Of the flanks; nan on the back and the ends."""
    flank = (np.abs(normals[:, 2]) < 0.5) & (normals[:, 0] < 0.5)
    from_tip, along = np.linalg.norm(points[:, :2], axis=1), points[:, 2]
    known = 2.0 * np.minimum.reduce([from_tip * np.tan(np.radians(15.0)), (100.0 - from_tip) * np.tan(np.radians(37.5)),
                                     along, 60.0 - along])
    return np.where(flank, known, np.nan)


def _row(name, mesh, known, count, trimesh):
    surface = surface_samples(mesh)
    chosen = np.unique(even_samples(surface.area, count))
    samples = SurfaceSamples(surface.points[chosen], surface.triangle[chosen], surface.area[chosen])
    normals = mesh.normals[samples.triangle]
    started = time.perf_counter()
    ours = inscribed_balls(mesh, samples)
    own_seconds = time.perf_counter() - started
    with tempfile.TemporaryDirectory() as folder:
        file, answer_file = os.path.join(folder, "balls.npz"), os.path.join(folder, "answer.npy")
        np.savez(file, vertices=mesh.vertices, triangles=mesh.triangles, points=samples.points, normals=normals)
        try:
            seconds = trimesh.ask("balls", LIMIT, file=file, answer_file=answer_file)["seconds"]
            theirs = np.load(answer_file)
        except ChildError as error:
            _say(f"{name}: {error}")
            seconds, theirs = np.nan, np.full(len(ours), np.nan)
    right = ours if known is None else known(samples.points + mesh.origin, normals)
    both = np.isfinite(right) & (right > 1e-3 * mesh.extent)
    off, their_off = (np.abs(found[both] / right[both] - 1.0) for found in (ours, theirs))
    own = ("-", "-") if known is None else (_share(np.median(off)), _share(np.percentile(off, 95)))
    return (name, f"{mesh.count:,}", "yes" if known is not None else "no, against ThinPart", *own,
            _share(np.median(their_off)), _share(np.percentile(their_off, 95)), _share(np.mean(their_off < 0.01)),
            f"{own_seconds:.2f}", f"{seconds:.2f}", f"{seconds / own_seconds:.1f}")


def _share(value):
    return f"{100 * value:.2g} %"


if __name__ == "__main__":
    main()
