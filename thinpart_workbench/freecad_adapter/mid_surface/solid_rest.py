# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a solid is no wall: the solid is cut across its walls where they go over into it."""

import math
from dataclasses import dataclass

import numpy as np

from ...core.errors import ThinPartError
from ...core.message import message
from ...core.problem import problem_of
from ..shapes.same_shapes import same_shapes
from .bridges import lies_on, spread_points
from .cut_faces import TimeLimit, faces_cut
from .mid_faces import WELD, MidSurface
from .smooth_cuts import edges_between

AHEAD = 0.3
"""Way from an edge along the face beyond it, by the thickness of the wall, after which it is asked whether it has turned."""

TURNED = 0.02
"""Height above the wall by that way, from which on it has: the edge is concave, or a fillet begins there."""

BEYOND, ASIDE = 0.4, 1.0
"""By the thickness, how far a cut reaches beyond the other side of its wall, and beyond the ends of a straight edge, before
it is trimmed by the solid."""

MOSTLY = 0.6
"""Share of the volume of a piece that its mid-surface stands for, from which on it is a shell."""

LEAST_PIECE = 0.002
"""Share of the volume of the solid from which on a piece that is no shell counts: the rounding of a rim does not."""

ON_CUT = 1e-3
"""Distance from a cut by the thickness up to which a place lies on it."""

SLENDER, THICKER = 4.0, 1.5
"""Width of a wall by its thickness from which on it is a shell beside solids; and how many times as thick as the thinnest of
these another one is a thick body."""

_SAMPLES = 25


@dataclass(frozen=True)
class SolidRest:
    """A solid that is part shell, part solid.

    Attributes
    ----------
    middle : MidSurface
        Of the walls that are shells, trimmed to where they are.
    solids : list of Part.Solid
        All that is no shell; they do not touch each other.
    cuts : list of Part.Face
        Between these and the walls.
    volume : float, mm3
        Of the solids.
    """

    middle: MidSurface
    solids: list
    cuts: list
    volume: float

    @property
    def is_round(self):
        """bool: whether one of the cuts has an edge that is not straight."""
        return any(edge.Curve.TypeId != "Part::GeomLine" for cut in self.cuts for edge in cut.Edges if not edge.Degenerated)


def stocky_walls(middle):
    """Walls of a mid-surface that are thick bodies beside its slender walls: list of int, their numbers.

    Parameters
    ----------
    middle : MidSurface
    """
    walls, faces = middle.walls, middle.shape.Faces
    edges = [(edge, middle.wall_of_face[number]) for number, face in enumerate(faces) for edge in face.Edges]
    seen, around = {}, np.zeros(len(walls))
    for same, (edge, wall) in zip(same_shapes(edge for edge, _ in edges), edges):
        seen.setdefault(same, []).append((edge.Length, wall))
    for own in seen.values():
        for length, wall in own:
            if sum(other == wall for _, other in own) == 1:  # else within the wall
                around[wall] += length
    areas = np.bincount(middle.wall_of_face, [face.Area for face in faces], len(walls))
    thickness = np.array([wall.thickness for wall in walls])
    # Of a strip, a tube and a ring, this is the width.
    is_slender = 2.0 * areas > SLENDER * thickness * around
    if not is_slender.any():
        return []
    least = thickness[is_slender].min()
    return np.flatnonzero((areas > 0.0) & ~is_slender & (thickness > THICKER * least)).tolist()


def solid_rest(shape, middle, limit=None):
    """Cut a solid into walls and what is none: SolidRest, or None where nothing is.

    Where a face of a wall meets another one in a concave edge or goes over into a fillet, and that one belongs to no wall,
    the solid is cut across the wall. A piece for most of whose volume the mid-surface stands is a shell.

    Raises ThinPartError, kind ``no_shell`` where the solid cannot be cut.

    Parameters
    ----------
    shape : Part.Shape
        One solid.
    middle : MidSurface
    limit : TimeLimit, optional
    """
    limit = limit or TimeLimit()
    try:
        return _solid_rest(shape, middle, limit)
    except ThinPartError:
        raise
    except Exception as error:  # OCC's errors have several classes, which differ between versions of FreeCAD
        raise ThinPartError(message("What is solid could not be cut from the walls ({problem}).",
                                    problem=problem_of(error, message("FreeCAD finds no cut"))), "no_shell") from None


