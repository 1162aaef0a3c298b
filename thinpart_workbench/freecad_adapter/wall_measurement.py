"""Wall thickness as one of the measurements of FreeCAD's own measure tool, which FreeCAD 1.0 and later have."""

from .bootstrap import load_freecad
from .edge import guarded_methods
from .settings import QT_TRANSLATE_NOOP
from .wall_at_point import point_on_face, wall_at_point

ID = "THINPART_WALL"

MEASUREMENT = "Measure::MeasurePython"
"""FreeCAD's type of measurements in Python, of whichever add-on."""

_FOUND = 1 | 8 | 16  # read-only, an output of the object, and no reason to recompute it


@guarded_methods("parseSelection", "execute", "onChanged", "onDocumentRestored", isValidSelection=False,
                 isPrioritySelection=False, getSubject=(), getResultString="")
class WallMeasurement:
    """Behaviour of the measurement of one wall. What is kept is in its properties, which can be read without ThinPart.

    Parameters
    ----------
    measurement : FreeCAD.DocumentObject
        A `MEASUREMENT`, which gets the properties.

    Notes
    -----
    The measure tool calls `isValidSelection` with what is selected, tuples of dict with ``object``, ``subName`` and
    ``pickedPoint``. The tool's mode has to be chosen: without one, a face is measured by its area.
    """

    def __init__(self, measurement):
        measurement.Proxy = self
        for kind, name, meaning, flags in (
                ("App::PropertyLinkSubGlobal", "Element", QT_TRANSLATE_NOOP(
                    "App::Property", "The face where the wall is measured"), 0),
                ("App::PropertyPosition", "Where", QT_TRANSLATE_NOOP(
                    "App::Property", "The place on the face, in the coordinates of its object"), 0),
                ("App::PropertyLength", "Thickness", QT_TRANSLATE_NOOP(
                    "App::Property", "The thickness of the material under that place"), _FOUND),
                ("App::PropertyPosition", "Opposite", QT_TRANSLATE_NOOP(
                    "App::Property", "The place on the opposite side, in the coordinates of the document"), _FOUND)):
            measurement.addProperty(kind, name, "Measurement", meaning, flags)

    @classmethod
    def isValidSelection(cls, selection):
        """Whether it is one face of a closed solid."""
        return len(selection) == 1 and _face_and_solid(
            selection[0]["object"], selection[0]["subName"]) is not None

    @classmethod
    def isPrioritySelection(cls, _selection):
        """A face is measured by its area unless the user wants something else."""
        return False

    @classmethod
    def getInputProps(cls):
        """What it depends on."""
        return "Element", "Where"

    def getSubject(self, measurement):
        """What has to be visible for the measurement to be."""
        return (measurement.Element[0],) if measurement.Element else ()

    def parseSelection(self, measurement, selection):
        """Measure what is selected, where it was clicked; in its middle where it was chosen otherwise."""
        item, = selection
        top, path = item["object"], item["subName"]
        face, _ = _face_and_solid(top, path)
        picked = item["pickedPoint"]
        # FreeCAD says the origin of what was chosen in the tree, or by a program.
        place = point_on_face(face, picked if picked.Length > 0.0 else None)
        measurement.Where = _frame(top, path).inverse().multVec(place)
        measurement.Element = top, path

    def getResultString(self, measurement):
        """What is shown in the view, in the tool's panel and in the tree."""
        if measurement.Thickness.Value > 0.0:
            return f"t = {measurement.Thickness.UserString}"
        return load_freecad().Qt.translate("ThinPart", "not measured")

    def execute(self, measurement):
        """Measure again, at the same place of the object wherever that stands now."""
        App = load_freecad()
        wall = None
        if measurement.Element and measurement.Element[1]:
            top, (path, *_) = measurement.Element
            found = _face_and_solid(top, path)
            if found is not None:
                face, solid = found
                place = point_on_face(face, _frame(top, path).multVec(measurement.Where))
                wall = wall_at_point(solid, face, place)
                measurement.Placement = App.Placement(place, App.Rotation())
        measurement.Thickness = 0.0 if wall is None else wall.thickness
        measurement.Opposite = measurement.Placement.Base if wall is None else wall.opposite

    def onChanged(self, measurement, name):
        """The tool sets the element last, and shows the result without recomputing."""
        if name == "Element" and not measurement.Document.Restoring and hasattr(measurement, "Opposite"):
            self.execute(measurement)

    def dumps(self):
        """Nothing is kept here."""

    def loads(self, _state):
        """Nothing is kept here."""


def revive_measurements(document):
    """Give measurements their behaviour again that they lost where ThinPart was missing and the document was saved."""
    if ID not in _registered():
        return
    for each in document.findObjects(MEASUREMENT):
        if each.Proxy is None and {"Element", "Where", "Thickness", "Opposite"} <= set(each.PropertiesList):
            each.Proxy = WallMeasurement.__new__(WallMeasurement)
            each.touch()


def _registered():
    """Ids of the measurements that FreeCAD's measure tool knows; none where there is no such tool."""
    registry = getattr(load_freecad(), "MeasureManager", None)
    return () if registry is None else [each[0] for each in registry.getMeasureTypes()]


def _face_and_solid(top, path):
    """The face that a sub-object path leads to and the closed solid that it bounds, as they stand; None without."""
    import Part

    way, dot, element = path.rpartition(".")
    if top is None or not element.startswith("Face"):
        return None
    shape = Part.getShape(top, way + dot, needSubElement=False, transform=True)
    number = int(element[4:])
    if shape.isNull() or not 1 <= number <= len(shape.Faces):
        return None
    face = shape.Faces[number - 1]
    solid = next((each for each in shape.Solids if any(face.isSame(other) for other in each.Faces)), None)
    return None if solid is None else (face, solid)


def _frame(top, path):
    """Where the object that a path leads to stands: Matrix."""
    way, dot, _ = path.rpartition(".")
    return top.getSubObject(way + dot, retType=4)


def add_wall_measurement():
    """Make the measurement known to FreeCAD's measure tool, where there is one; whether that is so."""
    App = load_freecad()
    if not hasattr(App, "MeasureManager"):
        return False
    if ID not in _registered():
        App.MeasureManager.addMeasureType(ID, App.Qt.translate("ThinPart", "Wall thickness"), WallMeasurement)
    return True
