#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make the sample parts that are bundled with ThinPart.

    /usr/bin/python3 make_samples.py [--out DIR] [--only NAME ...]

Every part is built from FreeCAD objects, checked, and saved as NAME.FCStd (parametric, or a
computed shape where parametric objects would be fragile) and NAME.step. `samples.json` lists
what each part shows and how the `paper` profile is expected to classify it.

Lengths are in mm. In the comments *diag* is the diagonal of the part's minimum bounding box, *x*
a thickness divided by it, and a *wedge* is a pair of faces that meet at 10 to 55 degrees with
material between them. These are the quantities the criteria are about, so they explain most of
the dimensions chosen below.

Dates and random identifiers are taken out after saving, so that the same FreeCAD makes the same
files again. What remains to differ in a .FCStd file is the last digit of a solved sketch and, from
FreeCAD 1.0 on, the objects' numbers, to which the names of faces and edges refer. The bundled files
were made by FreeCAD 0.20, so that it and all later versions open them.
"""

import argparse
import itertools
import json
import math
import os
import re
import sys
import tempfile
import uuid
import zipfile
from dataclasses import dataclass, field


def _find_freecad():
    """Make `import FreeCAD` work from a plain Python (not needed inside FreeCAD itself)."""
    try:
        import FreeCAD
    except ImportError:
        # FREECAD_LIB may name the folder; the others are where Linux distributions put it.
        folders = [
            os.environ.get("FREECAD_LIB", ""),
            "/usr/lib/freecad-python3/lib",
            "/usr/lib/freecad/lib",
            "/usr/lib64/freecad/lib",
            "/usr/local/lib",
        ]
        sys.path.extend(folder for folder in folders if os.path.isdir(folder))
        import FreeCAD
    # PartDesign and Sketcher objects only exist once their Python modules can be found.
    modules = os.path.join(FreeCAD.getResourceDir(), "Mod")
    if os.path.isdir(modules):
        known = set(sys.path)
        found = [modules] + [os.path.join(modules, name) for name in sorted(os.listdir(modules))]
        sys.path.extend(folder for folder in found if folder not in known)


_find_freecad()
import FreeCAD  # noqa: E402  (comes first: importing Part before it can crash)
import Part  # noqa: E402
import Sketcher  # noqa: E402
from FreeCAD import Placement, Rotation, Vector  # noqa: E402

X, Y, Z = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)
ORIGIN = Vector(0, 0, 0)


# --- Part objects -------------------------------------------------------------------------


def add(doc, kind, label, **properties):
    """Add an object of type `kind` whose name and label both follow `label`."""
    obj = doc.addObject(kind, label.title().replace(" ", ""))
    obj.Label = label
    for name, value in properties.items():
        setattr(obj, name, value)
    return obj


def hide(*objects):
    """Objects used up by another one stay in the tree but are not shown."""
    for obj in objects:
        obj.Visibility = False


def box(doc, label, size, at=(0, 0, 0)):
    """A Part::Box with one corner at `at`."""
    length, width, height = size
    return add(
        doc, "Part::Box", label, Length=length, Width=width, Height=height,
        Placement=Placement(Vector(*at), Rotation()),
    )  # fmt: skip


def cylinder(doc, label, diameter, height, at=(0, 0, 0), axis=Z):
    """A Part::Cylinder standing on `at` and rising along `axis`."""
    return add(
        doc, "Part::Cylinder", label, Radius=diameter / 2, Height=height,
        Placement=Placement(Vector(*at), Rotation(Z, axis)),
    )  # fmt: skip


def cut(doc, label, base, *tools):
    """Part::Cut of `base`; several tools are joined first."""
    tool = tools[0] if len(tools) == 1 else fuse(doc, label + " tools", *tools, refine=False)
    hide(base, tool)
    return add(doc, "Part::Cut", label, Base=base, Tool=tool, Refine=True)


def fuse(doc, label, *shapes, refine=True):
    """Part::MultiFuse; `refine` removes the seams between coplanar faces."""
    hide(*shapes)
    return add(doc, "Part::MultiFuse", label, Shapes=list(shapes), Refine=refine)


def extrusion(doc, label, profile, direction):
    """Part::Extrusion of a closed profile into a solid, along the whole of `direction`."""
    hide(profile)
    return add(
        doc, "Part::Extrusion", label, Base=profile, DirMode="Custom", Dir=direction,
        LengthFwd=direction.Length, Solid=True, FaceMakerClass="Part::FaceMakerBullseye",
    )  # fmt: skip


def polygon(doc, label, points):
    """A closed Part::Polygon through the given points."""
    return add(doc, "Part::Polygon", label, Nodes=[Vector(*p) for p in points], Close=True)


def edges_where(shape, wanted):
    """1-based numbers of the edges that `wanted` accepts.

    Edges are chosen by where they lie: their numbering differs between versions of the kernel.
    """
    numbers = [i for i, edge in enumerate(shape.Edges, 1) if wanted(edge)]
    if not numbers:
        raise RuntimeError("no edge matches the selection")
    return numbers


def fillet(doc, label, base, radius, wanted=lambda edge: True):
    """Part::Fillet of the edges that `wanted` accepts."""
    return _dress_up(doc, "Part::Fillet", label, base, radius, wanted)


def chamfer(doc, label, base, size, wanted=lambda edge: True):
    """Part::Chamfer of the edges that `wanted` accepts."""
    return _dress_up(doc, "Part::Chamfer", label, base, size, wanted)


def _dress_up(doc, kind, label, base, size, wanted):
    doc.recompute()
    hide(base)
    numbers = edges_where(base.Shape, wanted)
    return add(doc, kind, label, Base=base, Edges=[(i, size, size) for i in numbers])


def is_line(edge, direction):
    """Whether the edge is a straight line along +-direction."""
    if not isinstance(edge.Curve, (Part.Line, Part.LineSegment)):
        return False
    return abs(abs(edge.tangentAt(edge.FirstParameter).dot(direction)) - 1) < 1e-6


def is_circle(edge, diameter, height=None):
    """Whether the edge is a circle of this diameter about an axis along Z (at this z)."""
    circle = edge.Curve
    if not isinstance(circle, Part.Circle) or abs(circle.Radius - diameter / 2) > 1e-6:
        return False
    return height is None or abs(circle.Center.z - height) < 1e-6


def lies_at(edge, direction, position):
    """Whether the whole edge has the coordinate `position` along the unit vector `direction`."""
    points = [edge.valueAt(p) for p in (edge.FirstParameter, edge.LastParameter)]
    points.append(edge.CenterOfMass)
    return all(abs(point.dot(direction) - position) < 1e-6 for point in points)


# --- PartDesign objects -------------------------------------------------------------------


def body(doc, label):
    """An empty PartDesign::Body."""
    return add(doc, "PartDesign::Body", label)


def body_feature(owner, kind, label, **properties):
    """Add a feature to a Body; it becomes the tip."""
    feature = owner.newObject(kind, label.title().replace(" ", ""))
    feature.Label = label
    for name, value in properties.items():
        setattr(feature, name, value)
    return feature


def sketch_on(owner, plane, label, offset=0.0):
    """A sketch on one of the Body's origin planes ("XY", "XZ", "YZ"), moved along its normal."""
    sketch = body_feature(owner, "Sketcher::SketchObject", label)
    support = [f for f in owner.Origin.OriginFeatures if f.Role == plane + "_Plane"]
    # FreeCAD 1.0 gave this property a new name.
    name = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
    setattr(sketch, name, [(support[0], "")])
    sketch.MapMode = "FlatFace"
    sketch.AttachmentOffset = Placement(Vector(0, 0, offset), Rotation())
    hide(sketch)
    return sketch


