# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are not thin as a whole but somewhere."""

import math

import Part
from FreeCAD import Placement, Rotation, Vector

from .body_objects import (
    body,
    body_feature,
    dress_up_body,
    pad,
    show_tip_only,
    sketch_circles,
    sketch_on,
    through_pocket,
)
from .edge_choice import is_circle
from .part_objects import X, Z, add, box, chamfer, cut, cylinder, extrusion, fillet, fuse, polygon

PRESSURE_ANGLE = math.radians(20)
"""Of the spur gear's teeth."""

FLANK = math.radians(20)
"""Of the threads of worms: angle of a flank to the plane across the axis."""


def ribbed_block(doc):
    """A rib of 6 mm, 4.6 % of diag, on a block."""
    base = box(doc, "Base", (100, 60, 40))
    rib = box(doc, "Rib", (100, 6, 20), (0, 27, 40))
    return [fuse(doc, "Ribbed block", base, rib)]


def cuboid_with_rib(doc):
    """The paper's figure 6.a: it fills 0.74 of its box, and has three distances inside: 8, 42 and 60 mm."""
    side, height, rib = 60.0, 42.0, 8.0
    base = box(doc, "Cuboid", (side, side, height))
    top = box(doc, "Rib", (side, rib, side - height), (0, (side - rib) / 2, height))
    return [fuse(doc, "Cuboid with a rib", base, top)]


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


def _involute_profile(module, teeth, pressure_angle=PRESSURE_ANGLE):
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
        gap = Part.Arc(*(polar(root_radius, a) for a in (gap_start, (gap_start + gap_end) / 2, gap_end)))
        edges += sides + [tip.toShape(), gap.toShape()]
    return Part.Face(Part.Wire(Part.__sortEdges__(edges)))


def worm_run_out(doc):
    """A worm whose thread runs out to nothing at both ends; flanks at 40 degrees."""
    core_radius, crest_radius, length, lead, turns = 15.0, 21.0, 72.0, 14.0, 3.5
    sunk = core_radius - 1.5  # the thread's foot, inside the core so that the two overlap
    half_crest = 1.7
    half_foot = half_crest + (crest_radius - sunk) * math.tan(FLANK)
    run_out = 0.8  # turns over which the section shrinks to where it disappears in the core
    smallest = 0.12  # of the full section, there; less than (core - sunk) / (crest - sunk) = 0.2

    def section(turn):
        grown = min(1.0, turn / run_out, (turns - turn) / run_out)
        # The sine is level where run-out begins, so that there is no kink.
        scale = smallest + (1 - smallest) * math.sin(grown * math.pi / 2)
        return sunk, half_foot * scale, sunk + (crest_radius - sunk) * scale, half_crest * scale

    thread = _helical_bar(section, (length - lead * turns) / 2, lead, turns)
    core = Part.makeCylinder(core_radius, length)
    core = core.makeChamfer(2.0, _rims(core))
    worm = core.fuse(thread)
    return [add(doc, "Part::Feature", "Worm", Shape=worm)]


def endless_screw(doc):
    """The paper's figure 1: a thread that the ends, and the chamfers around them, cut off to blades."""
    root_radius, crest_radius, length, lead, chamfer_size = 15.0, 21.0, 52.0, 14.0, 5.0
    sunk, half_crest = root_radius - 1.5, 1.5
    half_foot = half_crest + (crest_radius - sunk) * math.tan(FLANK)
    turns = length / lead + 1.5  # what is beyond the ends is cut off
    thread = _helical_bar(lambda turn: (sunk, half_foot, crest_radius, half_crest), -0.75 * lead, lead, turns)
    screw = Part.makeCylinder(root_radius, 3 * length, Vector(0, 0, -length)).fuse(thread)
    flat, around = crest_radius - chamfer_size, crest_radius + 10.0
    # One tool for each end: everything beyond its plane and its cone.
    for end, outwards in ((0.0, -1), (length, 1)):
        cone, beyond = end - outwards * (around - flat), end + outwards * length
        section = [Vector(0, 0, end), Vector(flat, 0, end), Vector(around, 0, cone), Vector(around, 0, beyond),
                   Vector(0, 0, beyond)]
        face = Part.Face(Part.makePolygon(section + section[:1]))
        screw = screw.cut(face.revolve(Vector(), Z, 360))
    return [add(doc, "Part::Feature", "Endless screw", Shape=screw)]


def _rims(cylinder_shape):
    return [edge for edge in cylinder_shape.Edges if isinstance(edge.Curve, Part.Circle)]


def _helical_bar(section, start, lead, turns):
    """A solid whose section moves along a helix about Z.

    A sweep cannot change its section on the way, so its sides are B-spline surfaces through the section at many
    places of the helix. It is a computed shape: one Boolean operation joins it to a core, or cuts it out of one.

    Parameters
    ----------
    section : callable
        After so many turns: inner radius, half the width there, outer radius, half the width there, mm.
    start, lead : float, mm
        Height of its middle at first, and what it rises by in one turn.
    turns : float
    """
    rows_per_turn = 12

    def corners_at(turn):
        """The four corners of the section: (inner, outer) of the lower and the upper flank."""
        inner, half_inner, outer, half_outer = section(turn)
        angle, height = 2 * math.pi * turn, start + lead * turn

        def point(r, dz):
            return Vector(r * math.cos(angle), r * math.sin(angle), height + dz)

        return [point(inner, -half_inner), point(outer, -half_outer), point(outer, half_outer), point(inner, half_inner)]

    # One face per side over the whole length: joining several end to end is fragile.
    count = math.ceil(turns * rows_per_turn)
    rows = [corners_at(turns * i / count) for i in range(count + 1)]
    faces = []
    for a, b in ((0, 1), (1, 2), (2, 3), (3, 0)):
        faces.append(_ruled_face([row[a] for row in rows], [row[b] for row in rows]))
    for turn in (0.0, turns):
        corners = corners_at(turn)
        faces.append(Part.Face(Part.makePolygon(corners + corners[:1])))
    shell = Part.makeShell(faces)
    shell.sewShape()
    bar = Part.makeSolid(Part.Shell(shell.Faces))
    if bar.Volume < 0:
        bar.reverse()
    return bar


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
    )
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
    )
    # The pattern's axis is the sketch's normal, which passes through the disc's center.
    part.Tip = pattern
    dress_up_body(part, "PartDesign::Fillet", "Root fillet", 5.0, lambda e: is_circle(e, stub, thickness))
    dress_up_body(part, "PartDesign::Chamfer", "Chamfers", 1.0,
                  lambda e: is_circle(e, stub, height) or is_circle(e, disc))
    show_tip_only(part)
    return [part]


def wedge(doc):
    """A right-angled wedge of 30 degrees."""
    length, width = 100.0, 60.0
    # Part::Wedge narrows along Y: here from the base (all of X) to the edge at X = 0.
    return [add(
        doc, "Part::Wedge", "Wedge", Xmin=0, Xmax=length, X2min=0, X2max=0,
        Ymin=0, Ymax=length * math.tan(math.radians(30)),
        Zmin=0, Zmax=width, Z2min=0, Z2max=width,
        Placement=Placement(Vector(0, width, 0), Rotation(X, 90)),
    )]
