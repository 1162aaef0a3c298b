# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sides of the box of round parts: those of the solid, however coarse the facets are."""

import numpy as np
import pytest

from thinpart_workbench.core.analysis_settings import AnalysisSettings
from thinpart_workbench.core.mesh.bounds import minimal_box
from thinpart_workbench.core.mesh.round_sides import box_of_round_sides
from thinpart_workbench.freecad_adapter.shapes.part import SolidPart

ANALYTIC = 2e-7
"""Greatest error of a side, as a share of it. On planes, cylinders, cones, spheres and tori only the rounding of points is
left."""

FREE_FORM = 3e-4
"""The same where circles approximate other curves: at 20 degrees, at the tip of an ellipse."""


def round_shapes():
    import FreeCAD
    import Part

    up = FreeCAD.Vector(0, 0, 1)
    zero = FreeCAD.Vector()
    ellipse = Part.Face(Part.Wire(Part.Ellipse(zero, 15, 8).toShape()))
    oblique = Part.makeBox(100, 100, 100, FreeCAD.Vector(-50, -50, 0))
    oblique.rotate(zero, FreeCAD.Vector(1, 0, 0), 25)
    oblique.translate(FreeCAD.Vector(0, 0, 30))
    rounded = Part.makeBox(40, 20, 10)
    return {
        "cylinder": (Part.makeCylinder(5, 30), ANALYTIC),
        "washer": (Part.makeCylinder(20, 2).cut(Part.makeCylinder(9, 2)), ANALYTIC),
        "cone": (Part.makeCone(10, 0, 10), ANALYTIC),
        "frustum": (Part.makeCone(20, 10, 60), ANALYTIC),
        "sphere": (Part.makeSphere(20), ANALYTIC),
        "hemisphere": (Part.makeSphere(10, zero, up, 0, 90, 360), ANALYTIC),
        "capsule": (Part.makeCylinder(5, 30).multiFuse([
            Part.makeSphere(5), Part.makeSphere(5, FreeCAD.Vector(0, 0, 30))]).removeSplitter(), ANALYTIC),
        "torus": (Part.makeTorus(20, 5), ANALYTIC),
        "rounded block": (rounded.makeFillet(3, rounded.Edges), ANALYTIC),
        "half a cylinder": (Part.makeCylinder(10, 30, zero, up, 180), ANALYTIC),
        "cylinder cut off": (Part.makeCylinder(10, 60).cut(oblique), FREE_FORM),
        "ellipse": (ellipse.extrude(FreeCAD.Vector(0, 0, 12)), FREE_FORM),
    }


def box_and_sides_of_the_solid(shape, degrees):
    """Sides of the box by the mesh, and by FreeCAD's exact box of the solid along the same axes."""
    import FreeCAD

    settings = AnalysisSettings(angular_deflection=degrees)
    mesh, _ = SolidPart("Part", "Part", shape=shape).surface_mesh(settings, settings.linear_deflection)
    box = box_of_round_sides(mesh, minimal_box(mesh.vertices))
    axes = box.axes * np.linalg.det(box.axes)
    along = FreeCAD.Matrix(*(value for axis in axes for value in (*axis, 0.0)), 0.0, 0.0, 0.0, 1.0)
    exact = shape.transformed(along, copy=True).optimalBoundingBox(False)
    return box.dimensions, (exact.XLength, exact.YLength, exact.ZLength)


@pytest.mark.parametrize("degrees", [6.0, 9.0, 12.0])
@pytest.mark.parametrize("place", ["straight", "turned"])
@pytest.mark.parametrize("name", [
    "cylinder", "washer", "cone", "frustum", "sphere", "hemisphere", "capsule", "torus", "rounded block", "half a cylinder",
    "cylinder cut off", "ellipse"])
def test_sides_are_those_of_the_solid(name, place, degrees):
    import FreeCAD

    shape, error = round_shapes()[name]
    if place == "turned":
        shape.rotate(FreeCAD.Vector(1, 2, 3), FreeCAD.Vector(1, -2, 0.7), 37.0)
    sides, exact = box_and_sides_of_the_solid(shape, degrees)
    assert sides == pytest.approx(exact, rel=error)


def test_nothing_rises_over_straight_edges_that_turn_by_little():
    import FreeCAD
    import Part

    corners = [FreeCAD.Vector(20 * np.cos(turn), 20 * np.sin(turn), 0) for turn in np.radians(np.arange(0.0, 360.1, 15.0))]
    many_sided = Part.Face(Part.makePolygon(corners)).extrude(FreeCAD.Vector(0, 0, 10))
    bored = many_sided.cut(Part.makeCylinder(4, 10))
    for shape in (many_sided, bored):
        shape.rotate(FreeCAD.Vector(), FreeCAD.Vector(1, 2, 3), 37.0)
        sides, exact = box_and_sides_of_the_solid(shape, 12.0)
        assert sides == pytest.approx(exact, rel=ANALYTIC)