def sketch_rectangle(sketch, width, height):
    """A fully constrained rectangle, centred on the sketch's origin."""
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = [Vector(x * width / 2, y * height / 2, 0) for x, y in corners]
    for start, end in zip(points, points[1:] + points[:1]):
        sketch.addGeometry(Part.LineSegment(start, end), False)
    sketch.addConstraint(
        [Sketcher.Constraint("Coincident", i, 2, (i + 1) % 4, 1) for i in range(4)]
        + [Sketcher.Constraint("Horizontal", i) for i in (0, 2)]
        + [Sketcher.Constraint("Vertical", i) for i in (1, 3)]
        # Opposite corners mirrored about the origin centre the rectangle.
        + [Sketcher.Constraint("Symmetric", 0, 1, 2, 1, -1, 1)]
        + [
            Sketcher.Constraint("DistanceX", 0, 1, 0, 2, width),
            Sketcher.Constraint("DistanceY", 1, 1, 1, 2, height),
        ]
    )


def sketch_circles(sketch, circles):
    """Fully constrained circles, each given as (x, y, diameter)."""
    for x, y, diameter in circles:
        i = sketch.addGeometry(Part.Circle(Vector(x, y, 0), Z, diameter / 2), False)
        sketch.addConstraint(Sketcher.Constraint("Radius", i, diameter / 2))
        for axis, value in (("DistanceX", x), ("DistanceY", y)):
            if value:
                sketch.addConstraint(Sketcher.Constraint(axis, -1, 1, i, 3, value))
            else:  # a distance of zero is not accepted: put the centre on the other axis
                other = -2 if axis == "DistanceX" else -1
                sketch.addConstraint(Sketcher.Constraint("PointOnObject", i, 3, other))


def pad(owner, label, sketch, length, reverse=False):
    """PartDesign::Pad along the sketch's normal."""
    return body_feature(
        owner, "PartDesign::Pad", label, Profile=sketch, Length=length, Reversed=reverse
    )


def through_pocket(owner, label, sketch):
    """PartDesign::Pocket against the sketch's normal, through everything."""
    return body_feature(owner, "PartDesign::Pocket", label, Profile=sketch, Type="ThroughAll")


def dress_up_body(owner, kind, label, size, wanted):
    """PartDesign::Fillet or ::Chamfer of the tip's edges that `wanted` accepts."""
    owner.Document.recompute()
    tip = owner.Tip
    names = ["Edge%d" % i for i in edges_where(tip.Shape, wanted)]
    size_name = "Radius" if kind == "PartDesign::Fillet" else "Size"
    return body_feature(owner, kind, label, Base=(tip, names), **{size_name: size})


