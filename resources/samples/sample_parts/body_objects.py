# SPDX-License-Identifier: LGPL-2.1-or-later
"""PartDesign bodies, their sketches and features."""

import Part
import Sketcher
from FreeCAD import Placement, Rotation, Vector

from .edge_choice import edges_where
from .part_objects import Z, add, hide


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
    return body_feature(owner, "PartDesign::Pad", label, Profile=sketch, Length=length, Reversed=reverse)


def through_pocket(owner, label, sketch):
    """PartDesign::Pocket against the sketch's normal, through everything."""
    return body_feature(owner, "PartDesign::Pocket", label, Profile=sketch, Type="ThroughAll")


def dress_up_body(owner, kind, label, size, wanted):
    """PartDesign::Fillet or ::Chamfer of the tip's edges that `wanted` accepts."""
    owner.Document.recompute()
    tip = owner.Tip
    names = [f"Edge{i}" for i in edges_where(tip.Shape, wanted)]
    size_name = "Radius" if kind == "PartDesign::Fillet" else "Size"
    return body_feature(owner, kind, label, Base=(tip, names), **{size_name: size})


def show_tip_only(owner):
    """Of all the features of a Body only the last one is shown."""
    hide(*(feature for feature in owner.Group if feature is not owner.Tip))
