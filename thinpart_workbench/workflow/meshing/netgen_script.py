# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes a BREP file with Netgen, in a program of its own: SHAPE SIZES.msz OUTPUT.npz GREATEST ORDER."""

import os
import sys

SIDES = ((0, 1), (1, 2), (0, 2), (0, 3), (2, 3), (1, 3))
"""Ends of the sides of a tetrahedron of second order, in Gmsh's order; those of a triangle are the first three."""

NETGEN = {3: ((1, 2), (0, 2), (0, 1)), 4: ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))}
"""In Netgen's order, by the corners of an element."""

GRADING, CURVATURE, ON_EDGE = 0.8, 0.5, 0.1
"""So coarse that the sizes decide: Netgen makes elements smaller where these ask for it, along curves and on edges."""


def main():
    """Write points, tetrahedra, triangles and the faces that these lie on, in the order of Gmsh."""
    import numpy as np
    from netgen.meshing import MeshingParameters
    from netgen.occ import OCCGeometry

    shape, sizes, output, greatest, order = sys.argv[1:]
    mesh = OCCGeometry(shape).GenerateMesh(MeshingParameters(
        maxh=float(greatest), meshsizefilename=sizes, grading=GRADING, curvaturesafety=CURVATURE, segmentsperedge=ON_EDGE))
    if order == "2":
        mesh.SecondOrder()
    solids, faces = mesh.Elements3D().NumPy(), mesh.Elements2D().NumPy()
    half = f"{output}.half.npz"  # the time may be over before it is whole
    np.savez(half, points=np.asarray(mesh.Coordinates()), tetrahedra=in_order(solids["nodes"], 4, order == "2"),
             triangles=in_order(faces["nodes"], 3, order == "2"), surface=faces["index"].astype(np.int64))
    os.replace(half, output)


def in_order(nodes, corners, is_second):
    """Rows of points, from 0, in Gmsh's order: ndarray.

    Parameters
    ----------
    nodes : ndarray of int
        In Netgen's, from 1.
    corners : int
        3 or 4.
    is_second : bool
        Whether elements are of second order.
    """
    nodes = nodes.astype("int64") - 1
    own = list(range(corners))
    if corners == 4:
        own[1], own[2] = own[2], own[1]  # Netgen's are the other way round
    if not is_second:
        return nodes[:, own]
    pairs = [tuple(sorted(side)) for side in NETGEN[corners]]
    sides = SIDES[:3] if corners == 3 else SIDES
    return nodes[:, [*own, *(corners + pairs.index(tuple(sorted((own[one], own[other])))) for one, other in sides)]]


if __name__ == "__main__":
    main()