def show_tip_only(owner):
    """Of all the features of a Body only the last one is shown."""
    hide(*(feature for feature in owner.Group if feature is not owner.Tip))


# --- Thin parts ---------------------------------------------------------------------------


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
        cylinder(doc, "Hole %d" % (2 * i + j + 1), 3.3, 4, (x, y, 0))
        for i, x in enumerate((12, width - 12))
        for j, y in enumerate((12, length - 12))
    ]
    return [cut(doc, "Heat sink", comb, *holes)]


def thin_walled_casting(doc):
    """A gearbox cover: 3 mm walls, a flange, a bearing boss with ribs, fillets."""
    length, width, height, wall = 140.0, 90.0, 48.0, 3.0
    corner, rim, flange = 14.0, 13.0, 5.0

    def vertical(edge):
        return is_line(edge, Z)

    # The hollow is an offset of the outside (equal walls at the corners, too).
    outside = box(doc, "Outside block", (length, width, height))
    outside = fillet(doc, "Outside corners", outside, corner, vertical)
    outside = fillet(doc, "Outside", outside, 7.0, lambda e: lies_at(e, Z, height))
    hollow = box(
        doc, "Hollow block", (length - 2 * wall, width - 2 * wall, height - wall), (wall, wall, 0)
    )
    hollow = fillet(doc, "Hollow corners", hollow, corner - wall, vertical)
    hollow = fillet(doc, "Hollow", hollow, 7.0 - wall, lambda e: lies_at(e, Z, height - wall))

    rim_block = box(
        doc, "Rim block", (length + 2 * rim, width + 2 * rim, flange), (-rim, -rim, 0)
    )
    rim_block = fillet(doc, "Rim", rim_block, corner + rim, vertical)
    middle_x, middle_y = length / 2, width / 2
    boss_height = height + 10
    boss = cylinder(doc, "Bearing boss", 44, 13, (middle_x, middle_y, boss_height - 13))
    # Four ribs brace the boss against the roof; they start within its wall.
    ribs = []
    for i, (dx, dy, reach) in enumerate(((1, 0, 54), (-1, 0, 54), (0, 1, 32), (0, -1, 32)), 1):
        rib = polygon(
            doc, "Rib profile %d" % i,
            [(17, 0, height - 1), (reach, 0, height - 1), (reach, 0, height), (21, 0, height + 7),
             (17, 0, height + 7)],
        )  # fmt: skip
        solid = extrusion(doc, "Rib %d" % i, rib, Vector(0, 3, 0))
        turn = Rotation(X, Vector(dx, dy, 0))
        start = Vector(middle_x, middle_y, 0) + turn.multVec(Vector(0, -1.5, 0))
        solid.Placement = Placement(start, turn)
        ribs.append(solid)
    walls = fuse(doc, "Cast body", outside, rim_block, boss, *ribs)

    def wall_meets_rim(edge):
        extent = edge.BoundBox
        inside_x = extent.XMin > -1 and extent.XMax < length + 1
        inside_y = extent.YMin > -1 and extent.YMax < width + 1
        return lies_at(edge, Z, flange) and inside_x and inside_y

    walls = fillet(doc, "Cast body with fillets", walls, 2.5, wall_meets_rim)

    bore = cylinder(doc, "Bearing bore", 32, 40, (middle_x, middle_y, boss_height - 40))
    bolts = [
        cylinder(doc, "Bolt hole %d" % (i + 1), 5.5, flange, (x, y, 0))
        for i, (x, y) in enumerate(
            [(-7, 12), (-7, 78), (147, 12), (147, 78), (40, -7), (100, -7), (40, 97), (100, 97)]
        )
    ]
    return [cut(doc, "Gearbox cover", walls, hollow, bore, *bolts)]


def shaft(doc):
    """A stepped shaft: every diameter is under a quarter of diag, so it is thin as a whole."""
    # (diameter, length) of the steps from the left to the right.
    steps = [(24, 34), (30, 46), (40, 14), (34, 58), (26, 38)]
    profile = add(doc, "Part::Feature", "Half section", Shape=_shaft_section(steps, 1.5, 1.6))
    hide(profile)
    return [
        add(
            doc, "Part::Revolution", "Shaft", Source=profile, Axis=Z, Base=ORIGIN,
            Angle=360.0, Solid=True,
        )
    ]  # fmt: skip


def _shaft_section(steps, chamfer_size, fillet_radius):
    """Half the section of a stepped shaft along Z, as a closed wire in the XZ plane.

    The ends are chamfered, and the inner corner of each shoulder is rounded.
    """
    edges = []
    pen = ORIGIN

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
    hollow = box(
        doc, "Hollow block", (length - 2 * wall, width - 2 * wall, height - wall), (wall,) * 3
    )
    hollow = fillet(doc, "Hollow corners", hollow, 10.0, vertical)
    hollow = fillet(doc, "Hollow", hollow, 4.0, lambda e: lies_at(e, Z, wall))
    dish = cut(doc, "Sharp dish", outside, hollow)
    return [fillet(doc, "Dish", dish, 1.0, lambda e: lies_at(e, Z, height))]


