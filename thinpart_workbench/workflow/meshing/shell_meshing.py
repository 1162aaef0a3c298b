# SPDX-License-Identifier: LGPL-2.1-or-later
"""The mid-surface of a part as a mesh of triangles: faces by FreeCAD, triangles by Gmsh, thickness by rays."""

from contextlib import suppress
from dataclasses import dataclass
from typing import Optional

import numpy as np

from ...core.descriptors.region_kinds import PLATE, TUBE
from ...core.errors import ThinPartError
from ...core.figures import Length
from ...core.message import message
from ...core.shells.facing_faces import facing_faces
from ...core.shells.mixed_mesh import SolidMesh
from ...core.shells.open_ends import open_ends
from ...core.shells.shell_mesh import ShellMesh, shell_mesh
from ...core.shells.shell_settings import SHARE_OF_DIAGONAL, ShellSettings
from ...core.shells.sound_triangles import sound_triangles
from .one_sided_shell import one_sided_middles, sides_of_part
from .shell_triangles import AROUND, shell_sizes, shell_triangles
from .solid_rest_meshing import rest_of_part, solid_mesh

ACROSS = 2.0
"""Elements across a flat wall; of a round one, its curvature says more."""

AROUND_TIED = 12
"""Elements around a circle where solids are tied to round edges: a tube on a flange is 3 % too stiff so, 8 % with six."""

LEAST_WALLS = 0.4
"""Share of the part's volume that walls with a mid-surface must have before it is made: at joints, it grows into more."""

LEAST_VOLUME, MOST_VOLUME = 0.6, 1.3
"""Share of the part's volume that a shell must have to be one: joints count for each wall, what is left solid does not."""

LEAST_MIXED, MOST_MIXED = 0.85, 1.15
"""The same of a shell with the rest as solid."""

TOLD_INSIDE, MOST_INSIDE = 0.02, 0.5
"""Share of the free edges of a shell that may end inside the material: without a warning, and at all."""

EQUAL = 0.05
"""Difference of what two shells lack up to which they are as good: that of mid-faces is taken, or with fewer triangles."""

INSIDE_WEIGHT = 4.0
"""What a share of the free edges inside the material counts by a share of the volume: a crack weakens more than a missing
lug."""

LEFT_SHARE = 0.002
"""Share of the surface from which on faces that no wall has are left solid."""


@dataclass(frozen=True)
class PartShell:
    """A part as a shell.

    Attributes
    ----------
    mesh : ShellMesh
    size : float, mm
        Of the elements.
    volume_share : float
        Area by thickness of the shell, by the volume of the part; joints count for each wall.
    walls : list of dict
        ``thickness``, ``area`` of one side, mm and mm2, and ``faces``: names.
    left_solid : list of dict
        Walls that are no shell: ``kind``, ``thickness``, ``volume_share`` and ``faces`` of the wall region.
    warnings : list of str
    shape : Part.Shape
        The mid-surface that was meshed, or the side of the wall that was.
    wall_of_face : list of int
        Number of the wall, from 0, that each of its faces belongs to.
    is_moved : bool
        Whether a side was meshed and its triangles moved to the middle: they do not lie on the shape.
    lacking : float
        How far it is from standing for the part: difference of the volumes, and share of its free edges inside the material.
    solid : SolidMesh or None
        The rest of the part, where that was wanted and there is some.
    """

    mesh: ShellMesh
    size: float
    volume_share: float
    walls: list
    left_solid: list
    warnings: list
    shape: object
    wall_of_face: list
    is_moved: bool = False
    lacking: float = 0.0
    solid: Optional[SolidMesh] = None


def shell_obstacle(part, measurement):
    """Why a shell of a measured part cannot be made, as far as that is known without making it.

    Returns a str: a sentence; empty if nothing stands against it.

    Parameters
    ----------
    part : SolidPart or MeshedPart
    measurement : Measurement
    """
    obstacle = shell_walls(part, measurement)[1]
    return "" if obstacle and _is_one_wall(part, measurement) else obstacle


def _is_one_wall(part, measurement):
    """Whether a side of a part may make its shell."""
    if not hasattr(part, "shape") or measurement.rays is None or measurement.volume_mm3 is None:
        return False
    sides = sides_of_part(part, measurement)
    return bool(sides) and sides[0].area * sides[0].thickness >= LEAST_VOLUME * measurement.volume_mm3


