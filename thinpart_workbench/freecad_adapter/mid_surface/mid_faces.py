# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mid-surface of a solid: a face half-way through each wall, trimmed by the solid and by the faces that it meets."""

from dataclasses import dataclass, field, replace

import numpy as np

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ...core.shells.walls_through import sides_of
from ..bootstrap import load_freecad
from .bridges import bridges, connected_faces, is_bridge, lies_on, spread_points
from .cut_faces import TimeLimit, faces_cut
from .mid_shapes import MidPlane, mid_shape
from .smooth_cuts import smooth_cuts

LEAST_SQUARES, LEAST_WIDTH = 5.0, 1.7
"""Area of one side by the squared thickness, and width by thickness, from which on a wall is a shell."""

BEND_SQUARES, BEND_WIDTH = 1.0, 0.5
"""The same of a round wall, which may be a sharp bend between two flat ones: without it, they would not meet."""

ONE_WALL = 0.45
"""Distance between the middles of two walls, by the lesser thickness, up to which they have one mid-surface: a step."""

ALIKE = 2.0
"""Ratio of the thickness of two walls up to which they may have one mid-surface."""

LEANING = np.cos(np.radians(6.0))
"""Cosine of the greatest angle between the mid-surfaces of two walls that have one."""

THINNER, WITHIN = 1.25, 0.7
"""Ratio of the thicknesses of two walls, and share of the middle of the thicker one within thinner ones, from which on it is
the height of these, no wall."""

BEYOND = 2.5
"""Thicknesses by which a face reaches beyond its wall at first, to meet others."""

SUPPORTED = 0.3
"""Share of a piece that lies between the sides of its wall, from which on it stays."""

LOOSE = 0.05
"""Share of the volume of a shell that pieces which do not meet the rest may have to be left out: a rib on a boss, a lug."""

WELD = 1e-3
"""By the thickness of the thinnest wall: edges that are nearer to each other are one."""


@dataclass
class MidWall:
    """Walls with one mid-surface.

    Attributes
    ----------
    shape : MidPlane or MidRound
    pairs : list of FacingFaces
    """

    shape: object
    pairs: list = field(default_factory=list)

    @property
    def area(self):
        """float, mm2: of one side."""
        return sum(pair.area for pair in self.pairs)

    @property
    def thickness(self):
        """float, mm: of its largest pair."""
        return max(self.pairs, key=lambda pair: pair.area).thickness

    @property
    def middles(self):
        """ndarray of shape (k, 3), mm"""
        return np.concatenate([pair.middles for pair in self.pairs])

    @property
    def faces(self):
        """set of int: indices of B-Rep faces."""
        return {face for pair in self.pairs for face in pair.faces}

    @property
    def face_pairs(self):
        """list of tuple of int: the faces of its pairs."""
        return [pair.faces for pair in self.pairs]

    @property
    def is_flat(self):
        """bool"""
        return isinstance(self.shape, MidPlane)

    @property
    def width(self):
        """float, mm: the lesser extent along the mid-surface."""
        return self.shape.extents(self.middles)[1]

    def takes(self, pair, shape):
        """Whether the wall of another pair has this mid-surface."""
        if type(shape) is not type(self.shape):
            return False
        least = min(self.thickness, pair.thickness)
        if max(self.thickness, pair.thickness) > ALIKE * least:
            return False
        off = np.median(np.abs(self.shape.distances(pair.middles)))
        normals = np.abs(np.einsum("ij,ij->i", self.shape.normals(pair.middles), shape.normals(pair.middles)))
        if off > ONE_WALL * least or np.quantile(normals, 0.1) < LEANING:
            return False
        return self.is_flat or off < 0.1 * least

    @property
    def is_shell(self):
        """bool: whether it is wide enough."""
        squares, width = (LEAST_SQUARES, LEAST_WIDTH) if self.is_flat else (BEND_SQUARES, BEND_WIDTH)
        return self.area >= squares * self.thickness ** 2 and self.width >= width * self.thickness


