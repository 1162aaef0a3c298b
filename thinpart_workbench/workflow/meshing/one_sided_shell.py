# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mid-surface of a part that is one wall, from the triangles of one side of it: whatever its faces are."""

from dataclasses import dataclass, field

import numpy as np

from ...core.errors import ThinPartError
from ...core.shells.moved_side import SideNodes, moved_side, thickness_at
from ...core.shells.shell_mesh import alike
from ...core.shells.shell_settings import SHARE_OF_DIAGONAL
from ...core.shells.wall_sides import wall_sides
from .shell_triangles import shell_sizes, shell_triangles

SIDES = 2
"""Of the sides that are tried, the largest."""

MOST_FOLDED = 0.02
"""Share of the area of a side that may turn over when it is moved: narrow fillets."""

@dataclass(frozen=True)
class SideWall:
    """Faces of a side below which the wall is of about one thickness.

    Attributes
    ----------
    faces : set of int
        Indices of B-Rep faces, with those on the other side.
    face_pairs : list of tuple of int
    thickness, area : float, mm and mm2
    is_flat : bool
    """

    faces: set
    face_pairs: list
    thickness: float
    area: float
    is_flat: bool = False


@dataclass(frozen=True)
class OneSidedMiddle:
    """Triangles half-way through a wall, moved there from one side of it.

    Attributes
    ----------
    points, triangles, wall
        As of `ShellMesh`.
    size : float, mm
    walls : list of SideWall
    shape : Part.Shape
        The side. The triangles do not lie on it.
    wall_of_face : list of int
        Number of the wall of each of its faces.
    solid_walls : list
        None: it is one wall.
    loose : float
        0
    """

    points: np.ndarray
    triangles: np.ndarray
    wall: np.ndarray
    size: float
    walls: list
    shape: object
    wall_of_face: list
    solid_walls: list = field(default_factory=list)
    loose: float = 0.0


def sides_of_part(part, measurement):
    """The sides of a measured solid that may make its shell: list of WallSide, the largest first."""
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.side_faces import face_meetings

    return wall_sides(measurement.field, face_meetings(part.shape), len(part.shape.Faces))


def one_sided_middles(part, measurement, program, seconds, settings):
    """Make the mid-surface from one side, and from the other: list of OneSidedMiddle.

    Raises ThinPartError where Gmsh meshes none of the sides.

    Parameters
    ----------
    part, measurement, program, seconds, settings
        See `shell_of_part`.
    """
    found, problem = [], None
    for side in sides_of_part(part, measurement)[:SIDES]:
        try:
            middle = _from_side(part, measurement, side, program, seconds, settings)
        except ThinPartError as error:
            problem = problem or error
            continue
        if middle is not None:
            found.append(middle)
    if not found and problem is not None:
        raise problem
    return found


def _from_side(part, measurement, side, program, seconds, settings):
    from ...freecad_adapter.mid_surface.side_faces import side_normals, side_shape

    shape, surface = part.shape, measurement.field.mesh
    own, thickness = side_shape(shape, side), _thickness_of_faces(measurement.field, side, len(shape.Faces))
    most = np.full(len(side.faces), settings.size or SHARE_OF_DIAGONAL * measurement.descriptors.box.diagonal)
    sizes = most if settings.size else shell_sizes(own, thickness[list(side.faces)], most)
    points, triangles, number = shell_triangles(part, own, program, seconds, sizes, settings.order)
    used, rows = np.unique(triangles, return_inverse=True)
    points, triangles = points[used], rows.reshape(triangles.shape)
    nodes = SideNodes(points, triangles, np.array(side.faces)[number])
    normals = side_normals(shape, nodes, points, measurement.field)
    below = thickness_at(nodes, normals, side, surface, measurement.rays, thickness)
    points, folded = moved_side(points, triangles, nodes, normals, below)
    if folded > MOST_FOLDED:
        return None
    wall_of_face = alike(thickness[list(side.faces)])
    walls = [_wall(side, wall_of_face == number, thickness, measurement.field) for number in range(wall_of_face.max() + 1)]
    return OneSidedMiddle(points, triangles, wall_of_face[number], float(sizes.max()), walls, own, wall_of_face.tolist())


def _thickness_of_faces(field, side, count):
    """Median thickness below each face: that of the side where it sees none of the other side; ndarray, mm."""
    there = np.append(field.mesh.face_of_triangle, -1)[field.opposite]
    seen = set(side.pairs)
    known = np.array([(min(pair), max(pair)) in seen for pair in zip(field.face.tolist(), there.tolist())], dtype=bool)
    found = np.full(count, side.thickness)
    for face in side.faces:
        own = known & (field.face == face)
        if own.any():
            found[face] = np.median(field.distance[own])
    return found


def _wall(side, own, thickness, field):
    """The wall below some faces of a side."""
    faces = {face for face, is_own in zip(side.faces, own) if is_own}
    pairs = [pair for pair in side.pairs if faces & set(pair)]
    area = float(field.area[np.isin(field.face, list(faces))].sum())
    return SideWall(faces | {face for pair in pairs for face in pair}, pairs, float(np.median(thickness[list(faces)])), area)
