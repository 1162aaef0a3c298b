# SPDX-License-Identifier: LGPL-2.1-or-later
"""An assembly of which each solid falls in another category."""

import Part
from FreeCAD import Placement, Rotation, Vector

from .edge_choice import is_line
from .part_objects import Z, add, box, chamfer, cut, cylinder, fillet


def assembly_of_three(doc):
    """A base, a cover and two dowels: four solids, of which the second dowel is a link.

    Each solid falls in another category: the base has thin features (its holes leave walls
    under 29 % of diag), the cover is thin, the short dowel is normal. Only the .FCStd file knows
    of the link: Part's STEP export writes four separate solids.
    """
    length, width, base_height, cover = 100.0, 70.0, 45.0, 5.0
    pin, pin_length, positions = 12.0, 30.0, ((25.0, 35.0), (75.0, 35.0))
    depth = pin_length - cover  # the dowels end flush with the cover's top

    blank = box(doc, "Base blank", (length, width, base_height))
    seats = [
        cylinder(doc, f"Seat {i}", pin, depth, (x, y, base_height - depth))
        for i, (x, y) in enumerate(positions, 1)
    ]
    cut(doc, "Base block", blank, *seats)

    sheet = box(doc, "Cover blank", (length, width, cover))
    sheet = fillet(doc, "Rounded cover blank", sheet, 5.0, lambda e: is_line(e, Z))
    holes = [
        cylinder(doc, f"Cover hole {i}", pin, cover, (x, y, 0))
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