# --- Parts with thin features -------------------------------------------------------------


def ribbed_block(doc):
    """The paper's example: a rib of 6 mm, 4.6 % of diag, on a block."""
    block_ = box(doc, "Base", (100, 60, 40))
    rib = box(doc, "Rib", (100, 6, 20), (0, 27, 40))
    return [fuse(doc, "Ribbed block", block_, rib)]


def gear_thin_teeth(doc):
    """A wheel with pointed teeth; the flanks of a tooth meet at about 42 degrees.

    The wheel is wide enough (x = 0.34 from face to face) not to be thin as a whole.
    """
    teeth, tip, root, land, width = 20, 40.0, 31.0, 0.14, 40.0
    points = []
    for i in range(teeth):
        # A land between two teeth, then the tooth; `land` is its half share of the pitch.
        for turn, radius in ((-0.5 + land, root), (0.0, tip), (0.5 - land, root)):
            angle = 2 * math.pi * (i + turn) / teeth
            points.append((radius * math.cos(angle), radius * math.sin(angle), 0))
    profile = polygon(doc, "Tooth profile", points)
    blank = extrusion(doc, "Toothed blank", profile, Vector(0, 0, width))
    bore = cylinder(doc, "Bore", 20, width)
    key = box(doc, "Key slot", (12.3, 6, width), (0, -3, 0))
    return [cut(doc, "Pointed gear", blank, bore, key)]


def spur_gear_on_hub(doc):
    """An involute gear (module 4, 18 teeth, 20 degrees) with a hub on one side."""
    width, hub_length = 32.0, 18.0
    profile = add(doc, "Part::Feature", "Involute profile", Shape=_involute_profile(4.0, 18))
    teeth = extrusion(doc, "Toothed rim", profile, Vector(0, 0, width))
    hub = cylinder(doc, "Hub", 44, hub_length, (0, 0, width))
    gear = fuse(doc, "Gear and hub", teeth, hub)
    gear = fillet(doc, "Hub fillet", gear, 3.0, lambda e: is_circle(e, 44, width))
    gear = chamfer(doc, "Hub chamfer", gear, 1.5, lambda e: is_circle(e, 44, width + hub_length))
    bore = cylinder(doc, "Bore", 22, width + hub_length)
    key = box(doc, "Key slot", (13.8, 6, width + hub_length), (0, -3, 0))
    return [cut(doc, "Spur gear", gear, bore, key)]


def _involute_profile(module, teeth, pressure_angle=math.radians(20)):
    """The outline of a spur gear in the XY plane, as a face."""
    pitch_radius = module * teeth / 2
    base_radius = pitch_radius * math.cos(pressure_angle)
    tip_radius = pitch_radius + module
    root_radius = pitch_radius - 1.25 * module

    def involute(angle):
        return math.tan(angle) - angle

    def polar(radius, angle):
        return Vector(radius * math.cos(angle), radius * math.sin(angle), 0)

    # Half the tooth's angle at the base circle; at radius r it is less by the involute of the
    # pressure angle there. A circular arc through three points is within 0.06 mm of the curve,
    # and makes cylinders instead of B-spline surfaces.
    at_base = math.pi / (2 * teeth) + involute(pressure_angle)
    flank = []
    for radius in (base_radius, pitch_radius, tip_radius):
        flank.append((radius, at_base - involute(math.acos(base_radius / radius))))

    edges = []
    for tooth in range(teeth):
        middle = 2 * math.pi * tooth / teeth
        sides = []
        for sign in (-1, 1):
            curve = Part.Arc(*(polar(r, middle + sign * half) for r, half in flank))
            foot = Part.LineSegment(
                polar(root_radius, middle + sign * at_base),
                polar(base_radius, middle + sign * at_base),
            )
            sides += [foot.toShape(), curve.toShape()]
        tip_half = flank[-1][1]
        tip = Part.Arc(*(polar(tip_radius, middle + t * tip_half) for t in (-1, 0, 1)))
        gap_start, gap_end = middle + at_base, middle + 2 * math.pi / teeth - at_base
        gap = Part.Arc(
            *(polar(root_radius, a) for a in (gap_start, (gap_start + gap_end) / 2, gap_end))
        )
        edges += sides + [tip.toShape(), gap.toShape()]
    return Part.Face(Part.Wire(Part.__sortEdges__(edges)))


