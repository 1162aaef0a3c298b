# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts that are nowhere thin."""

from FreeCAD import Vector

from .edge_choice import is_circle, is_line
from .part_objects import Y, add, box, chamfer, extrusion, fillet, polygon


def block(doc):
    """The block of the ribbed block, without its rib, all edges rounded."""
    return [fillet(doc, "Block", box(doc, "Sharp block", (100, 60, 40)), 5.0)]


def vee_block(doc):
    """A vee block: 100 x 80 x 70, and nowhere thinner than 30 % of diag between parallel faces."""
    width, length, height, half_vee, slot = 100.0, 80.0, 70.0, 20.0, 4.0
    floor = height - half_vee - 3.0  # the relief slot's bottom
    middle = width / 2
    meet = height - half_vee + slot / 2  # where the vee's flanks meet the slot's walls
    profile = polygon(doc, "End view", [
        (0, 0, 0), (width, 0, 0), (width, 0, height), (middle + half_vee, 0, height),
        (middle + slot / 2, 0, meet), (middle + slot / 2, 0, floor),
        (middle - slot / 2, 0, floor), (middle - slot / 2, 0, meet),
        (middle - half_vee, 0, height), (0, 0, height),
    ])
    sharp = extrusion(doc, "Sharp vee block", profile, Vector(0, length, 0))

    def is_at_a_side(edge):
        return is_line(edge, Y) and abs(abs(edge.CenterOfMass.x - middle) - middle) < 1e-6

    return [chamfer(doc, "Vee block", sharp, 2.0, is_at_a_side)]


def tapered_plug(doc):
    """A plug that narrows from 60 to 54 mm over 60 mm."""
    cone = add(doc, "Part::Cone", "Cone", Radius1=30.0, Radius2=27.0, Height=60.0)
    rounded = fillet(doc, "Rounded end", cone, 8.0, lambda e: is_circle(e, 54, 60))
    return [chamfer(doc, "Plug", rounded, 3.0, lambda e: is_circle(e, 60, 0))]
