# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are thin as a whole."""

import math

import Part
import Sketcher
from FreeCAD import Vector

from .body_objects import (
    body,
    dress_up_body,
    pad,
    show_tip_only,
    sketch_circles,
    sketch_on,
    sketch_rectangle,
    through_pocket,
)
from .edge_choice import is_line, lies_at
from .part_objects import X, Z, add, box, cut, cylinder, extrusion, fillet, hide, polygon


def plate(doc):
    """A mounting plate: D2/D3 = 15, and 8 mm is 4 % of diag."""
    length, width, thickness = 160, 120, 8
    part = body(doc, "Mounting plate")
    outline = sketch_on(part, "XY", "Outline")
    sketch_rectangle(outline, length, width)
    pad(part, "Plate", outline, thickness)
    holes = sketch_on(part, "XY", "Holes", offset=thickness)
    corners = [(x * 62, y * 42, 11) for x in (-1, 1) for y in (-1, 1)]
    sketch_circles(holes, corners + [(0, 0, 50)])
    through_pocket(part, "Bores", holes)

    def is_corner(edge):
        point = edge.CenterOfMass
        return is_line(edge, Z) and abs(point.x) > length / 2 - 1 and abs(point.y) > width / 2 - 1

    dress_up_body(part, "PartDesign::Fillet", "Rounded corners", 12.0, is_corner)
    show_tip_only(part)
    return [part]


def bent_sheet_bracket(doc):
    """An angle bracket of 2 mm sheet; most of its bounding box is empty."""
    foot, upright, width, sheet, inside = 60.0, 50.0, 56.0, 2.0, 3.0
    outside = inside + sheet
    part = body(doc, "Angle bracket")

    # The side view: two flanges and the bend between them, all around the bend's center.
    profile = sketch_on(part, "XZ", "Side view")
    center = Vector(outside, outside, 0)
    half_turn, three_quarters = math.pi, 1.5 * math.pi

    def line(x1, y1, x2, y2):
        return Part.LineSegment(Vector(x1, y1, 0), Vector(x2, y2, 0))

    def bend(radius):
        return Part.ArcOfCircle(Part.Circle(center, Z, radius), half_turn, three_quarters)

    profile.addGeometry(
        [
            bend(outside),  # 0: from the upright's outer face (point 1) to the foot's (point 2)
            line(outside, 0, foot, 0),  # 1
            line(foot, 0, foot, sheet),  # 2
            line(foot, sheet, outside, sheet),  # 3
            bend(inside),  # 4
            line(sheet, outside, sheet, upright),  # 5
            line(sheet, upright, 0, upright),  # 6
            line(0, upright, 0, outside),  # 7
        ],
        False,
    )
    constraint = Sketcher.Constraint
    profile.addConstraint(
        [constraint("Tangent", 0, 2, 1, 1), constraint("Tangent", 7, 2, 0, 1)]
        + [constraint("Tangent", 3, 2, 4, 2), constraint("Tangent", 4, 1, 5, 1)]
        + [constraint("Coincident", i, 2, i + 1, 1) for i in (1, 2, 5, 6)]
        + [constraint("Coincident", 0, 3, 4, 3)]
        + [constraint("Horizontal", i) for i in (1, 3, 6)]
        + [constraint("Vertical", i) for i in (2, 5, 7)]
        + [
            constraint("PointOnObject", 1, 1, -1),
            constraint("PointOnObject", 7, 1, -2),
            constraint("Radius", 4, inside),
            constraint("DistanceY", 2, 1, 2, 2, sheet),
            constraint("DistanceX", -1, 1, 1, 2, foot),
            constraint("DistanceY", -1, 1, 7, 1, upright),
        ]
    )
    # The normal of the XZ plane is -Y, hence the reversed direction.
    pad(part, "Sheet", profile, width, reverse=True)

    foot_holes = sketch_on(part, "XY", "Holes in the foot", offset=sheet)
    sketch_circles(foot_holes, [(40, 14, 6.6), (40, 42, 6.6)])
    through_pocket(part, "Foot holes", foot_holes)
    upright_hole = sketch_on(part, "YZ", "Hole in the upright", offset=sheet)
    sketch_circles(upright_hole, [(width / 2, 30, 20), (12, 40, 4.5), (44, 40, 4.5)])
    through_pocket(part, "Upright holes", upright_hole)

    def is_free_corner(edge):
        point = edge.CenterOfMass
        at_foot = is_line(edge, Z) and abs(point.x - foot) < 1e-6
        at_upright = is_line(edge, X) and abs(point.z - upright) < 1e-6
        return abs(edge.Length - sheet) < 1e-6 and (at_foot or at_upright)

    dress_up_body(part, "PartDesign::Fillet", "Rounded corners", 8.0, is_free_corner)
    show_tip_only(part)
    return [part]


def tube(doc):
    """R 20, wall 2, length 60."""
    outer = cylinder(doc, "Outside", 40, 60)
    inner = cylinder(doc, "Inside", 36, 60)
    return [cut(doc, "Tube", outer, inner)]