@dataclass(frozen=True)
class MidSurface:
    """The mid-surface of a solid.

    Attributes
    ----------
    shape : Part.Shape
        Its faces; those that meet share their edges.
    walls : list of MidWall
    wall_of_face : list of int
        Number of the wall that each face belongs to.
    solid_walls : list of MidWall
        Those that stay solid since that was wanted.
    loose : float, mm3
        Volume of small pieces that are left out, since they do not meet the rest.
    """

    shape: object
    walls: list
    wall_of_face: list
    solid_walls: list = field(default_factory=list)
    loose: float = 0.0


def mid_walls(shape, pairs, mesh, rays):
    """The walls of a solid that are shells: list of MidWall.

    Parameters
    ----------
    shape : Part.Shape
    pairs : list of FacingFaces
    mesh : SurfaceMesh
    rays : InwardRays
    """
    faces, walls = shape.Faces, []
    for pair in sorted(pairs, key=lambda each: -each.area):
        found = mid_shape(faces[pair.faces[0]], faces[pair.faces[1]], pair)
        if found is None:
            continue
        own = next((wall for wall in walls if wall.takes(pair, found)), None)
        if own is None:
            walls.append(MidWall(found, [pair]))
        else:
            own.pairs.append(pair)
    return _without_heights([wall for wall in walls if wall.is_shell], mesh, rays, len(faces))


def _without_heights(walls, mesh, rays, count):
    """The walls whose middle does not lie within thinner ones: from above, a strip on edge is as thick as it is high."""
    found = []
    for wall in walls:
        inside = np.zeros(len(wall.middles), dtype=bool)
        for other in walls:
            if other.thickness * THINNER <= wall.thickness:
                sides = sides_of(mesh, rays, wall.middles, other.shape.normals(wall.middles))
                inside |= sides.is_between(other.face_pairs, count)
        if inside.mean() < WITHIN:
            found.append(wall)
    return found


def mid_surface(shape, pairs, mesh, rays, report=None, solid_walls=()):
    """Make the mid-surface of a solid: MidSurface.

    Raises ThinPartError, kind ``no_shell`` where no wall is a shell, or OCC cannot cut the faces.

    The surface half-way between the two sides of a wall is as exact as they are. It is cut to what lies within the solid, so
    it ends where the wall ends, and holes stay. Along smooth edges, as at the ends of a bend, it is cut across the wall.
    Faces of all walls then cut each other, and what stands out beyond a joint is left out: it does not lie between the sides
    of its wall.

    Parameters
    ----------
    shape : Part.Shape
        One solid.
    pairs : list of FacingFaces
        From `facing_faces`.
    mesh : SurfaceMesh
    rays : InwardRays
    report : callable, optional
        Called with the fraction that is done.
    solid_walls : collection of tuple of int
        Faces of walls that are to stay solid; see `ShellSettings`.
    """
    load_freecad()
    walls = mid_walls(shape, pairs, mesh, rays)
    if not walls:
        raise _too_thick()
    is_solid = [tuple(sorted(wall.faces)) in solid_walls for wall in walls]
    left = [wall for wall, stays in zip(walls, is_solid) if stays]
    walls = [wall for wall, stays in zip(walls, is_solid) if not stays]
    if not walls:
        raise ThinPartError(message("All walls are to stay solid: choose at least one for the shell."), "no_shell")
    test, limit = _Support(mesh, rays, len(shape.Faces)), TimeLimit()
    try:
        middle = _welded(_trimmed(shape, walls, test, report or (lambda fraction: None), limit), walls, test, limit)
        return replace(middle, solid_walls=left)
    except ThinPartError:
        raise
    except Exception as error:  # OCC's errors have several classes, which differ between versions of FreeCAD
        raise ThinPartError(message("The mid-faces of the walls could not be cut to each other ({problem}): mesh it as a "
                                    "solid.", problem=problem_of(error, message("FreeCAD finds no cut"))),
                            "no_shell") from None


