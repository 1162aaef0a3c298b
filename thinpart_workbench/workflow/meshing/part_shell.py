# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shell of one part as files: its mid-surface for FreeCAD, its mesh with groups for FEM, its triangles to be shown."""

import os

import numpy as np

from ...core.shells.shell_mesh import ALIKE
from ...freecad_adapter.shapes.brep_file import write_brep
from ...storage.exchange.shell_files import write_shell

SHELL_SHAPE, SHELL_MESH, SHELL_FACETS, SHELL_THICKNESS = "middle.brep", "shell.unv", "shell.npy", "shell_thickness.npy"
"""Files: the mid-surface; its mesh; corners of its triangles, float32, shape (m, 3, 3), mm; the thickness of each, mm."""


def write_part_shell(folder, shell, label):
    """Write the files of a shell; raises OSError.

    Returns a dict: of plain values, lengths in mm: ``size``, ``nodes``, ``elements``, ``volume_share``, ``left_solid`` and
    ``warnings`` as of `PartShell`; ``walls``: ``thickness``, ``area`` and ``faces`` of the part, from 0; ``groups``:
    ``thickness`` and ``faces`` of the mid-surface, from 0: walls of about one thickness share one.

    Parameters
    ----------
    folder : str
    shell : PartShell
    label : str
        Of the part.
    """
    mesh = shell.mesh
    write_brep(shell.shape, os.path.join(folder, SHELL_SHAPE))
    write_shell(os.path.join(folder, SHELL_MESH), mesh, label)
    save_whole(os.path.join(folder, SHELL_FACETS), mesh.points[mesh.triangles[:, :3]].astype(np.float32))
    save_whole(os.path.join(folder, SHELL_THICKNESS), mesh.thickness.astype(np.float32))
    return {
        "size": float(shell.size), "nodes": len(mesh.points), "elements": len(mesh.triangles),
        "volume_share": float(shell.volume_share), "warnings": list(shell.warnings),
        "walls": [{**wall, "faces": _numbers(wall["faces"])} for wall in shell.walls],
        "left_solid": [{**each, "faces": _numbers(each["faces"])} for each in shell.left_solid],
        "groups": thickness_groups(shell),
    }


def save_whole(path, array):
    """Write an array to a file of NumPy's; where the disk is full, what was there stays, for the window to read."""
    part = f"{path}.part"
    with open(part, "wb") as file:
        np.save(file, array)
    os.replace(part, path)


def thickness_groups(shell):
    """Faces of a mid-surface by their thickness.

    Returns a list of dict: ``thickness``, mm, the mean of the elements by area, and ``faces``, from 0; the thinnest first.
    Only these can FEM tell from each other: a thickness that varies along a wall becomes its mean.
    """
    mesh = shell.mesh
    areas, count = mesh.areas, int(mesh.wall.max()) + 1
    area = np.bincount(mesh.wall, areas, count)
    mean = np.bincount(mesh.wall, areas * mesh.thickness, count) / np.maximum(area, 1e-300)
    walls = [wall for wall in np.argsort(mean, kind="stable").tolist() if area[wall] > 0.0]
    groups: list = []
    for wall in walls:
        if not groups or mean[wall] > ALIKE * mean[groups[-1][0]]:
            groups.append([])
        groups[-1].append(wall)
    found = []
    for members in groups:
        faces = [face for face, wall in enumerate(shell.wall_of_face) if wall in members]
        thickness = float(area[members] @ mean[members] / area[members].sum())
        found.append({"thickness": float(f"{thickness:.6g}"), "faces": faces})
    return found


def _numbers(names):
    return [int(name[len("Face"):]) - 1 for name in names]
