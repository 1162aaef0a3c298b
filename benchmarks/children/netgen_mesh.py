"""Meshes a BREP file with Netgen: FILE OUTPUT.npz MAXH CLOSEEDGEFAC [ORDER]. Runs in the environment of the peers."""

import os
import sys

import numpy as np
from netgen.meshing import MeshingParameters
from netgen.occ import OCCGeometry

SIDES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
"""Ends of the sides of a tetrahedron of second order, in Gmsh's order; those of a triangle are the first three."""

NETGEN = {3: ((1, 2), (0, 2), (0, 1)), 4: ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))}
"""In Netgen's order, by the corners of an element."""


def main():
    """Write points, tetrahedra, triangles and the faces that these lie on."""
    file, output, greatest, close_edges, *order = sys.argv[1:]
    mesh = OCCGeometry(file).GenerateMesh(MeshingParameters(maxh=float(greatest), closeedgefac=float(close_edges)))
    if order == ["2"]:
        mesh.SecondOrder()
    solids, faces = mesh.Elements3D().NumPy(), mesh.Elements2D().NumPy()
    half = f"{output}.half.npz"  # the time may be over before it is whole
    np.savez(half, points=np.asarray(mesh.Coordinates()), tetrahedra=_in_order(solids["nodes"], 4, order == ["2"]),
             triangles=_in_order(faces["nodes"], 3, order == ["2"]), surface=faces["index"].astype(np.int64))
    os.replace(half, output)


def _in_order(nodes, corners, is_second):
    """Rows of points, from 0, in Gmsh's order."""
    nodes = nodes.astype(np.int64) - 1
    if not is_second:
        return nodes[:, :corners]
    own = list(range(corners))
    if corners == 4:
        own[1], own[2] = own[2], own[1]  # Netgen's are the other way round
    pairs = [tuple(sorted(side)) for side in NETGEN[corners]]
    sides = SIDES[:3] if corners == 3 else SIDES
    return nodes[:, [*own, *(corners + pairs.index(tuple(sorted((own[one], own[other])))) for one, other in sides)]]


if __name__ == "__main__":
    main()
