"""Triangles on faces, by Gmsh, for shells."""

import os
import tempfile

from ...core.errors import ThinPartError
from ...core.message import message
from ...freecad_adapter.shapes.brep_file import write_brep
from ...storage.exchange.msh_file import read_triangles
from .gmsh_program import INCOMPLETE, mesh_surface

AROUND = 6
"""Elements around a circle."""

FINER = (1.0, 0.5, 0.25)
"""Sizes by the greatest that are tried in turn, where Gmsh fails: on narrow or free-form faces, large triangles do."""


def shell_triangles(part, shape, program, seconds, size, order):
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
    size : float, mm
        Greatest element size.
    order : int
    """
    for share in FINER:
        reason, found = _meshed(part, shape, program, seconds, share * size, order)
        if not reason:
            return found
    raise ThinPartError(message("The mid-surface of {part} could not be meshed ({problem}): name another element size.",
                                part=part.label, problem=reason), "no_shell")


def _meshed(part, shape, program, seconds, size, order):
    """Why Gmsh made no triangles, empty where it did, and these."""
    with tempfile.TemporaryDirectory(prefix="thinpart-shell-") as folder:
        file, output = os.path.join(folder, "middle.brep"), os.path.join(folder, "middle.msh")
        write_brep(shape, file)
        reason, _ = mesh_surface(program, file, output, seconds, folder, size, AROUND, order)
        if reason:
            return reason, None
        try:
            points, triangles, number = read_triangles(output, order)
        except ThinPartError:
            raise ThinPartError(message("The mid-surface of {part} could not be meshed ({problem}).", part=part.label,
                                        problem=INCOMPLETE), "failed") from None
    return (message("it has no triangles") if not len(triangles) else ""), (points, triangles, number - 1)
