# SPDX-License-Identifier: LGPL-2.1-or-later
"""The normals that a mesh has from the faces of its part."""

from dataclasses import replace

import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.mass_properties import volume
from thinpart_workbench.core.mesh.smooth_normals import CREASE
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart

SETTINGS = AnalysisSettings()


def rounded_block(part):
    block = part.makeBox(30, 20, 10)
    return block.makeFillet(3, block.Edges)


def quarter_of_a_ring(part):
    import FreeCAD

    return part.makeTorus(20, 4, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), -180, 180, 90)


def half_of_a_bored_cone(part):
    return part.makeCone(12, 4, 20).cut(part.makeCylinder(2, 20)).common(part.makeBox(50, 50, 50))


def free_form(part):
    return rounded_block(part).toNurbs()


def lofted(part):
    import FreeCAD

    wires = [part.Wire(part.makeCircle(radius, FreeCAD.Vector(0, 0, height)))
             for radius, height in ((9, 0), (5, 12), (8, 30))]
    return part.makeLoft(wires, True).common(part.makeBox(40, 40, 40))


def bent_wire(part):
    import FreeCAD

    path = part.Wire(part.makeCircle(30, FreeCAD.Vector(), FreeCAD.Vector(0, 0, 1), 0, 200))
    profile = part.Wire(part.makeCircle(1.0, FreeCAD.Vector(30, 0, 0), FreeCAD.Vector(0, 1, 0)))
    return path.makePipeShell([profile], True, True).toNurbs()


def greatest_error(shape, mesh):
    """Degrees between normals at corners and those of the faces there, without facets turned far from their face."""
    import FreeCAD

    worst = 0.0
    for number, face in enumerate(shape.Faces):
        if face.Surface.TypeId == "Part::GeomPlane":
            continue
        for triangle in np.flatnonzero(mesh.face_of_triangle == number)[::7]:
            for corner in range(3):
                point = FreeCAD.Vector(*(mesh.corners[triangle, corner] + mesh.origin))
                try:
                    normal = np.array(tuple(face.normalAt(*face.Surface.parameter(point))))
                except Exception:  # FreeCAD's own, at poles
                    continue
                if abs(normal @ mesh.normals[triangle]) < np.cos(CREASE):
                    continue
                cosine = abs(normal @ mesh.corner_normals[corner, :, triangle])
                worst = max(worst, np.degrees(np.arccos(min(1.0, cosine))))
    return worst


@pytest.mark.parametrize("shift", [0.0, 2000.0])
@pytest.mark.parametrize("make", [rounded_block, quarter_of_a_ring, half_of_a_bored_cone, free_form, lofted, bent_wire])
def test_every_normal_of_a_curved_face_is_that_of_the_geometry(make, shift):
    import FreeCAD
    import Part

    shape = make(Part).Solids[0]
    shape.translate(FreeCAD.Vector(shift, 0, -shift))
    shape.rotate(FreeCAD.Vector(), FreeCAD.Vector(1, 2, 3), 20)
    mesh, _ = SolidPart("part", "part", shape=shape).surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    assert greatest_error(shape, mesh) < 0.3


@pytest.mark.parametrize("make", [half_of_a_bored_cone, lofted])
def test_volumes_follow(make):
    """By the means of facets, which are one-sided at the border of a face, 0.05 to 0.08 % of these were missing."""
    import Part

    shape = make(Part).Solids[0]
    mesh, _ = SolidPart("part", "part", shape=shape).surface_mesh(SETTINGS, SETTINGS.linear_deflection)
    assert volume(mesh) == pytest.approx(shape.Volume, rel=2e-5)


def test_a_kink_within_a_face_stays():
    """The geometry has the normal of one of its sides there, and the facets of the other side keep their own."""
    import FreeCAD
    import Part

    surface = Part.BSplineSurface()
    heights = (0.0, 0.0, 6.0)  # a roof: flat, then at 31 degrees
    poles = [[FreeCAD.Vector(10.0 * column, 12.0 * row, height) for row in range(2)]
             for column, height in enumerate(heights)]
    surface.buildFromPolesMultsKnots(poles, (2, 1, 2), (2, 2), (0, 1, 2), (0, 1), False, False, 1, 1)
    mesh, _ = SolidPart("part", "part", shape=surface.toShape()).surface_mesh(SETTINGS, SETTINGS.linear_deflection)

    def turned(normals):
        cosine = np.einsum("ijk,kj->ik", normals, mesh.normals).mean(axis=0)
        return np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0))) @ mesh.areas / mesh.areas.sum()

    assert turned(mesh.corner_normals) < 0.5 * turned(replace(mesh, face_normals=None).corner_normals)


def test_a_face_that_could_not_be_tessellated_has_no_nodes():
    """OCC leaves out faces of damaged parts, and FreeCAD raises where their nodes are asked for."""
    import Part

    from thinpart_workbench.freecad_adapter.tessellating.tessellation import _node_parameters

    shape = Part.makeSphere(5).toNurbs()
    assert _node_parameters(shape.Faces[0]) == []
    shape.tessellate(0.5)
    assert len(_node_parameters(shape.Faces[0])) > 20