def worm_run_out(doc):
    """A worm whose thread runs out to nothing at both ends; flanks at 40 degrees.

    A sweep cannot change its section on the way, so the flanks and the crest are B-spline
    surfaces through the section at many places of the helix. The thread is a computed shape: one
    Boolean operation joins it to its core.
    """
    core_radius, crest_radius, length, lead, turns = 15.0, 21.0, 72.0, 14.0, 3.5
    sunk = core_radius - 1.5  # the thread's foot, inside the core so that the two overlap
    half_crest = 1.7
    half_foot = half_crest + (crest_radius - sunk) * math.tan(math.radians(20))
    run_out = 0.8  # turns over which the section shrinks to where it disappears in the core
    smallest = 0.12  # of the full section, there; less than (core - sunk) / (crest - sunk) = 0.2
    start = (length - lead * turns) / 2
    rows_per_turn = 12

    def section(turn):
        """The four corners of the section: (foot, crest) of the lower and the upper flank."""
        grown = min(1.0, turn / run_out, (turns - turn) / run_out)
        # The sine is level where run-out begins, so that there is no kink.
        scale = smallest + (1 - smallest) * math.sin(grown * math.pi / 2)
        radius = sunk + (crest_radius - sunk) * scale
        angle, height = 2 * math.pi * turn, start + lead * turn

        def point(r, dz):
            return Vector(r * math.cos(angle), r * math.sin(angle), height + dz)

        return [
            point(sunk, -half_foot * scale),
            point(radius, -half_crest * scale),
            point(radius, half_crest * scale),
            point(sunk, half_foot * scale),
        ]

    # One face per side over the whole length: joining several end to end is fragile.
    count = math.ceil(turns * rows_per_turn)
    rows = [section(turns * i / count) for i in range(count + 1)]
    faces = []
    for a, b in ((0, 1), (1, 2), (2, 3), (3, 0)):
        faces.append(_ruled_face([row[a] for row in rows], [row[b] for row in rows]))
    for turn in (0.0, turns):
        corners = section(turn)
        faces.append(Part.Face(Part.makePolygon(corners + corners[:1])))
    shell = Part.makeShell(faces)
    shell.sewShape()
    thread = Part.makeSolid(Part.Shell(shell.Faces))
    if thread.Volume < 0:
        thread.reverse()
    core = Part.makeCylinder(core_radius, length)
    rims = [edge for edge in core.Edges if isinstance(edge.Curve, Part.Circle)]
    core = core.makeChamfer(2.0, rims)
    worm = core.fuse(thread)
    return [add(doc, "Part::Feature", "Worm", Shape=worm)]


def _ruled_face(one, other):
    """The face between two curves, each interpolating a row of points."""
    curves = []
    for points in (one, other):
        curve = Part.BSplineCurve()
        # The same parameters on both curves, so that equal parameters lie on one section.
        curve.interpolate(Points=points, Parameters=[float(i) for i in range(len(points))])
        curves.append(curve)
    # Equal parameters give equal knots: the two rows of poles make a surface, straight across.
    surface = Part.BSplineSurface()
    surface.buildFromPolesMultsKnots(
        [curve.getPoles() for curve in curves],
        [2, 2], curves[0].getMultiplicities(),
        [0.0, 1.0], curves[0].getKnots(),
        False, False, 1, curves[0].Degree,
    )  # fmt: skip
    return surface.toShape()


def flange(doc):
    """A solid pivot flange: a 16 mm disc (x = 0.09) on a 60 mm stub (x = 0.33)."""
    disc, thickness, stub, height, circle, hole = 120.0, 16.0, 60.0, 70.0, 86.0, 9.0
    part = body(doc, "Pivot flange")
    outline = sketch_on(part, "XY", "Disc outline")
    sketch_circles(outline, [(0, 0, disc)])
    pad(part, "Disc", outline, thickness)
    stub_outline = sketch_on(part, "XY", "Stub outline")
    sketch_circles(stub_outline, [(0, 0, stub)])
    pad(part, "Stub", stub_outline, height)
    # The holes stay 12.5 mm (7 % of diag) from the rim: nothing here is thinner than 5 %.
    hole_sketch = sketch_on(part, "XY", "Bolt hole", offset=thickness)
    sketch_circles(hole_sketch, [(circle / 2, 0, hole)])
    bolt_hole = through_pocket(part, "First bolt hole", hole_sketch)
    pattern = body_feature(
        part, "PartDesign::PolarPattern", "Bolt circle", Originals=[bolt_hole],
        Axis=(hole_sketch, ["N_Axis"]), Angle=360.0, Occurrences=6,
    )  # fmt: skip
    # The pattern's axis is the sketch's normal, which passes through the disc's center.
    part.Tip = pattern
    dress_up_body(
        part, "PartDesign::Fillet", "Root fillet", 5.0, lambda e: is_circle(e, stub, thickness)
    )
    dress_up_body(
        part, "PartDesign::Chamfer", "Chamfers", 1.0,
        lambda e: is_circle(e, stub, height) or is_circle(e, disc),
    )  # fmt: skip
    show_tip_only(part)
    return [part]


def wedge(doc):
    """A right-angled wedge of 30 degrees."""
    length, width = 100.0, 60.0
    # Part::Wedge narrows along Y: here from the base (all of X) to the edge at X = 0.
    return [
        add(
            doc, "Part::Wedge", "Wedge", Xmin=0, Xmax=length, X2min=0, X2max=0,
            Ymin=0, Ymax=length * math.tan(math.radians(30)),
            Zmin=0, Zmax=width, Z2min=0, Z2max=width,
            Placement=Placement(Vector(0, width, 0), Rotation(X, 90)),
        )
    ]  # fmt: skip


# --- Normal parts -------------------------------------------------------------------------


def block(doc):
    """The block of the ribbed block, without its rib, all edges rounded."""
    return [fillet(doc, "Block", box(doc, "Sharp block", (100, 60, 40)), 5.0)]


