# SPDX-License-Identifier: LGPL-2.1-or-later
"""The solids that are measured: kinds of part that make different things hard, some in several sizes."""

import math

TURN_AXIS = (0.55, 0.77, -0.33)
TURN_DEGREES = 53.1301
"""The irregular rotation: no side of a part comes near an axis or a diagonal of space."""


def make_solid(name, *size):
    """Make one of `FAMILIES`, axis-aligned.

    Parameters
    ----------
    name : str
    *size : int
        How many teeth, rows of holes, fins or rows of domes; nothing for the usual number.

    Returns
    -------
    Part.Shape
        In mm. FreeCAD must have been imported before.

    Raises
    ------
    ValueError
        where FreeCAD built something that is no valid solid.
    """
    shape = FAMILIES[name](*size)
    if not shape.isValid() or len(shape.Solids) != 1:
        raise ValueError(f"This FreeCAD cannot build the {name.replace('_', ' ')} of the benchmark.")
    return shape.Solids[0]


def rotated(shape):
    """A copy of a shape, turned about a skew axis by an irregular angle."""
    import FreeCAD

    copy = shape.copy(True, False)
    turn = FreeCAD.Rotation(FreeCAD.Vector(*TURN_AXIS), TURN_DEGREES)
    copy.Placement = FreeCAD.Placement(FreeCAD.Vector(), turn)
    return copy


def thin_walled_casting():
    """An open housing of 120 x 80 x 40 mm, wall 3 mm: ribs, bosses, drilled holes and fillets."""
    import Part
    from FreeCAD import Vector

    block = Part.makeBox(120, 80, 40)
    block = block.makeFillet(8, [edge for edge in block.Edges if not _at_height(edge, 40)])
    top = [face for face in block.Faces if _at_height(face, 40)]
    casting = block.makeThickness(top, -3.0, 1e-3)
    for x in (30, 60, 90):
        casting = casting.fuse(Part.makeBox(2.5, 76, 22, Vector(x - 1.25, 2, 2)))
    casting = casting.fuse(Part.makeBox(116, 2.5, 22, Vector(2, 38.75, 2)))
    feet = [(x, y) for x in (15, 105) for y in (15, 65)]
    for x, y in feet:
        casting = casting.fuse(Part.makeCylinder(6, 30, Vector(x, y, 1.5)))
    for x, y in feet:
        casting = casting.cut(Part.makeCylinder(3, 25, Vector(x, y, 10)))
    for x in range(20, 116, 16):
        casting = casting.cut(Part.makeCylinder(4, 6, Vector(x, -1, 18), Vector(0, 1, 0)))
    casting = casting.cut(Part.makeCone(6, 3, 4, Vector(45, 25, -0.5))).removeSplitter()
    return casting.makeFillet(1.5, [edge for edge in casting.Edges if _where_ribs_cross(edge)])


def gear(teeth=60):
    """A spur gear, diameter 108 mm, spline flanks, a bore and a thin web."""
    import Part
    from FreeCAD import Vector

    pitch = 2.0 * math.pi / teeth
    edges = []
    for tooth in range(teeth):
        def at(radius, share, middle=tooth * pitch):
            angle = middle + share * pitch
            return Vector(radius * math.cos(angle), radius * math.sin(angle), 0)

        edges.append(_spline(at(46, -0.30), at(50, -0.22), at(54, -0.10)))
        edges.append(Part.Arc(at(54, -0.10), at(54, 0.0), at(54, 0.10)).toShape())
        edges.append(_spline(at(54, 0.10), at(50, 0.22), at(46, 0.30)))
        edges.append(Part.Arc(at(46, 0.30), at(46, 0.5), at(46, 0.70)).toShape())
    blank = Part.Face(Part.Wire(edges)).extrude(Vector(0, 0, 20))
    blank = blank.cut(Part.makeCylinder(10, 30, Vector(0, 0, -1)))
    for z in (-1, 13):
        pocket = Part.makeCylinder(41, 8, Vector(0, 0, z))
        blank = blank.cut(pocket.cut(Part.makeCylinder(15, 8, Vector(0, 0, z))))
    return blank


def spherical_shell():
    """A closed hollow sphere, radii 20 and 18 mm: no two facets are parallel."""
    import Part

    return Part.makeSphere(20).cut(Part.makeSphere(18))


def perforated_plate(rows=20):
    """A square plate, 4 mm thick, with rows of holes of 7 mm: two flat faces full of slender facets.

    With 20 rows it has 210 mm and 400 holes.
    """
    import Part
    from FreeCAD import Vector

    places = [10 + 10 * step for step in range(rows)]
    side = 10 * (rows + 1)
    holes = [Part.makeCylinder(3.5, 6, Vector(x, y, -1)) for x in places for y in places]
    return Part.makeBox(side, side, 4).cut(Part.makeCompound(holes))


def heat_sink(fins=200):
    """A heat sink, 36 x 60 mm: fins of 1.5 mm every 4 mm with round tips, drawn as one profile."""
    import Part
    from FreeCAD import Vector

    pitch, thickness, base, tip = 4.0, 1.5, 5.0, 35.0
    last = Vector(0, base, 0)
    edges = []
    for fin in range(fins):
        left = fin * pitch + 1.0
        right = left + thickness
        root, rise, fall, end = (Vector(left, base, 0), Vector(left, tip, 0),
                                 Vector(right, tip, 0), Vector(right, base, 0))
        crown = Vector(0.5 * (left + right), tip + 0.5 * thickness, 0)
        edges += [Part.makeLine(last, root), Part.makeLine(root, rise),
                  Part.Arc(rise, crown, fall).toShape(), Part.makeLine(fall, end)]
        last = end
    corner = Vector(fins * pitch, base, 0)
    around = [last, corner, Vector(corner.x, 0, 0), Vector(0, 0, 0), Vector(0, base, 0)]
    edges += [Part.makeLine(*ends) for ends in zip(around, around[1:])]
    return Part.Face(Part.Wire(edges)).extrude(Vector(0, 0, 60))


def studded_plate(rows=5):
    """A square plate, 8 mm thick, with rows of domes of 8 mm: doubly curved, so that few faces give many triangles."""
    import Part
    from FreeCAD import Vector

    pitch = 10
    dome = Part.makeSphere(4, Vector(), Vector(0, 0, 1), 0, 90, 360)
    domes = []
    for x in range(rows):
        for y in range(rows):
            domes.append(dome.copy())
            domes[-1].translate(Vector((x + 0.5) * pitch, (y + 0.5) * pitch, 8))
    return Part.makeBox(rows * pitch, rows * pitch, 8).multiFuse(domes)


SOLIDS = {
    "casting": thin_walled_casting,
    "gear": gear,
    "shell": spherical_shell,
    "plate": perforated_plate,
    "heat_sink": heat_sink,
}
"""Those of which meshes of any size are made."""

FAMILIES = {**SOLIDS, "studs": studded_plate}
"""All of them."""


def _spline(*points):
    import Part

    curve = Part.BSplineCurve()
    curve.interpolate(list(points))
    return curve.toShape()


def _at_height(shape, z):
    box = shape.BoundBox
    return abs(box.ZMin - z) < 1e-6 and abs(box.ZMax - z) < 1e-6


def _where_ribs_cross(edge):
    """Whether it is one of the upright edges in the corners between the ribs."""
    box = edge.BoundBox
    upright = max(box.XLength, box.YLength) < 1e-6 and box.ZLength > 15
    return upright and 25 < box.XMin < 95 and 30 < box.YMin < 50
