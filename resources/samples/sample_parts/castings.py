# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cast cover, hollow and solid: parts of one overall shape, of which only one is thin as a whole."""

from FreeCAD import Placement, Rotation, Vector

from .edge_choice import is_line, lies_at
from .part_objects import X, Z, box, cut, cylinder, extrusion, fillet, fuse, polygon

LENGTH, WIDTH, CORNER = 140.0, 90.0, 14.0
"""Of the body, mm."""

RIM, FLANGE = 13.0, 5.0
"""Width and thickness of the flange around its foot, mm."""


def thin_walled_casting(doc):
    """A gearbox cover: 3 mm walls, a flange, a bearing boss with ribs, fillets."""
    height, wall = 48.0, 3.0
    outside = _rounded_block(doc, "Outside", (LENGTH, WIDTH, height), CORNER, 7.0)
    # The hollow is an offset of the outside (equal walls at the corners, too).
    hollow = (LENGTH - 2 * wall, WIDTH - 2 * wall, height - wall)
    hollow = _rounded_block(doc, "Hollow", hollow, CORNER - wall, 7.0 - wall, (wall, wall, 0))
    walls = _with_flange_and_boss(doc, outside, height)
    return [cut(doc, "Gearbox cover", walls, hollow, *_bores(doc, height))]


def solid_casting(doc):
    """The same cover, solid and higher, so that only its flange, its ribs and the ring around its bore are thin."""
    height = 60.0
    outside = _rounded_block(doc, "Outside", (LENGTH, WIDTH, height), CORNER, 7.0)
    body = _with_flange_and_boss(doc, outside, height)
    return [cut(doc, "Bearing block", body, *_bores(doc, height))]


def _rounded_block(doc, label, size, corner, top, at=(0, 0, 0)):
    """A block with rounded upright edges, and then a rounded top."""
    block = box(doc, f"{label} block", size, at)
    block = fillet(doc, f"{label} corners", block, corner, lambda e: is_line(e, Z))
    return fillet(doc, label, block, top, lambda e: lies_at(e, Z, size[2]))


def _with_flange_and_boss(doc, outside, height):
    """The body with the flange around its foot, and on its roof a boss that four ribs brace."""
    rim_block = box(doc, "Rim block", (LENGTH + 2 * RIM, WIDTH + 2 * RIM, FLANGE), (-RIM, -RIM, 0))
    rim_block = fillet(doc, "Rim", rim_block, CORNER + RIM, lambda e: is_line(e, Z))
    boss = cylinder(doc, "Bearing boss", 44, 13, (LENGTH / 2, WIDTH / 2, height - 3))
    # The ribs start within the wall of the roof.
    ribs = []
    for i, (dx, dy, reach) in enumerate(((1, 0, 54), (-1, 0, 54), (0, 1, 32), (0, -1, 32)), 1):
        rib = polygon(doc, f"Rib profile {i}", [
            (17, 0, height - 1), (reach, 0, height - 1), (reach, 0, height), (21, 0, height + 7),
            (17, 0, height + 7),
        ])
        solid = extrusion(doc, f"Rib {i}", rib, Vector(0, 3, 0))
        turn = Rotation(X, Vector(dx, dy, 0))
        start = Vector(LENGTH / 2, WIDTH / 2, 0) + turn.multVec(Vector(0, -1.5, 0))
        solid.Placement = Placement(start, turn)
        ribs.append(solid)
    walls = fuse(doc, "Cast body", outside, rim_block, boss, *ribs)

    def wall_meets_rim(edge):
        extent = edge.BoundBox
        inside_x = extent.XMin > -1 and extent.XMax < LENGTH + 1
        inside_y = extent.YMin > -1 and extent.YMax < WIDTH + 1
        return lies_at(edge, Z, FLANGE) and inside_x and inside_y

    return fillet(doc, "Cast body with fillets", walls, 2.5, wall_meets_rim)


def _bores(doc, height):
    """The bore of the bearing, 40 mm deep from the top of the boss, and the holes of the bolts."""
    bore = cylinder(doc, "Bearing bore", 32, 40, (LENGTH / 2, WIDTH / 2, height - 30))
    places = [(-7, 12), (-7, 78), (147, 12), (147, 78), (40, -7), (100, -7), (40, 97), (100, 97)]
    return [bore, *(cylinder(doc, f"Bolt hole {i + 1}", 5.5, FLANGE, (x, y, 0)) for i, (x, y) in enumerate(places))]