def _solid_rest(shape, middle, limit):
    import Part

    used = sorted(set(middle.wall_of_face))
    thinnest = min(middle.walls[number].thickness for number in used)
    cuts = _cuts(shape, [middle.walls[number] for number in used], limit)
    if not cuts:
        return None
    pieces = shape.generalFuse(cuts)[0].Solids
    if len(pieces) < 2:
        return None
    faces, piece_of, wall_of = _pieces_of_middle(middle, pieces, cuts, WELD * thinnest, limit)
    stands = np.zeros(len(pieces))
    for face, piece, wall in zip(faces, piece_of, wall_of):
        stands[piece] += face.Area * middle.walls[wall].thickness
    volumes = np.array([piece.Volume for piece in pieces])
    is_shell = stands >= MOSTLY * volumes
    counts = ~is_shell & (volumes >= LEAST_PIECE * volumes.sum())
    if not counts.any() or not is_shell.any():
        return None
    solid = [pieces[number] for number in np.flatnonzero(counts)]
    between = _between(pieces, is_shell, counts)
    kept = [number for number, piece in enumerate(piece_of) if not counts[piece]]
    trimmed = MidSurface(Part.makeCompound([faces[number] for number in kept]), middle.walls,
                         [wall_of[number] for number in kept], middle.solid_walls, middle.loose)
    joined = solid[0] if len(solid) == 1 else solid[0].multiFuse(solid[1:])
    solids = [_without_inner_faces(each) for each in joined.Solids]
    return SolidRest(trimmed, solids, between, float(volumes[counts].sum()))


def _without_inner_faces(solid):
    """A solid without faces that end within it."""
    import Part

    closed = [shell for shell in solid.Shells if shell.isClosed()]
    if len(closed) == len(solid.Shells) or not closed:
        return solid
    found = Part.Solid(closed[0])
    return found if len(closed) == 1 else found.cut([Part.Solid(each) for each in closed[1:]]).Solids[0]


def _between(pieces, is_shell, is_solid):
    """Faces that a shell and a solid piece share."""
    faces = [(face, number) for number, piece in enumerate(pieces) for face in piece.Faces]
    owners = {}
    for same, own in zip(same_shapes(face for face, _ in faces), faces):
        owners.setdefault(same, []).append(own)
    return [own[0][0] for own in owners.values() if len(own) == 2 and
            {(bool(is_shell[number]), bool(is_solid[number])) for _, number in own} == {(True, False), (False, True)}]


def _pieces_of_middle(middle, pieces, cuts, tolerance, limit):
    """The mid-surface, cut: its faces, and the piece of the solid and the wall of each."""
    import FreeCAD

    old = middle.shape.Faces
    faces, piece_of, wall_of = [], [], []
    boxes = [_grown(piece.BoundBox, tolerance) for piece in pieces]
    for face in faces_cut(old + cuts, tolerance, limit):
        limit.check()
        points, areas = spread_points(face, 1.0)
        if not len(points):
            continue
        inner = FreeCAD.Vector(*_inner_point(face, points, areas))
        near = [number for number, wall in enumerate(middle.wall_of_face) if lies_on(points, middle.walls[wall])
                and old[number].distToShape(_vertex(inner))[0] <= 10.0 * tolerance]
        own = next((number for number, (piece, box) in enumerate(zip(pieces, boxes))
                    if box.isInside(inner) and piece.isInside(inner, 1e-7, False)), None)
        if near and own is not None:
            faces.append(face)
            piece_of.append(own)
            wall_of.append(middle.wall_of_face[near[0]])
    return faces, piece_of, wall_of


def _grown(box, by):
    box.enlarge(by)
    return box