def vee_block(doc):
    """A vee block: 100 x 80 x 70, and nowhere thinner than 30 % of diag between parallel faces."""
    width, length, height, half_vee, slot = 100.0, 80.0, 70.0, 20.0, 4.0
    floor = height - half_vee - 3.0  # the relief slot's bottom
    middle = width / 2
    meet = height - half_vee + slot / 2  # where the vee's flanks meet the slot's walls
    profile = polygon(
        doc, "End view",
        [
            (0, 0, 0), (width, 0, 0), (width, 0, height), (middle + half_vee, 0, height),
            (middle + slot / 2, 0, meet), (middle + slot / 2, 0, floor),
            (middle - slot / 2, 0, floor), (middle - slot / 2, 0, meet),
            (middle - half_vee, 0, height), (0, 0, height),
        ],
    )  # fmt: skip
    sharp = extrusion(doc, "Sharp vee block", profile, Vector(0, length, 0))
    return [
        chamfer(
            doc, "Vee block", sharp, 2.0,
            lambda e: is_line(e, Y) and abs(abs(e.CenterOfMass.x - middle) - middle) < 1e-6,
        )
    ]  # fmt: skip


def tapered_plug(doc):
    """A plug that narrows from 60 to 54 mm over 60 mm."""
    cone = add(doc, "Part::Cone", "Cone", Radius1=30.0, Radius2=27.0, Height=60.0)
    rounded = fillet(doc, "Rounded end", cone, 8.0, lambda e: is_circle(e, 54, 60))
    return [chamfer(doc, "Plug", rounded, 3.0, lambda e: is_circle(e, 60, 0))]


# --- An assembly --------------------------------------------------------------------------


def assembly_of_three(doc):
    """A base, a cover and two dowels: four solids, of which the second dowel is a link.

    Each solid falls in another category: the base has thin features (its holes leave walls
    under 29 % of diag), the cover is thin, the short dowel is normal. Only the .FCStd file knows
    of the link: Part's STEP export writes four separate solids.
    """
    length, width, base_height, cover = 100.0, 70.0, 45.0, 5.0
    pin, pin_length, positions = 12.0, 30.0, ((25.0, 35.0), (75.0, 35.0))
    depth = pin_length - cover  # the dowels end flush with the cover's top

    block_ = box(doc, "Base blank", (length, width, base_height))
    seats = [
        cylinder(doc, "Seat %d" % i, pin, depth, (x, y, base_height - depth))
        for i, (x, y) in enumerate(positions, 1)
    ]
    base = cut(doc, "Base block", block_, *seats)

    sheet = box(doc, "Cover blank", (length, width, cover))
    sheet = fillet(doc, "Rounded cover blank", sheet, 5.0, lambda e: is_line(e, Z))
    holes = [
        cylinder(doc, "Cover hole %d" % i, pin, cover, (x, y, 0))
        for i, (x, y) in enumerate(positions, 1)
    ]
    lid = cut(doc, "Cover plate", sheet, *holes)
    lid.Placement = Placement(Vector(0, 0, base_height), Rotation())

    rod = cylinder(doc, "Dowel rod", pin, pin_length)
    dowel = chamfer(doc, "Dowel pin", rod, 1.0, lambda e: isinstance(e.Curve, Part.Circle))
    places = [Placement(Vector(x, y, base_height - depth), Rotation()) for x, y in positions]
    dowel.Placement = places[0]
    add(doc, "App::Link", "Dowel pin 2", LinkedObject=dowel, Placement=places[1])

    # addObject() would bring an object's inputs along, in an order that changes from run to run.
    members = list(doc.Objects)
    assembly = add(doc, "App::Part", "Dowelled block")
    assembly.Group = members
    # A container that is moved, for a reader that forgets the placement to be found out.
    assembly.Placement = Placement(Vector(-length / 2, -width / 2, 0), Rotation())
    return [assembly]


# --- The table ----------------------------------------------------------------------------


@dataclass(frozen=True)
class Sample:
    """A part to make, and what the `paper` profile should say about it."""

    build: object  # function(document) -> the document's results, as a list of objects
    shows: str
    category: str
    criteria: list
    solids: int = 1
    # An assembly is classified solid by solid: (label, category, criteria, instances) each.
    records: list = field(default_factory=list)

    @property
    def name(self):
        return self.build.__name__


