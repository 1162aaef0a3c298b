"""What the shape of a part was made from, step by step."""

from collections import deque
from dataclasses import dataclass, field

import numpy as np

from .part import SolidPart

MADE_FROM = ("BaseFeature", "Base", "Tool", "Tools", "Shapes", "Source", "Objects", "Links", "Faces",
             "Originals")
"""Properties by which an object names the shapes that it is made from; where a face lies on several, the
first has it. What only bounds or places it, such as the face that a pad ends at, is none of them."""

MOST_FEATURES = 200
"""Features at which the history of a part is cut off."""


@dataclass
class Feature:
    """An object that a part was made with.

    Attributes
    ----------
    label : str
        Empty where not all of what it was made from is followed, so that nothing can be told.
    shape : Part.Shape
    frame : ndarray of shape (4, 4)
        From the coordinates of the shape to those of the part, mm.
    sources : list of int
        What it was made from, by place in the history.
    """

    label: str
    shape: object
    frame: np.ndarray
    sources: list = field(default_factory=list)


def feature_history(part):
    """The objects that a part of an open document was made with.

    Parameters
    ----------
    part : SolidPart or MeshedPart

    Returns
    -------
    list of Feature
        The last one first. Empty where nothing is known: of meshes, of files of other programs, and of what
        was imported into a document.

    Notes
    -----
    Nothing is computed on the shapes, which are those of the document: this takes milliseconds.
    """
    if not isinstance(part, SolidPart) or not part.occurrences or part.occurrences[0] is None:
        return []
    try:
        return _history(part.occurrences[0])
    except Exception:  # FreeCAD raises its own classes, which differ between versions; the part is
        return []      # measured and shown without


def _history(place):
    import FreeCAD
    import Part

    if not place.document:
        return []
    root = FreeCAD.getDocument(place.document).getObject(place.root)
    leaf = root.getSubObject(place.path, retType=1) if place.path else root
    placed = Part.getShape(root, place.path, needSubElement=False, transform=True)
    source = leaf.getLinkedObject(True) or leaf
    if not placed.isPartner(source.Shape):
        return []  # scaled on its way there
    made = _maker(source, _matrix(placed.Placement) @ _inverse(source.Shape.Placement))
    if made is None or made[0].TypeId == "Part::Feature":
        return []
    steps = _Steps()
    steps.number(*made)
    steps.follow()
    return steps.features


class _Steps:
    """Features in the order in which they are met, each once at every place where it was used."""

    def __init__(self):
        self.features = []
        self._numbers = {}
        self._waiting = deque()

    def number(self, maker, shape, frame):
        """Place of an object among the features; None when there is no room for it."""
        key = maker.Document.Name, maker.Name, tuple(frame.round(6).ravel())
        if key not in self._numbers:
            if len(self.features) >= MOST_FEATURES:
                return None
            self._numbers[key] = len(self.features)
            self._waiting.append((self._numbers[key], maker))
            self.features.append(Feature(maker.Label, shape, frame))
        return self._numbers[key]

    def follow(self):
        while self._waiting:
            number, maker = self._waiting.popleft()
            feature = self.features[number]
            for source in _sources(maker, feature.shape, feature.frame):
                there = self.number(*source)
                if there is None:
                    feature.label = ""
                elif there not in (number, *feature.sources):
                    feature.sources.append(there)


def _sources(user, shape, frame):
    """What an object was made from, each as `_maker` gives it."""
    # The features of a body share its coordinates. All others are moved as a whole by their placement.
    inner = frame
    if not user.isDerivedFrom("PartDesign::Feature"):
        inner = frame @ _matrix(user.Placement)
    names = MADE_FROM + (("Group",) if user.TypeId == "PartDesign::Boolean" else ())
    for name in names:
        if name in user.PropertiesList and "PropertyLink" in user.getTypeIdOfProperty(name):
            for target in _targets(getattr(user, name)):
                made = _maker(target, inner)
                if made is not None and made[1].isPartner(shape):
                    # Taken over as it is, also where its placement is not, as by the base of a body.
                    made = *made[:2], frame @ _matrix(shape.Placement) @ _inverse(made[1].Placement)
                if made is not None:
                    yield made


def _targets(value):
    """Objects in the value of a link, of a list of links, or of links to faces and edges."""
    if isinstance(value, tuple) and len(value) == 2 and isinstance(value[1], (str, list, tuple)):
        value = value[:1]
    for each in value if isinstance(value, (list, tuple)) else [value]:
        if isinstance(each, (list, tuple)):
            yield from _targets(tuple(each))
        elif each is not None:
            yield each


def _maker(source, frame):
    """What made the solid of an object: (object, shape, frame) behind links and bodies, or None."""
    import Part

    while True:
        shape = Part.getShape(source)
        if shape.isNull() or not shape.Solids:
            return None
        linked = source.getLinkedObject(True) or source
        if linked != source:
            if not shape.isPartner(linked.Shape):
                return source, shape, frame  # scaled, or many at once
            frame = frame @ _matrix(shape.Placement) @ _inverse(linked.Shape.Placement)
            source = linked
        elif source.isDerivedFrom("Part::BodyBase") and source.Tip is not None:
            frame = frame @ _matrix(source.Placement)
            source = source.Tip
        else:
            return source, shape, frame


def _matrix(placement):
    return np.array(placement.toMatrix().A).reshape(4, 4)


def _inverse(placement):
    return _matrix(placement.inverse())