def _vertex(point):
    import Part

    return Part.Vertex(point)


def _inner_point(face, points, areas):
    """The one of some points on a face that is farthest from its edges, about: the nearest to its middle within it."""
    if len(points) == 1:
        return points[0]
    middle = np.average(points, axis=0, weights=areas)
    return points[np.argmin(np.linalg.norm(points - middle, axis=1))]


def _cuts(shape, walls, limit):
    """Faces across walls where they go over into what is none, within the solid: list of Part.Face."""
    faces, found = shape.Faces, []
    wall_of = {face: wall for wall in sorted(walls, key=lambda each: each.thickness) for face in wall.faces}
    for (one, other), shared in edges_between(faces).items():
        if (one in wall_of) == (other in wall_of):
            continue
        side, beyond = (one, other) if one in wall_of else (other, one)
        wall = wall_of[side]
        for edge in shared:
            limit.check()
            if not edge.Degenerated and _goes_over(edge, faces[side], faces[beyond], wall.thickness):
                found.append((edge, faces[side], wall.thickness))
    ends = _shared_ends(found)
    cuts = []
    for edge, face, thickness in found:
        if _has(cuts, edge, face, thickness):
            continue  # from the other side of the wall
        for raw in _across(edge, face, thickness, ends):
            cuts += _within(raw, shape, edge, thickness)
    return cuts


def _shared_ends(found):
    """Ends of edges at which two of them meet, as rounded coordinates."""
    seen, shared = set(), set()
    for edge, *_ in found:
        for vertex in edge.Vertexes:
            key = _key(vertex.Point)
            (shared if key in seen else seen).add(key)
    return shared


def _key(point):
    return tuple(round(value, 4) for value in point)


def _goes_over(edge, side, beyond, thickness):
    """Whether the surface turns away from the material at an edge of a wall, or goes over into a fillet there."""
    import FreeCAD

    place = 0.5 * (edge.FirstParameter + edge.LastParameter)
    point, along = np.array(edge.valueAt(place)), np.array(edge.tangentAt(place))
    outward, normal = _normal(side, point), _normal(beyond, point)
    into, step = np.cross(along, normal), AHEAD * thickness
    for sign in (1.0, -1.0):
        ahead = FreeCAD.Vector(*(point + sign * step * into))
        parameters = beyond.Surface.parameter(ahead)
        if beyond.isPartOfDomain(*parameters):
            break
    else:
        # A narrow face: half-way to its middle.
        ahead = FreeCAD.Vector(*(point + 0.1 * (np.array(beyond.CenterOfMass) - point)))
        parameters = beyond.Surface.parameter(ahead)
    reached = np.array(beyond.Surface.value(*parameters))
    return float((reached - point) @ outward) > TURNED * float(np.linalg.norm(reached - point))


def _normal(face, point):
    import FreeCAD

    return np.array(face.normalAt(*face.Surface.parameter(FreeCAD.Vector(*point))))


def _has(cuts, edge, face, thickness):
    """Whether one of the cuts runs along an edge already."""
    place = 0.5 * (edge.FirstParameter + edge.LastParameter)
    point = edge.valueAt(place)
    from_side = point - 0.1 * thickness * face.normalAt(*face.Surface.parameter(point))
    return any(cut.distToShape(_vertex(point))[0] <= ON_CUT * thickness
               and cut.distToShape(_vertex(from_side))[0] <= ON_CUT * thickness for cut in cuts)