def heat_sink(doc):
    """Sixteen fins: their flanks are most of the surface, at 1.5 mm or 1.4 % of diag."""
    fins, pitch, fin, height, base, length = 16, 5.0, 1.5, 32.0, 6.0, 70.0
    width = (fins - 1) * pitch + fin
    points = [(0, 0, 0), (width, 0, 0)]
    for i in reversed(range(fins)):
        right = i * pitch + fin
        points += [(right, 0, height), (right - fin, 0, height)]
        if i:
            points += [(right - fin, 0, base), (right - pitch, 0, base)]
    profile = polygon(doc, "Comb profile", points)
    comb = extrusion(doc, "Extruded comb", profile, Vector(0, length, 0))
    # Tapped-hole cores from below; they end inside the base, 2 mm under the fin gaps.
    holes = [
        cylinder(doc, f"Hole {2 * i + j + 1}", 3.3, 4, (x, y, 0))
        for i, x in enumerate((12, width - 12))
        for j, y in enumerate((12, length - 12))
    ]
    return [cut(doc, "Heat sink", comb, *holes)]


def plate_with_openings(doc):
    """The paper's figure 7.a: so many openings that the plate fills less than 80 % of its box; D2/D3 = 13.8."""
    length, width, thickness = 150, 110, 8
    part = body(doc, "Cover plate")
    outline = sketch_on(part, "XY", "Outline")
    sketch_rectangle(outline, length, width)
    pad(part, "Plate", outline, thickness)
    openings = sketch_on(part, "XY", "Openings", offset=thickness)
    corners = [(x * 54, y * 34, 22) for x in (-1, 1) for y in (-1, 1)]
    sketch_circles(openings, corners + [(0, 0, 62)])
    through_pocket(part, "Bores", openings)
    show_tip_only(part)
    return [part]


def pipe_bend(doc):
    """The paper's figure 6.b, a very curved part: a bend of 90 degrees of a pipe with a wall of 2 mm."""
    outside, inside = (
        add(doc, "Part::Torus", label, Radius1=50.0, Radius2=radius, Angle3=90.0)
        for label, radius in (("Outside", 20.0), ("Inside", 18.0)))
    return [cut(doc, "Pipe bend", outside, inside)]


def shaft(doc):
    """A stepped shaft: every diameter is under a quarter of diag, so it is thin as a whole."""
    # (diameter, length) of the steps from the left to the right.
    steps = [(24, 34), (30, 46), (40, 14), (34, 58), (26, 38)]
    profile = add(doc, "Part::Feature", "Half section", Shape=_shaft_section(steps, 1.5, 1.6))
    hide(profile)
    return [add(doc, "Part::Revolution", "Shaft", Source=profile, Axis=Z, Base=Vector(), Angle=360.0,
                Solid=True)]


def _shaft_section(steps, chamfer_size, fillet_radius):
    """Half the section of a stepped shaft along Z, as a closed wire in the XZ plane.

    The ends are chamfered, and the inner corner of each shoulder is rounded.
    """
    edges = []
    pen = Vector()

    def line_to(radius, z):
        nonlocal pen
        end = Vector(radius, 0, z)
        edges.append(Part.makeLine(pen, end))
        pen = end

    def quarter_to(radius, z, center_radius, center_z):
        nonlocal pen
        end, center = Vector(radius, 0, z), Vector(center_radius, 0, center_z)
        outwards = (pen + end) * 0.5 - center
        middle = center + outwards.normalize() * fillet_radius
        edges.append(Part.Arc(pen, middle, end).toShape())
        pen = end

    z = 0.0
    line_to(steps[0][0] / 2 - chamfer_size, z)
    line_to(steps[0][0] / 2, z + chamfer_size)
    for (diameter, length), (following, _) in zip(steps, steps[1:]):
        z += length
        before, after = diameter / 2, following / 2
        foot = min(before, after) + fillet_radius  # where a fillet meets the shoulder
        if before < after:
            line_to(before, z - fillet_radius)
            quarter_to(foot, z, foot, z - fillet_radius)
            line_to(after, z)
        else:
            line_to(before, z)
            line_to(foot, z)
            quarter_to(after, z + fillet_radius, foot, z + fillet_radius)
    z += steps[-1][1]
    line_to(steps[-1][0] / 2, z - chamfer_size)
    line_to(steps[-1][0] / 2 - chamfer_size, z)
    line_to(0, z)
    line_to(0, 0)
    return Part.Wire(edges)


def nearly_square_dish(doc):
    """A tray, 120 x 110 x 16, with 5 mm floor and walls: low, nearly square, half empty."""
    length, width, height, wall = 120.0, 110.0, 16.0, 5.0

    def vertical(edge):
        return is_line(edge, Z)

    outside = box(doc, "Outside block", (length, width, height))
    outside = fillet(doc, "Outside", outside, 15.0, vertical)
    hollow = (length - 2 * wall, width - 2 * wall, height - wall)
    hollow = box(doc, "Hollow block", hollow, (wall, wall, wall))
    hollow = fillet(doc, "Hollow corners", hollow, 10.0, vertical)
    hollow = fillet(doc, "Hollow", hollow, 4.0, lambda e: lies_at(e, Z, wall))
    dish = cut(doc, "Sharp dish", outside, hollow)
    return [fillet(doc, "Dish", dish, 1.0, lambda e: lies_at(e, Z, height))]
