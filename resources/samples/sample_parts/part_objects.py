# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part objects that the samples are made of."""

from FreeCAD import Placement, Rotation, Vector

from .edge_choice import edges_where

X, Y, Z = Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)


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
    return add(doc, "Part::Box", label, Length=length, Width=width, Height=height,
               Placement=Placement(Vector(*at), Rotation()))


def cylinder(doc, label, diameter, height, at=(0, 0, 0), axis=Z):
    """A Part::Cylinder standing on `at` and rising along `axis`."""
    return add(doc, "Part::Cylinder", label, Radius=diameter / 2, Height=height,
               Placement=Placement(Vector(*at), Rotation(Z, axis)))


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
    return add(doc, "Part::Extrusion", label, Base=profile, DirMode="Custom", Dir=direction,
               LengthFwd=direction.Length, Solid=True, FaceMakerClass="Part::FaceMakerBullseye")


def polygon(doc, label, points):
    """A closed Part::Polygon through the given points."""
    return add(doc, "Part::Polygon", label, Nodes=[Vector(*p) for p in points], Close=True)


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