def _across(edge, face, thickness, ends):
    """Faces across a wall from an edge of one of its sides to beyond the other one, list of Part.Face."""
    import FreeCAD
    import Part

    deep = (1.0 + BEYOND) * thickness
    places = np.linspace(edge.FirstParameter, edge.LastParameter, _SAMPLES)
    points = np.array([tuple(edge.valueAt(place)) for place in places])
    inward = -np.array([_normal(face, point) for point in points])
    if np.ptp(inward, axis=0).max() < 1e-6:
        through = FreeCAD.Vector(*(deep * inward[0]))
        if edge.Curve.TypeId != "Part::GeomLine":
            return edge.extrude(through).Faces
        way = (points[-1] - points[0]) / np.linalg.norm(points[-1] - points[0])
        first, last = (point if _key(point) in ends else point + sign * ASIDE * thickness * way
                       for point, sign in ((points[0], -1.0), (points[-1], 1.0)))
        corners = [FreeCAD.Vector(*each) for each in (first, last, last + deep * inward[0], first + deep * inward[0])]
        return [Part.Face(Part.makePolygon([*corners, corners[0]]))]
    far = points + deep * inward
    is_closed = edge.isClosed()
    other = _curve(edge, far, is_closed)
    both = np.concatenate([points, far])
    centre = both.mean(axis=0)
    *_, flat = np.linalg.svd(both - centre, full_matrices=False)
    if np.abs((both - centre) @ flat[2]).max() < 1e-6 * thickness:  # a plane meets planes more surely than a ruled surface
        if is_closed:
            larger, smaller = sorted((Part.Wire(edge), Part.Wire(other)), key=lambda wire: -wire.Length)
            return Part.Face(larger).cut(Part.Face(smaller)).Faces
        sides = [Part.makeLine(FreeCAD.Vector(*a), FreeCAD.Vector(*b)) for a, b in zip(points[[0, -1]], far[[0, -1]])]
        return [Part.Face(Part.Wire(Part.__sortEdges__([edge, *sides, other])))]
    return Part.makeRuledSurface(edge, other).Faces


def _curve(edge, points, is_closed):
    """An edge through points that come of those along an edge, of the same kind where that may be."""
    import FreeCAD
    import Part

    vectors = [FreeCAD.Vector(*point) for point in points]
    if edge.Curve.TypeId == "Part::GeomCircle":
        if not is_closed:
            return Part.Arc(vectors[0], vectors[len(vectors) // 2], vectors[-1]).toShape()
        centre = points[:-1].mean(axis=0)
        # Begun where the edge begins.
        circle = edge.Curve.copy()
        circle.Center, circle.Radius = FreeCAD.Vector(*centre), float(np.linalg.norm(points[0] - centre))
        return circle.toShape(edge.FirstParameter, edge.FirstParameter + 2.0 * math.pi)
    if edge.Curve.TypeId == "Part::GeomLine":
        if np.linalg.norm(np.cross(np.diff(points, axis=0), points[-1] - points[0]), axis=1).max() < 1e-9:
            return Part.makeLine(vectors[0], vectors[-1])
    spline = Part.BSplineCurve()
    spline.interpolate(vectors[:-1] if is_closed else vectors, PeriodicFlag=is_closed)
    return spline.toShape()


def _within(raw, shape, edge, thickness):
    """Pieces of a face within a solid that begin at an edge, list of Part.Face."""
    import FreeCAD

    found = []
    middle = _vertex(edge.valueAt(0.5 * (edge.FirstParameter + edge.LastParameter)))
    for piece in raw.common(shape).Faces:
        if piece.distToShape(middle)[0] > ON_CUT * thickness:
            continue
        points, areas = spread_points(piece, thickness)
        if len(points) and shape.isInside(FreeCAD.Vector(*_inner_point(piece, points, areas)), 1e-3 * thickness, False):
            found.append(piece)
    return found


def rows_on(points, cut, thickness):
    """Rows of points that lie on a cut: ndarray of int64.

    Parameters
    ----------
    points : ndarray of shape (v, 3), mm
    cut : Part.Face
    thickness : float, mm
        Of the wall.
    """
    import FreeCAD

    near, box = ON_CUT * thickness, cut.BoundBox
    low, high = np.array([box.XMin, box.YMin, box.ZMin]) - near, np.array([box.XMax, box.YMax, box.ZMax]) + near
    rows = np.flatnonzero(((points >= low) & (points <= high)).all(axis=1))
    return np.array([row for row in rows.tolist() if
                     cut.distToShape(_vertex(FreeCAD.Vector(*points[row])))[0] <= near], dtype=np.int64)
