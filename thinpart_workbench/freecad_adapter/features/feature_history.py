# SPDX-License-Identifier: LGPL-2.1-or-later
"""The features that a part was made with, step by step."""

from collections import deque
from dataclasses import dataclass, field

import numpy as np

from ..occurrence import object_at, shape_at
from ..shapes.part import SolidPart
from ..shapes.placements import placement_matrix

SOURCE_PROPERTIES = ("BaseFeature", "Base", "Tool", "Tools", "Shapes", "Source", "Objects", "Links", "Faces",
                     "Originals")
"""Properties that link an object to the shapes that it is made from; a face that lies on several counts for the
first. References that only bound or place the object, such as the face that a pad ends at, are not listed."""

MOST_FEATURES = 200
"""Number of features at which the history of a part is cut off."""


@dataclass
class Feature:
    """A document object that a part was made with.

    Attributes
    ----------
    label : str
        Empty if not all of its sources were followed, so that no face can be assigned to it.
    shape : Part.Shape
    frame : ndarray of shape (4, 4)
        From the coordinates of the shape to those of the part, mm.
    sources : list of int
        Indices of its sources in the history.
    """

    label: str
    shape: object
    frame: np.ndarray
    sources: list = field(default_factory=list)


def feature_history(part):
    """The objects that a SolidPart or MeshedPart of an open document was made with: list of Feature.

    The last one first. Empty if nothing is known: for meshes, files of other programs and imported shapes.

    This takes milliseconds, because it only refers to the document's shapes and computes nothing on them.
    """
    if not isinstance(part, SolidPart) or not part.occurrences or part.occurrences[0] is None:
        return []
    try:
        return _history(part.occurrences[0])
    except Exception:  # FreeCAD raises its own classes, which differ between versions; the part is
        return []      # measured and shown without its history


def _history(occurrence):
    import FreeCAD

    if not occurrence.document:
        return []
    root = occurrence.top(FreeCAD.getDocument(occurrence.document))
    leaf, shape = object_at(root, occurrence.path), shape_at(root, occurrence.path)
    source = leaf.getLinkedObject(True) or leaf
    if not shape.isPartner(source.Shape):
        return []  # a link on the path scales it
    maker = _maker(source, placement_matrix(shape.Placement) @ placement_matrix(source.Shape.Placement.inverse()))
    if maker is None or maker[0].TypeId == "Part::Feature":
        return []
    steps = _Steps()
    steps.number(*maker)
    steps.follow()
    return steps.features


class _Steps:
    """Features in the order in which they are found, one per object and frame."""

    def __init__(self):
        self.features = []
        self._numbers = {}
        self._pending = deque()

    def number(self, maker, shape, frame):
        """Index of an object among the features, adding it if needed; None if `MOST_FEATURES` is reached."""
        key = maker.Document.Name, maker.Name, tuple(frame.round(6).ravel())
        if key not in self._numbers:
            if len(self.features) >= MOST_FEATURES:
                return None
            self._numbers[key] = len(self.features)
            self._pending.append((self._numbers[key], maker))
            self.features.append(Feature(maker.Label, shape, frame))
        return self._numbers[key]

    def follow(self):
        while self._pending:
            number, maker = self._pending.popleft()
            feature = self.features[number]
            for source in _sources(maker, feature.shape, feature.frame):
                index = self.number(*source)
                if index is None:
                    feature.label = ""
                elif index not in (number, *feature.sources):
                    feature.sources.append(index)


def _sources(user, shape, frame):
    """The sources of an object, each as a result of `_maker`."""
    # The features of a body share its coordinates. The placement of any other object moves all its sources.
    inner = frame
    if not user.isDerivedFrom("PartDesign::Feature"):
        inner = frame @ placement_matrix(user.Placement)
    names = SOURCE_PROPERTIES + (("Group",) if user.TypeId == "PartDesign::Boolean" else ())
    for name in names:
        if name in user.PropertiesList and "PropertyLink" in user.getTypeIdOfProperty(name):
            for target in _targets(getattr(user, name)):
                source = _maker(target, inner)
                if source is not None and source[1].isPartner(shape):
                    # The object takes over the source's shape with another placement, as the base of a body does.
                    back = placement_matrix(source[1].Placement.inverse())
                    source = *source[:2], frame @ placement_matrix(shape.Placement) @ back
                if source is not None:
                    yield source


def _targets(value):
    """Objects in the value of a link property: a link, a list of links, or links to faces and edges."""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], (str, list, tuple)):
        value = value[:1]
    for item in value if isinstance(value, (list, tuple)) else [value]:
        if isinstance(item, (list, tuple)):
            yield from _targets(tuple(item))
        elif item is not None:
            yield item


def _maker(source, frame):
    """The object that made a solid, behind links and bodies: (object, shape, frame) or None."""
    import Part

    while True:
        shape = Part.getShape(source)
        if shape.isNull() or not shape.Solids:
            return None
        linked = source.getLinkedObject(True) or source
        if linked != source:
            if not shape.isPartner(linked.Shape):
                return source, shape, frame  # a scaled link or an array
            frame = frame @ placement_matrix(shape.Placement) @ placement_matrix(linked.Shape.Placement.inverse())
            source = linked
        elif source.isDerivedFrom("Part::BodyBase") and source.Tip is not None:
            frame = frame @ placement_matrix(source.Placement)
            source = source.Tip
        else:
            return source, shape, frame
