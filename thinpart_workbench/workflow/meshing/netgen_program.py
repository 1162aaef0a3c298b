# SPDX-License-Identifier: LGPL-2.1-or-later
"""Netgen, which meshes some parts that Gmsh does not, as a program. FreeCAD's own bundles have it; pip has netgen-mesher."""

import importlib.util
import os
import sys
from importlib.machinery import PathFinder

import numpy as np

from ...core.message import message
from ...storage.exchange.msh_file import write_mesh
from ...system.process_limits import run_limited

SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "netgen_script.py")

PLACES = 5000
"""Places at most whose sizes Netgen is told."""

FAILED, TIMEOUT = message("Netgen failed"), message("Netgen took too long")


def has_netgen():
    """Whether this Python has Netgen, with its module for B-Rep geometry; nothing of it is loaded."""
    found = importlib.util.find_spec("netgen")
    folders = list(found.submodule_search_locations or ()) if found is not None else []
    return bool(folders) and PathFinder.find_spec("netgen.occ", folders) is not None


def mesh_with_netgen(shape, proposal, output, seconds, folder):
    """Mesh a part with sizes of a proposal.

    Returns a str: why there is no mesh; empty if there is one, in the format MSH 2.2.

    Parameters
    ----------
    shape : str
        BREP file.
    proposal : SizeProposal
    output : str
    seconds : float
        Limit.
    folder : str
        Working directory, temporary.
    """
    sizes, found = os.path.join(folder, "sizes.msz"), os.path.join(folder, "netgen.npz")
    points = proposal.sources.points
    points = points[np.unique(np.linspace(0, max(len(points) - 1, 0), min(len(points), PLACES)).astype(np.int64))]
    rows = np.column_stack([points, proposal.field.at(points)])
    with open(sizes, "w", encoding="ascii") as file:
        file.write(f"{len(rows)}\n")
        np.savetxt(file, rows, fmt="%.9g")
        file.write("0\n")  # lines with a size
    path = os.pathsep.join(filter(None, sys.path))
    end = run_limited([sys.executable, SCRIPT, shape, sizes, found, repr(proposal.global_size),
                       str(proposal.settings.order)], seconds, folder, {**os.environ, "PYTHONPATH": path})
    if not os.path.exists(found):
        return TIMEOUT if end.timed_out else FAILED
    with np.load(found) as mesh:
        if not len(mesh["tetrahedra"]):
            return FAILED
        write_mesh(output, *(mesh[name] for name in ("points", "tetrahedra", "triangles", "surface")))
    return ""
