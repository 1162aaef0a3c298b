# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triangles on faces, by Gmsh, for shells."""

import os
import tempfile

import numpy as np

from ...core.errors import ThinPartError
from ...core.message import message
from ...freecad_adapter.shapes.brep_file import write_brep
from ...storage.exchange.geo_file import faces_text
from ...storage.exchange.msh_file import read_triangles
from .gmsh_program import INCOMPLETE, mesh_surface

SHAPE = "middle.brep"

AROUND = 6
"""Elements around a circle."""

OF_BEND = 0.8
"""Greatest size on a face that is curved in both directions by the root of radius times thickness, the length within which
a shell bends instead of stretching (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, 1959, section 114):
triangles that are larger are too stiff, 10 % on a vase."""

LEAST_SIZE = 2.0
"""Least size by the thickness of the wall: a shell knows nothing smaller."""

FINER = (1.0, 0.5, 0.25)
"""Sizes by the greatest that are tried in turn, where Gmsh fails: on narrow or free-form faces, large triangles do."""


def shell_sizes(shape, thickness, most):
    """Greatest element sizes on faces: ndarray, mm.

    Parameters
    ----------
    shape : Part.Shape
    thickness, most : ndarray of shape (number of faces,), mm
        Of the wall, and the size for other reasons.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.side_faces import face_radii

    return np.maximum(LEAST_SIZE * thickness, np.minimum(most, OF_BEND * np.sqrt(face_radii(shape) * thickness)))


def shell_triangles(part, shape, program, seconds, sizes, order, around=AROUND):
    """Mesh faces.

    Returns `points` (ndarray of shape (v, 3), mm), `triangles` (ndarray of int64, shape (n, 3) or (n, 6): rows of these) and
    `face` (ndarray of shape (n,), int64: number of the face, from 0). Raises ThinPartError, kind ``no_shell`` where Gmsh
    cannot, ``failed`` where what it wrote is cut short.

    Parameters
    ----------
    part : SolidPart
        The one that is told of.
    shape : Part.Shape
    program : str
        Path of Gmsh.
    seconds : float
        Limit.
    sizes : ndarray of shape (number of faces,), mm
        Greatest element size on each face.
    order : int
    around : int
        Elements around a circle.
    """
    for share in FINER:
        reason, found = _meshed(part, shape, program, seconds, share * np.asarray(sizes), order, around)
        if not reason:
            return found
    raise ThinPartError(message("The mid-surface of {part} could not be meshed ({problem}): name another element size.",
                                part=part.label, problem=reason), "no_shell")


def _meshed(part, shape, program, seconds, sizes, order, around):
    """Why Gmsh made no triangles, empty where it did, and these."""
    with tempfile.TemporaryDirectory(prefix="thinpart-shell-") as folder:
        script, output = os.path.join(folder, "middle.geo"), os.path.join(folder, "middle.msh")
        write_brep(shape, os.path.join(folder, SHAPE))
        with open(script, "w", encoding="ascii") as file:
            file.write(faces_text(SHAPE, sizes))
        reason, _ = mesh_surface(program, script, output, seconds, folder, around, order)
        if reason:
            return reason, None
        try:
            points, triangles, number = read_triangles(output, order)
        except ThinPartError:
            raise ThinPartError(message("The mid-surface of {part} could not be meshed ({problem}).", part=part.label,
                                        problem=INCOMPLETE), "failed") from None
    return (message("it has no triangles") if not len(triangles) else ""), (points, triangles, number - 1)
