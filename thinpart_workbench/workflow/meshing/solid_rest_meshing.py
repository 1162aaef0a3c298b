# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a part is no wall, as tetrahedra that are tied to its shell."""

import os
import tempfile

import numpy as np

from ...core.analysis_settings import AnalysisSettings
from ...core.errors import ThinPartError
from ...core.message import message
from ...core.shells.facing_faces import facing_faces
from ...core.shells.mixed_mesh import SolidMesh, area_of_sides, reached_by, sides_on
from ...core.sizing.size_proposal import propose_sizes
from ...core.sizing.sizing_settings import SizingSettings
from ...core.thickness.measurement import measure
from ...freecad_adapter.shapes.brep_file import write_brep
from ...freecad_adapter.shapes.part import SolidPart
from ...storage.exchange.msh_file import read_tetrahedra
from .mesh_check import MESH, checked_sizes, mesh_figures

LEAST_REST, LEAST_WALLS = 0.05, 0.2
"""Shares of the part's volume from which on there is a solid beside the shell: of what is no wall, and of the walls."""

LEAST_TIED = 0.8
"""Share of the area of the cuts that sides of the shell have to reach."""


def rest_of_part(part, measurement, middle, solid_walls=()):
    """Cut a part into walls and what is none: SolidRest, or None where nothing of it is worth a solid.

    Raises ThinPartError, kind ``no_shell`` where it cannot be cut.

    Parameters
    ----------
    part : SolidPart
    measurement : Measurement
    middle : MidSurface
    solid_walls : tuple of tuple of int
        As of `ShellSettings`. Thick bodies beside slender walls stay solid anyhow, unless these are few.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.mid_faces import mid_surface
    from ...freecad_adapter.mid_surface.solid_rest import solid_rest, stocky_walls

    stocky = [middle.walls[number] for number in stocky_walls(middle)]
    known, left = (sum(wall.area * wall.thickness for wall in walls) for walls in (middle.walls, stocky))
    if stocky and known - left >= LEAST_WALLS * measurement.volume_mm3:
        middle = mid_surface(part.shape, facing_faces(measurement.field), measurement.field.mesh, measurement.rays,
                             solid_walls=(*solid_walls, *(tuple(sorted(wall.faces)) for wall in stocky)))
    rest = solid_rest(part.shape, middle)
    if rest is None or rest.volume < LEAST_REST * measurement.volume_mm3:
        return None
    if rest.volume > (1.0 - LEAST_WALLS) * measurement.volume_mm3:
        raise ThinPartError(message("Only {share:.0f} % of the volume of {part} can be cut off as walls.", part=part.label,
                                    share=100.0 * (1.0 - rest.volume / measurement.volume_mm3)), "no_shell")
    return rest


def solid_mesh(part, rest, shell, program, seconds, volume):
    """Mesh what is no wall, and tie it to the shell: SolidMesh.

    Each body is meshed as a part of its own is by default: by the error aimed at, with what helps where Gmsh fails.

    Raises ThinPartError, kind ``no_shell`` where there is no mesh, or the shell does not reach the cuts.

    Parameters
    ----------
    part : SolidPart
    rest : SolidRest
    shell : ShellMesh
        Of its mid-surface, of second order.
    program : str
        Path of Gmsh.
    seconds : float
        Limit for each mesh.
    volume : float, mm3
        Of the part.
    """
    # Imported here since the adapter loads FreeCAD.
    from ...freecad_adapter.mid_surface.solid_rest import rows_on

    points, tetrahedra, count = [], [], 0
    for solid in rest.solids:
        own, elements = _tetrahedra(part, solid, program, seconds)
        points.append(own)
        tetrahedra.append(elements + count)
        count += len(own)
    points, tetrahedra = np.concatenate(points), np.concatenate(tetrahedra)
    used, rows = np.unique(tetrahedra, return_inverse=True)
    points, tetrahedra = points[used], rows.reshape(tetrahedra.shape)
    thickness, tied, sides, reached, area = float(shell.thickness.min()), [], [], 0.0, 0.0
    for cut in rest.cuts:
        is_on = np.zeros(len(shell.points), dtype=bool)
        is_on[rows_on(shell.points, cut, thickness)] = True
        sides.append(sides_on(shell.triangles, is_on))
        own = rows_on(points, cut, thickness)
        tied.append(own[reached_by(shell, sides[-1], points[own])])
        reached += min(area_of_sides(shell, sides[-1]), cut.Area)
        area += cut.Area
    if reached < LEAST_TIED * area:
        raise ThinPartError(message(
            "The shell of {part} reaches only {share:.0f} % of the cuts between its walls and what is solid.",
            part=part.label, share=100.0 * reached / area), "no_shell")
    return SolidMesh(points, tetrahedra, np.unique(np.concatenate(tied)), np.unique(np.concatenate(sides), axis=0),
                     rest.volume / volume)


def _tetrahedra(part, solid, program, seconds):
    """Points and tetrahedra of second order of one body."""
    settings, body = AnalysisSettings(), SolidPart(part.name, part.label, shape=solid)
    surface, _ = body.surface_mesh(settings, settings.linear_deflection)
    measurement = measure(surface, settings)
    proposal = propose_sizes(measurement, 0.0, SizingSettings())
    with tempfile.TemporaryDirectory(prefix="thinpart-solid-") as folder:
        file = os.path.join(folder, "solid.brep")
        write_brep(solid, file)
        default = None if proposal.is_uniform else mesh_figures(0.0, "")
        check, _ = checked_sizes(program, file, measurement, proposal, seconds, folder, default)
        figures = check["proposed"]
        if not figures["elements"]:
            raise ThinPartError(message("What is solid of {part} could not be meshed ({problem}).", part=part.label,
                                        problem=figures["reason"]), "no_shell")
        return read_tetrahedra(os.path.join(folder, MESH), 2)