def _too_thick():
    return ThinPartError(message("No wall is wide and thin enough for a shell: mesh it as a solid."), "no_shell")


class _Support:
    """Says how much of a piece lies between the two sides of its wall."""

    def __init__(self, mesh, rays, count):
        self._mesh, self._rays, self._count = mesh, rays, count

    def share(self, face, wall, spread=None):
        """float: share of the area of a face; 0 where it does not lie on the mid-surface of the wall."""
        points, area = spread or spread_points(face, wall.thickness)
        if not len(points):
            return 0.0  # a sliver that OCC makes no triangles of
        if not lies_on(points, wall):
            return 0.0
        sides = sides_of(self._mesh, self._rays, points, wall.shape.normals(points))
        known = sides.is_between([pair.faces for pair in wall.pairs], self._count)
        return float(area[known].sum() / area.sum())


def _trimmed(shape, walls, test, report, limit):
    """Faces on the mid-surfaces, within the solid: list of Part.Face."""
    cuts = smooth_cuts(shape, walls)
    found = []
    for number, wall in enumerate(walls):
        report(0.8 * number / len(walls))
        margin = BEYOND * max(max(each.thickness for each in walls if each.faces & wall.faces or each is wall),
                              wall.thickness)
        for patch in wall.shape.patches(wall.middles, margin):
            limit.check()
            for piece in patch.common(shape).Faces:
                pieces = piece.generalFuse(cuts[number])[0].Faces if cuts[number] else [piece]
                own = [test.share(face, wall) > 0.02 for face in pieces]
                # Beyond a rounded edge, a wall may go on to the middle of the next one, between the sides of neither.
                found += [face for face, is_own in zip(pieces, own) if is_own or (any(own) and is_bridge(face, wall))]
    report(0.8)
    return found


def _welded(faces, walls, test, limit):
    """All faces, cut where they meet, without what stands out."""
    import Part

    if not faces:
        raise _too_thick()
    # What OCC says of which piece comes of which face is incomplete, so each is asked for its wall again.
    thinnest = min(wall.thickness for wall in walls)
    cut, shares = faces_cut(faces, WELD * thinnest, limit), []
    spread = [spread_points(piece, thinnest) for piece in cut]
    for piece, own in zip(cut, spread):
        limit.check()
        shares.append([test.share(piece, wall, own) for wall in walls])
    shares = np.array(shares)
    best = shares.argmax(axis=1)
    is_kept = shares.max(axis=1) >= SUPPORTED
    if not is_kept.any():
        raise _too_thick()
    rest = []
    for number in np.flatnonzero(~is_kept):
        on = [row for row, wall in enumerate(walls) if lies_on(spread[number][0], wall) and is_bridge(cut[number], wall)]
        if on:
            best[number] = max(on, key=lambda wall: (shares[number, wall], walls[wall].area))
            rest.append(int(number))
    for number in bridges(cut, np.flatnonzero(is_kept).tolist(), rest):
        is_kept[number] = True
    kept, loose = _held_together(cut, np.flatnonzero(is_kept).tolist(), best, walls)
    return MidSurface(Part.makeCompound([cut[number] for number in kept]), walls, best[kept].tolist(), loose=loose)


def _held_together(faces, kept, wall_of_face, walls):
    """The faces without small groups that do not meet the largest one, list of int, and the volume of these groups, mm3."""
    groups = connected_faces(faces, kept)
    volumes = [sum(faces[number].Area * walls[wall_of_face[number]].thickness for number in group) for group in groups]
    largest, whole = int(np.argmax(volumes)), sum(volumes)
    small = [row for row in range(len(groups)) if row != largest and volumes[row] <= LOOSE * whole]
    loose = sum(volumes[row] for row in small)
    if not small or loose > LOOSE * whole:
        return kept, 0.0
    out = {number for row in small for number in groups[row]}
    return [number for number in kept if number not in out], loose
