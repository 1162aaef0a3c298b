# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes a BREP file with Netgen: FILE OUTPUT.npz MAXH CLOSEEDGEFAC [ORDER]. Runs in the environment of the peers."""

import os
import sys
from pathlib import Path

import numpy as np
from netgen.meshing import MeshingParameters
from netgen.occ import OCCGeometry

# A script of its own: the package around it needs what the peers do not have.
sys.path.append(str(Path(__file__).resolve().parents[2] / "thinpart_workbench" / "workflow" / "meshing"))

from netgen_script import in_order


def main():
    """Write points, tetrahedra, triangles and the faces that these lie on."""
    file, output, greatest, close_edges, *order = sys.argv[1:]
    mesh = OCCGeometry(file).GenerateMesh(MeshingParameters(maxh=float(greatest), closeedgefac=float(close_edges)))
    if order == ["2"]:
        mesh.SecondOrder()
    solids, faces = mesh.Elements3D().NumPy(), mesh.Elements2D().NumPy()
    half = f"{output}.half.npz"  # the time may be over before it is whole
    np.savez(half, points=np.asarray(mesh.Coordinates()), tetrahedra=in_order(solids["nodes"], 4, order == ["2"]),
             triangles=in_order(faces["nodes"], 3, order == ["2"]), surface=faces["index"].astype(np.int64))
    os.replace(half, output)


if __name__ == "__main__":
    main()