SAMPLES = [
    Sample(plate, "A flat plate fills its low, wide bounding box.", "thin", [1, 4, 5]),
    Sample(
        bent_sheet_bracket,
        "Bent sheet metal fills little of its bounding box.",
        "thin", [3, 4],
    ),
    Sample(tube, "A thin wall need not be flat: a tube, 2 mm thick all round.", "thin", [3, 4]),
    Sample(
        ribbed_block,
        "A solid block with one thin rib, shown where it is.",
        "thin_features", [5],
    ),
    Sample(
        gear_thin_teeth,
        "Pointed teeth have no parallel faces: their flanks meet at a sharp angle.",
        "thin_features", [6, 7],
    ),
    Sample(
        spur_gear_on_hub,
        "Involute teeth narrow towards their tips, on a solid gear body.",
        "thin_features", [7],
    ),
    Sample(
        heat_sink,
        "Most of the surface belongs to thin fins, so the part is thin as a whole.",
        "thin", [4, 5],
    ),
    Sample(
        worm_run_out,
        "A thread that runs out to nothing leaves slivers that are hard to mesh.",
        "thin_features", [7],
    ),
    Sample(
        thin_walled_casting,
        "A cast cover: thin walls all over, with ribs, a boss and fillets.",
        "thin", [3, 4, 7],
    ),
    Sample(
        shaft,
        "A slender shaft counts as thin: its diameters are small against its length.",
        "thin", [4],
    ),
    Sample(block, "A compact block with rounded edges.", "normal", []),
    Sample(
        flange,
        "A thin disc beside a thick stub: neither is below 5 % of the diagonal.",
        "thin_features", [6],
    ),
    Sample(
        assembly_of_three,
        "Each solid of an assembly is classified on its own; linked copies count once.",
        "", [], solids=4,
        records=[
            ("Base block", "thin_features", [6], 1),
            ("Cover plate", "thin", [1, 4, 5], 1),
            ("Dowel pin", "normal", [], 2),
        ],
    ),
    Sample(wedge, "Two faces that meet at 30 degrees make a thin edge.", "thin_features", [7]),
    Sample(
        nearly_square_dish,
        "Low and nearly square, but half empty: a dish.",
        "thin", [2, 4, 5, 7],
    ),
    Sample(vee_block, "A cut-out alone makes nothing thin: a vee block.", "normal", []),
    Sample(tapered_plug, "A compact, slightly tapered plug.", "normal", []),
]  # fmt: skip


# --- Checking and writing -----------------------------------------------------------------


class BadSample(RuntimeError):
    """A part that did not come out as intended."""


def shape_of(results):
    """The results' shape, placements of containers and links included."""
    shapes = [Part.getShape(obj) for obj in results]
    shape = shapes[0] if len(shapes) == 1 else Part.makeCompound(shapes)
    return shape.Solids[0] if len(shape.Solids) == 1 else shape


def check(what, shape, solids, volume=None):
    """Raise BadSample unless `shape` is valid and has so many solids (and this volume)."""
    if shape.isNull() or not shape.isValid():
        raise BadSample("%s: the shape is not valid" % what)
    if len(shape.Solids) != solids:
        raise BadSample("%s: %d solids instead of %d" % (what, len(shape.Solids), solids))
    if any(solid.Volume <= 0 or not solid.isClosed() for solid in shape.Solids):
        raise BadSample("%s: a solid is open or inside out" % what)
    if len(shape.Faces) != sum(len(solid.Faces) for solid in shape.Solids):
        raise BadSample("%s: there are faces outside of the solids" % what)
    if volume is not None and abs(shape.Volume - volume) > 1e-4 * volume:
        raise BadSample("%s: volume %g instead of %g" % (what, shape.Volume, volume))


def make(sample, folder):
    """Build one sample, check it, save both files, and check what was saved."""
    doc = FreeCAD.newDocument(sample.name)
    results = sample.build(doc)
    doc.recompute()
    broken = [obj.Label for obj in doc.Objects if "Invalid" in obj.State or not obj.isValid()]
    if broken:
        raise BadSample("%s: cannot compute %s" % (sample.name, ", ".join(broken)))
    sketches = [obj for obj in doc.Objects if obj.isDerivedFrom("Sketcher::SketchObject")]
    loose = [obj.Label for obj in sketches if obj.solve() != 0 or not obj.FullyConstrained]
    if loose:
        raise BadSample("%s: not fully constrained: %s" % (sample.name, ", ".join(loose)))
    shape = shape_of(results)
    check(sample.name, shape, sample.solids)
    volume = shape.Volume

    step = os.path.join(folder, sample.name + ".step")
    # Without the edges' curves in the faces' parameters, which readers compute themselves: less
    # than half the size.
    Part.setStaticValue("write.surfacecurve.mode", 0)
    shape.exportStep(step)
    tidy_step(step, sample.name)
    check(step, Part.read(step), sample.solids, volume)

    fcstd = os.path.join(folder, sample.name + ".FCStd")
    doc.License = "The license of the ThinPart workbench"
    doc.LicenseURL = ""
    names = [obj.Name for obj in results]
    view = gui_document(doc, shape.BoundBox)
    # Saved elsewhere first: FreeCAD would leave a backup beside a file that it overwrites.
    with tempfile.TemporaryDirectory() as scratch:
        saved = os.path.join(scratch, sample.name + ".FCStd")
        doc.saveAs(saved)
        FreeCAD.closeDocument(doc.Name)
        finish_fcstd(saved, fcstd, sample.name, view)
    doc = FreeCAD.openDocument(fcstd)
    check(fcstd, shape_of([doc.getObject(name) for name in names]), sample.solids, volume)
    FreeCAD.closeDocument(doc.Name)
    return shape, os.path.getsize(fcstd), os.path.getsize(step)


def tidy_step(path, name):
    """Take the date out of a STEP file, and name its products after the part.

    The writer calls them "Open CASCADE STEP translator 7.6 1", with a number that depends on how
    many files were written before.
    """
    with open(path, encoding="ascii") as file:
        text = file.read()
    text = re.sub(r"'\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d'", "'2000-01-01T00:00:00'", text, count=1)
    default = r"'Open CASCADE STEP translator [\d.]+ \d+((?:\.\d+)*)'"
    text = re.sub(default, lambda m: "'%s%s'" % (name, m.group(1).replace(".", " ")), text)
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write(text)


