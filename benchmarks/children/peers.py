# SPDX-License-Identifier: LGPL-2.1-or-later
"""Child process: another program casts rays through one mesh. Runs in the peers' own environment.

    python -m benchmarks.children.peers embreex|trimesh|open3d|pymeshlab

Every task starts from a new object, so that the search structure is built within the time; reading the
mesh is not.
"""

import importlib
import sys
from functools import lru_cache
from importlib.metadata import version

import numpy as np

from .child_process import serve, timed

HAIR = 1e-5
"""Share of the extent by which rays start inside in programs that compute in float32."""

SAME = 1e-4
"""Share of the extent within which two distances count as the same."""


_BEYOND = 1e30
"""Distances from here on are Embree's for rays that hit nothing."""


def _hair(arrays):
    """float, mm: how far rays start inside."""
    return HAIR * float(np.linalg.norm(np.ptp(arrays["vertices"], axis=0)))


def _inside(arrays):
    """ndarray of shape (n, 3), mm: the centroids, so far inside that no ray hits the triangle it starts from."""
    return arrays["centroids"] + _hair(arrays) * arrays["inward"]


def _module(name):
    """A module of the peer: imported on first use, so that one that is missing is one failed row."""
    return importlib.import_module(name)


class Embreex:
    """Embree alone, by way of embreex: the tree, and the first hit of all rays in one call."""

    packages = ("embreex",)

    def prepare(self, arrays):
        """The float32 arrays of the mesh; the scene itself belongs to the time."""
        corners = arrays["vertices"][arrays["triangles"]].astype(np.float32)
        return corners, _inside(arrays).astype(np.float32), arrays["inward"].astype(np.float32)

    def distances(self, prepared, arrays):
        """ndarray of shape (n,), mm: along the inward normal of each triangle."""
        corners, start, direction = prepared
        scene = _module("embreex.rtcore_scene").EmbreeScene()
        _module("embreex.mesh_construction").TriangleMesh(scene, corners)
        found = scene.run(start, direction, query="DISTANCE")
        return np.where(found < _BEYOND, found, np.inf) + _hair(arrays)


class Trimesh:
    """``trimesh.proximity.thickness`` with embreex, normals given."""

    packages = ("trimesh", "embreex")

    def prepare(self, arrays):
        """A new mesh, that nothing has been computed of."""
        mesh = _module("trimesh").Trimesh(arrays["vertices"], arrays["triangles"], process=False)
        if "embree" not in type(mesh.ray).__module__:
            raise RuntimeError("trimesh does not use embreex here")
        return mesh

    def distances(self, mesh, arrays):
        """ndarray of shape (n,), mm: along the inward normal of each triangle."""
        return _module("trimesh.proximity").thickness(
            mesh, arrays["centroids"], exterior=False, normals=-arrays["inward"], method="ray")

    def ball_diameters(self, mesh, arrays):
        """ndarray of shape (n,), mm: of the largest ball inside that touches the surface at each point."""
        return _module("trimesh.proximity").thickness(
            mesh, arrays["points"], exterior=False, normals=arrays["normals"], method="max_sphere")

    def box_volume(self, arrays):
        """float, mm3: of ``trimesh.bounds.oriented_bounds``."""
        _, extents = _module("trimesh.bounds").oriented_bounds(self.prepare(arrays))
        return float(np.prod(extents))


class Open3d:
    """``open3d.t.geometry.RaycastingScene`` on one core, as all others have it."""

    packages = ("open3d",)

    def prepare(self, arrays):
        """The float32 arrays of the mesh; the scene itself belongs to the time."""
        open3d = _module("open3d")
        tensor = open3d.core.Tensor
        rays = np.concatenate([_inside(arrays), arrays["inward"]], axis=1).astype(np.float32)
        return (tensor(arrays["vertices"].astype(np.float32)),
                tensor(arrays["triangles"].astype(np.uint32)), tensor(rays))

    def distances(self, tensors, arrays):
        vertices, triangles, rays = tensors
        scene = _module("open3d").t.geometry.RaycastingScene(nthreads=1)
        scene.add_triangles(vertices, triangles)
        return scene.cast_rays(rays, nthreads=1)["t_hit"].numpy() + _hair(arrays)


class Pymeshlab:
    """The shape diameter function: per vertex many rays in a cone, so no distance to compare."""

    packages = ("pymeshlab",)
    RAYS = 64
    CONE_DEGREES = 90

    def prepare(self, arrays):
        pymeshlab = _module("pymeshlab")
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(arrays["vertices"], arrays["triangles"].astype(np.int32)))
        return meshes

    def distances(self, meshes, arrays):
        meshes.compute_scalar_by_shape_diameter_function_per_vertex(
            rays=self.RAYS, cone_amplitude=self.CONE_DEGREES)


@lru_cache(maxsize=2)
def _arrays(file):
    """The arrays that `product.load` has left; of the last two meshes, those of one solid."""
    with np.load(file) as arrays:
        return {name: arrays[name] for name in arrays.files}


PEERS = {"embreex": Embreex, "trimesh": Trimesh, "open3d": Open3d, "pymeshlab": Pymeshlab}


def main(name):
    """Serve the tasks of one peer."""
    peer = PEERS[name]()

    def versions():
        """dict of its packages; an error where it cannot be imported."""
        for package in peer.packages:
            _module(package)
        return {package: version(package) for package in peer.packages}

    def time_rays(file):
        """dict with ``seconds``, ``rays``, and ``same``: the share of distances equal to ours."""
        arrays = _arrays(file)
        seconds, distance = timed(peer.distances, peer.prepare(arrays), arrays)
        if distance is None:
            return {"seconds": seconds, "rays": len(arrays["vertices"]) * peer.RAYS,
                    "rays_per_vertex": peer.RAYS, "cone_degrees": peer.CONE_DEGREES}
        extent = float(np.linalg.norm(np.ptp(arrays["vertices"], axis=0)))
        with np.errstate(invalid="ignore"):
            same = np.abs(distance - arrays["distance"]) <= SAME * extent
        same |= ~np.isfinite(distance) & ~np.isfinite(arrays["distance"])
        return {"seconds": seconds, "rays": len(distance), "same": float(same.mean())}

    def time_box(file):
        """dict with ``seconds`` and ``volume``, mm3, of the peer's oriented box."""
        seconds, volume = timed(peer.box_volume, _arrays(file))
        return {"seconds": seconds, "volume": volume}

    def time_balls(file, answer_file):
        """dict with ``seconds``; the diameters are written into a file."""
        with np.load(file) as stored:
            arrays = dict(stored)
        mesh = _module("trimesh").Trimesh(arrays["vertices"], arrays["triangles"], process=False)
        seconds, diameters = timed(peer.ball_diameters, mesh, arrays)
        np.save(answer_file, diameters)
        return {"seconds": seconds}

    serve({"versions": versions, "time": time_rays, "box": time_box, "balls": time_balls})


if __name__ == "__main__":
    main(sys.argv[1])