def shell_walls(part, measurement):
    """The walls of a measured part that have a mid-surface of their own, and why they make no shell.

    Returns `walls` (list of MidWall) and `obstacle` (str; see `shell_obstacle`).
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.mid_faces import mid_walls

    if not hasattr(part, "shape"):
        return [], message("{part} is made of triangles, which have no mid-surface: use its STEP file, or mesh it as a "
                           "solid.", part=part.label)
    if measurement.rays is None or measurement.volume_mm3 is None:
        return [], message("{part} has no shell, since it is not closed or was measured by pairs: close its gaps (Part "
                           "workbench, Check geometry), or measure it by rays.", part=part.label)
    walls = mid_walls(part.shape, facing_faces(measurement.field), measurement.field.mesh, measurement.rays)
    if not walls:
        return [], message("No wall of {part} is wide and thin enough for a shell: mesh it as a solid.", part=part.label)
    share = sum(wall.area * wall.thickness for wall in walls) / measurement.volume_mm3
    return (walls, "") if share >= LEAST_WALLS else ([], _too_little(part, share))


def _too_little(part, share):
    return message("{part} has no shell: walls with a mid-surface have only {share:.0f} % of its volume. Mesh it as a "
                   "solid.", part=part.label, share=100.0 * share)


def shell_of_part(part, measurement, program, seconds, settings=None, report=None):
    """Make the shell of a measured part: PartShell.

    Raises ThinPartError, kind ``no_shell`` where the part is not thin enough, or its mid-surface cannot be made;
    ``no_solid`` for triangles.

    Parameters
    ----------
    part : SolidPart
    measurement : Measurement
    program : str
        Path of Gmsh.
    seconds : float
        Limit for meshing.
    settings : ShellSettings, optional
    report : callable, optional
        Called with the fraction that is done.
    """
    settings, report = settings or ShellSettings(), report or (lambda fraction: None)
    try:
        found = _from_mid_faces(part, measurement, program, seconds, settings, report)
    except ThinPartError as error:
        if error.kind != "no_shell" or settings.solid_walls:
            raise
        if settings.on_faces:
            if _is_one_wall(part, measurement):
                raise ThinPartError(message(
                    "{problem} As a file it may have a shell all the same, without faces for supports: "
                    "./thinpart size FILE --shell shell.inp.", problem=error), "no_shell") from None
            raise
        moved = _from_one_side(part, measurement, program, seconds, settings)
        if moved is None:
            raise
        return moved
    if not found.warnings or settings.on_faces or settings.solid_walls:
        return found
    moved = _from_one_side(part, measurement, program, seconds, settings)
    return found if moved is None or moved.lacking > found.lacking - EQUAL else moved


def _from_mid_faces(part, measurement, program, seconds, settings, report):
    """The shell whose faces lie half-way between two faces each."""
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.mid_faces import mid_surface

    obstacle = shell_walls(part, measurement)[1]
    if obstacle:
        raise ThinPartError(obstacle, "no_shell" if hasattr(part, "shape") else "no_solid")
    middle = mid_surface(part.shape, facing_faces(measurement.field), measurement.field.mesh, measurement.rays,
                         lambda done: report(0.9 * done), settings.solid_walls)
    report(0.9)
    warnings = []
    if settings.has_rest and settings.order == 2:
        try:
            rest = rest_of_part(part, measurement, middle, settings.solid_walls)
            if rest is not None:
                return _with_rest(part, measurement, rest, program, seconds, settings)
        except ThinPartError as error:
            warnings = [message("What is solid of {part} is not in the file. {problem}", part=part.label, problem=error)]
    size, mesh = _meshed(part, measurement, middle, program, seconds, settings)
    return _part_shell(part, measurement, middle, size, mesh, warnings)


def _with_rest(part, measurement, rest, program, seconds, settings):
    """The shell of a part with the rest of it as solid: PartShell."""
    middle = rest.middle
    size, mesh = _meshed(part, measurement, middle, program, seconds, settings, AROUND_TIED if rest.is_round else AROUND)
    share = mesh.volume / measurement.volume_mm3
    solid = solid_mesh(part, rest, mesh, program, seconds, measurement.volume_mm3)
    if not LEAST_MIXED < share + solid.volume_share < MOST_MIXED:
        raise ThinPartError(message("Shell and solid of {part} would count for {share:.0f} % of its volume.",
                                    part=part.label, share=100.0 * (share + solid.volume_share)), "no_shell")
    return PartShell(mesh, size, share, _walls(middle, mesh), [], [], middle.shape, list(middle.wall_of_face), solid=solid)


def _meshed(part, measurement, middle, program, seconds, settings, around=AROUND):
    """Element size and ShellMesh of a mid-surface."""
    sizes = _sizes(middle, measurement)
    if settings.size:
        sizes = np.full(len(sizes), settings.size)
    points, triangles, number = shell_triangles(part, middle.shape, program, seconds, sizes, settings.order, around)
    return float(sizes.max()), _thick(measurement, middle, points, triangles, np.array(middle.wall_of_face)[number])


def _thick(measurement, middle, points, triangles, wall):
    """The ShellMesh with the triangles of a mid-surface."""
    points, triangles, kept = sound_triangles(points, triangles, np.array([each.thickness for each in middle.walls])[wall])
    return shell_mesh(points, triangles, wall[kept], middle.walls, measurement.field.mesh, measurement.rays)


def _from_one_side(part, measurement, program, seconds, settings):
    """The shell whose triangles were moved from one side of the wall; None where that is none either."""
    if not _is_one_wall(part, measurement):
        return None
    found = []
    with suppress(ThinPartError):
        for middle in one_sided_middles(part, measurement, program, seconds, settings):
            with suppress(ThinPartError):
                mesh = _thick(measurement, middle, middle.points, middle.triangles, middle.wall)
                if mesh.pieces == 1:
                    found.append(_part_shell(part, measurement, middle, middle.size, mesh, is_moved=True))
    least = min((shell.lacking for shell in found), default=0.0)
    return min((shell for shell in found if shell.lacking <= least + EQUAL), key=lambda shell: len(shell.mesh.triangles),
               default=None)


def _part_shell(part, measurement, middle, size, mesh, warnings=(), is_moved=False):
    """The shell of a part, once its mesh has been checked against the part."""
    share = mesh.volume / measurement.volume_mm3
    left, (inside, free) = _left_solid(measurement, middle), open_ends(mesh, measurement.field.mesh, measurement.rays)
    warnings = [*warnings, *_checked(part, mesh, share, _share_of_shell(middle), left, inside, free, is_moved)]
    if middle.loose:
        warnings.append(message("Pieces that do not meet the rest were left out, {share:.2g} % of the volume: they belong "
                                "to what is left solid.", share=100.0 * middle.loose / measurement.volume_mm3))
    lacking = abs(share - 1.0) + (INSIDE_WEIGHT * inside / free if free else 0.0)
    return PartShell(mesh, size, share, _walls(middle, mesh), left, warnings, middle.shape, list(middle.wall_of_face),
                     is_moved, lacking)


def _walls(middle, mesh):
    """The walls of a shell, list of dict."""
    areas = np.bincount(mesh.wall, mesh.areas, len(middle.walls))
    return [{"wall": row + 1, "thickness": each.thickness, "area": float(areas[row]),
             "faces": [f"Face{face + 1}" for face in sorted(each.faces)]} for row, each in enumerate(middle.walls)
            if areas[row] > 0.0]


def _sizes(middle, measurement):
    """Element size on each face: a narrow wall has some elements across, the part has enough in all; ndarray, mm."""
    most = SHARE_OF_DIAGONAL * measurement.descriptors.box.diagonal
    of_wall = np.array([min(most, wall.width / ACROSS) if wall.is_flat else most for wall in middle.walls])
    thickness = np.array([wall.thickness for wall in middle.walls])
    return shell_sizes(middle.shape, thickness[middle.wall_of_face], of_wall[middle.wall_of_face])


def _left_solid(measurement, middle):
    """Wall regions most of whose surface is on no side of a wall that became a shell."""
    field = measurement.field
    pairs = {pair for wall in middle.walls + middle.solid_walls for pair in wall.face_pairs}
    far = np.append(field.mesh.face_of_triangle, -1)[field.opposite]
    covered = np.array([(min(one, other), max(one, other)) in pairs for one, other in zip(field.face, far)], dtype=bool)
    found = []
    for region in measurement.regions.listed:
        own = np.isin(field.face, region.faces) & (field.distance < 1.5 * region.median) & (
            field.distance > region.median / 1.5)
        area = field.area[own].sum()
        if region.area >= LEFT_SHARE * field.area.sum() and area > 0.0 and field.area[own & covered].sum() < 0.5 * area:
            found.append({"kind": region.kind, "thickness": region.median, "volume_share": region.volume_share,
                          "faces": [f"Face{face + 1}" for face in region.faces]})
    loose = [wall for row, wall in enumerate(middle.walls) if row not in middle.wall_of_face] if middle.loose else []
    for wall in middle.solid_walls + loose:
        found.append({"kind": PLATE if wall.is_flat else TUBE, "thickness": wall.thickness,
                      "volume_share": min(1.0, wall.area * wall.thickness / measurement.volume_mm3),
                      "faces": [f"Face{face + 1}" for face in sorted(wall.faces)]})
    return found


def _share_of_shell(middle):
    """Share of the walls that are not to stay solid, by their volume."""
    chosen, left = (sum(wall.area * wall.thickness for wall in walls) for walls in (middle.walls, middle.solid_walls))
    return chosen / (chosen + left)


def _checked(part, mesh, share, wanted, left, inside, free, is_moved):
    """Warnings about a shell; a ThinPartError where it does not stand for the walls that are wanted of the part."""
    if share < LEAST_VOLUME * wanted:
        raise ThinPartError(_too_little(part, share), "no_shell")
    if share > MOST_VOLUME:
        raise ThinPartError(message(
            "{part} has no shell: its walls overlap, and would count for {share:.0f} % of its volume. Mesh it as a solid.",
            part=part.label, share=100.0 * share), "no_shell")
    warnings = []
    if mesh.pieces > 1:
        if not left:
            raise ThinPartError(message(
                "The mid-surface of {part} falls into {count} pieces that do not meet: mesh it as a solid.",
                part=part.label, count=mesh.pieces), "no_shell")
        warnings.append(message("The shell is in {count} pieces: what is left solid lies between them.", count=mesh.pieces))
    # Triangles of one side hang together: what ends inside is a rim that is thicker, as of a bottle.
    if inside > MOST_INSIDE * free and wanted == 1.0 and not is_moved:
        raise ThinPartError(message(
            "The walls of {part} do not meet: {inside} of the {free} of free edges of its mid-surface lie "
            "inside the material. Mesh it as a solid.", part=part.label, inside=Length(inside), free=Length(free)),
                            "no_shell")
    if inside > TOLD_INSIDE * free:
        warnings.append(message(
            "{inside} of the {free} of free edges lie inside the material: there, walls do not meet, or go "
            "over into what is left solid. Close these gaps before solving.", inside=Length(inside), free=Length(free)))
    if share < 0.9:
        warnings.append(message("The shell has {share:.0f} % of the part's volume: the rest is not in the file.",
                                share=100.0 * share))
    return warnings


def shell_record(shell):
    """A shell as plain values, dict: all lengths in mm; nodes from 0."""
    mesh = shell.mesh
    return {"size": float(f"{shell.size:.6g}"), "nodes": len(mesh.points), "elements": len(mesh.triangles),
            "volume_share": float(f"{shell.volume_share:.6g}"), "walls": shell.walls, "left_solid": shell.left_solid,
            "warnings": [str(each) for each in shell.warnings], "reason": "",
            "points": mesh.points.tolist(), "triangles": mesh.triangles.tolist(), "wall": mesh.wall.tolist(),
            "thickness": mesh.thickness.tolist(), "solid": None if shell.solid is None else _solid_record(shell.solid)}


def _solid_record(solid):
    return {"nodes": len(solid.points), "elements": len(solid.tetrahedra),
            "volume_share": float(f"{solid.volume_share:.6g}"), "points": solid.points.tolist(),
            "tetrahedra": solid.tetrahedra.tolist(), "tied": solid.tied.tolist(), "sides": solid.sides.tolist()}


def mesh_of_record(record):
    """The `ShellMesh` of such a dict."""
    return ShellMesh(np.array(record["points"], dtype=np.float64).reshape(-1, 3),
                     np.array(record["triangles"], dtype=np.int64), np.array(record["wall"], dtype=np.int64),
                     np.array(record["thickness"], dtype=np.float64))


def solid_of_record(record):
    """The `SolidMesh` of such a dict; None where it has none."""
    solid = record["solid"]
    if solid is None:
        return None
    tetrahedra, tied, sides = (np.array(solid[key], dtype=np.int64) for key in ("tetrahedra", "tied", "sides"))
    return SolidMesh(np.array(solid["points"], dtype=np.float64), tetrahedra, tied, sides, solid["volume_share"])


def no_shell_record(reason):
    """The same dict where there is no shell, and why."""
    return {"size": 0.0, "nodes": 0, "elements": 0, "volume_share": 0.0, "walls": [], "left_solid": [], "warnings": [],
            "reason": str(reason), "points": [], "triangles": [], "wall": [], "thickness": [], "solid": None}
