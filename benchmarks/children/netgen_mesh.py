"""Meshes a BREP file with Netgen: FILE OUTPUT.npz MAXH CLOSEEDGEFAC. Runs in the environment of the peers."""

import os
import sys

import numpy as np
from netgen.meshing import MeshingParameters
from netgen.occ import OCCGeometry


def main():
    """Write points and tetrahedra."""
    file, output, greatest, close_edges = sys.argv[1:]
    mesh = OCCGeometry(file).GenerateMesh(MeshingParameters(maxh=float(greatest), closeedgefac=float(close_edges)))
    nodes = mesh.Elements3D().NumPy()["nodes"][:, :4].astype(np.int64) - 1  # Netgen counts from 1
    half = f"{output}.half.npz"  # the time may be over before it is whole
    np.savez(half, points=np.asarray(mesh.Coordinates()), tetrahedra=nodes)
    os.replace(half, output)


if __name__ == "__main__":
    main()