def gui_document(doc, bounds):
    """The part of a document that a FreeCAD without windows does not write, as XML text.

    Without it everything is hidden when the document is opened. It says which objects are shown,
    and lets the view start with the whole part, seen from the isometric direction.
    """
    shown = [obj for obj in doc.Objects if not obj.TypeId.startswith(("App::Origin", "App::Line"))]
    shown = [obj for obj in shown if obj.TypeId not in ("App::Plane", "App::Point")]
    size = bounds.DiagonalLength
    eye = bounds.Center + Vector(1, -1, 1).normalize() * (size / 2)
    camera = [
        "OrthographicCamera {",
        "  viewportMapping ADJUST_CAMERA",
        "  position %.6g %.6g %.6g" % tuple(eye),
        "  orientation 0.74290609 0.30772209 0.59447283 1.2171158",
        "  nearDistance 0",
        "  farDistance %.6g" % size,
        "  aspectRatio 1",
        "  focalDistance %.6g" % (size / 2),
        "  height %.6g" % size,
        "}",
    ]
    lines = [
        "<?xml version='1.0' encoding='utf-8'?>",
        '<Document SchemaVersion="1">',
        '  <ViewProviderData Count="%d">' % len(shown),
    ]
    for obj in shown:
        lines += [
            '    <ViewProvider name="%s" expanded="0">' % obj.Name,
            '      <Properties Count="1" TransientCount="0">',
            '        <Property name="Visibility" type="App::PropertyBool">',
            '          <Bool value="%s"/>' % ("true" if obj.Visibility else "false"),
            "        </Property>",
            "      </Properties>",
            "    </ViewProvider>",
        ]
    lines += [
        "  </ViewProviderData>",
        '  <Camera settings="%s"/>' % "&#10;".join(camera),
        "</Document>",
    ]
    return "\n".join(lines) + "\n"


def finish_fcstd(saved, path, name, view):
    """Write the document `saved` to `path`, completed and made reproducible.

    Adds the `view` from gui_document(), replaces dates, random identifiers and the objects' random
    numbers by fixed ones, and compresses as far as possible.
    """
    date = r'"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d[^"]*"'
    numbers = itertools.count(1)

    def identifier(_match):
        text = "ThinPart sample %s %d" % (name, next(numbers))
        return '<Uuid value="%s"' % uuid.uuid5(uuid.NAMESPACE_OID, text)

    with zipfile.ZipFile(saved) as archive:
        members = {info.filename: archive.read(info) for info in archive.infolist()}
    text = members["Document.xml"].decode("utf-8")
    text = re.sub(date, '"2000-01-01T00:00:00Z"', text)
    text = re.sub(r'<Uuid value="[^"]*"', identifier, text)
    if "ElementMap" not in text:  # FreeCAD 1.0 refers to the objects' numbers in these maps
        text = re.sub(
            r'(<Object type="[^"]*" name="[^"]*" id=)"\d+"',
            lambda match: '%s"%d"' % (match.group(1), next(numbers)),
            text,
        )
    members["Document.xml"] = text.encode("utf-8")
    members["GuiDocument.xml"] = view.encode("utf-8")

    with zipfile.ZipFile(path, "w") as archive:
        for filename, content in members.items():
            info = zipfile.ZipInfo(filename)  # dated 1980, for want of a date
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, content, compresslevel=9)


def expectation(sample):
    """The sample's entry in samples.json."""
    entry = {
        "name": sample.name,
        "shows": sample.shows,
        "category": sample.category or None,
        "criteria": sample.criteria,
    }
    if sample.records:
        keys = ("label", "category", "criteria", "instances")
        entry["solids"] = [dict(zip(keys, record)) for record in sample.records]
    return entry


def main(arguments=None):
    """Make the samples asked for (all by default); return 0, or raise."""
    parser = argparse.ArgumentParser(description="Make the sample parts bundled with ThinPart.")
    here = os.path.dirname(os.path.abspath(__file__))
    parser.add_argument("--out", default=here, metavar="DIR", help="default: beside this script")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="default: all the samples")
    options = parser.parse_args(arguments)
    unknown = set(options.only or []) - {sample.name for sample in SAMPLES}
    if unknown:
        parser.error("no such sample: " + ", ".join(sorted(unknown)))
    os.makedirs(options.out, exist_ok=True)

    for sample in SAMPLES:
        if options.only and sample.name not in options.only:
            continue
        shape, fcstd_size, step_size = make(sample, options.out)
        print(
            "%-20s %3d faces  %9.0f mm3  FCStd %4d kB  STEP %4d kB"
            % (sample.name, len(shape.Faces), shape.Volume, fcstd_size / 1000, step_size / 1000)
        )
    if not options.only:
        listing = json.dumps([expectation(sample) for sample in SAMPLES], indent=2)
        with open(os.path.join(options.out, "samples.json"), "w", encoding="utf-8") as file:
            file.write(listing + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
