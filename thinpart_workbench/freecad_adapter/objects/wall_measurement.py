# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall thickness as a measurement type of FreeCAD's own measure tool, available from FreeCAD 1.0 on."""

from ..bootstrap import load_freecad
from ..guard import guarded_methods
from ..occurrence import matrix_at, shape_at, split_at_element
from ..preferences import QT_TRANSLATE_NOOP
from .property_flags import COMPUTED
from .wall_at_point import point_on_face, wall_at_point

ID = "THINPART_WALL"

MEASUREMENT = "Measure::MeasurePython"
"""FreeCAD's object type for measurements written in Python, shared by all add-ons."""


@guarded_methods("parseSelection", "execute", "onChanged", "onDocumentRestored", isValidSelection=False,
                 isPrioritySelection=False, getSubject=(), getResultString="")
class WallMeasurement:
    """Proxy of a wall measurement. All state is in the object's properties, which can be read without ThinPart.

    The measure tool calls `isValidSelection` with the selection, tuples of dict with ``object``, ``subName`` and
    ``pickedPoint``. The user has to choose the tool's mode: without one, the tool measures the area of a face.

    Parameters
    ----------
    measurement : FreeCAD.DocumentObject
        An object of type `MEASUREMENT`; the properties are added to it.
    """

    def __init__(self, measurement):
        measurement.Proxy = self
        for kind, name, meaning, flags in (
                ("App::PropertyLinkSubGlobal", "Element", QT_TRANSLATE_NOOP(
                    "App::Property", "The face where the wall is measured"), 0),
                ("App::PropertyPosition", "Where", QT_TRANSLATE_NOOP(
                    "App::Property", "Measured point on the face, in the coordinates of its object"), 0),
                ("App::PropertyLength", "Thickness", QT_TRANSLATE_NOOP(
                    "App::Property", "Wall thickness at the measured point"), COMPUTED),
                ("App::PropertyPosition", "Opposite", QT_TRANSLATE_NOOP(
                    "App::Property", "Opposite point, in the coordinates of the document"), COMPUTED)):
            measurement.addProperty(kind, name, "Measurement", meaning, flags)

    @classmethod
    def isValidSelection(cls, selection):
        """Whether the selection is one face of a closed solid."""
        return len(selection) == 1 and _face_and_solid(
            selection[0]["object"], selection[0]["subName"]) is not None

    @classmethod
    def isPrioritySelection(cls, _selection):
        """False: the tool measures the area of a face unless the user chooses another mode."""
        return False

    @classmethod
    def getInputProps(cls):
        """Names of the properties that the result depends on."""
        return "Element", "Where"

    def getSubject(self, measurement):
        """The object that has to be visible for the measurement to be shown."""
        return (measurement.Element[0],) if measurement.Element else ()

    def parseSelection(self, measurement, selection):
        """Measure the selected face at the clicked point, or in its middle if it was not selected by a click."""
        item, = selection
        top, path = item["object"], item["subName"]
        face, _ = _face_and_solid(top, path)
        picked = item["pickedPoint"]
        # FreeCAD passes the origin for a selection in the tree or by a program.
        point = point_on_face(face, picked if picked.Length > 0.0 else None)
        measurement.Where = _object_matrix(top, path).inverse().multVec(point)
        measurement.Element = top, path

    def getResultString(self, measurement):
        """The text in the 3D view, in the tool's panel and in the tree."""
        if measurement.Thickness.Value > 0.0:
            return f"t = {measurement.Thickness.UserString}"
        return load_freecad().Qt.translate("ThinPart", "not measured")

    def execute(self, measurement):
        """Measure again at the same point of the object, wherever the object is placed now."""
        App = load_freecad()
        wall = None
        if measurement.Element and measurement.Element[1]:
            top, (path, *_) = measurement.Element
            found = _face_and_solid(top, path)
            if found is not None:
                face, solid = found
                point = point_on_face(face, _object_matrix(top, path).multVec(measurement.Where))
                wall = wall_at_point(solid, face, point)
                measurement.Placement = App.Placement(point, App.Rotation())
        measurement.Thickness = 0.0 if wall is None else wall.thickness
        measurement.Opposite = measurement.Placement.Base if wall is None else wall.opposite

    def onChanged(self, measurement, name):
        """Measure when the element changes: the tool sets it last and shows the result without a recompute."""
        if name == "Element" and not measurement.Document.Restoring and hasattr(measurement, "Opposite"):
            self.execute(measurement)

    def dumps(self):
        """The proxy saves no state of its own."""

    def loads(self, _state):
        """The proxy saves no state of its own."""


def revive_measurements(document):
    """Restore the proxies of measurements whose document was saved while ThinPart was not installed."""
    if ID not in _registered_ids():
        return
    for measurement in document.findObjects(MEASUREMENT):
        names = {"Element", "Where", "Thickness", "Opposite"}
        if measurement.Proxy is None and names <= set(measurement.PropertiesList):
            measurement.Proxy = WallMeasurement.__new__(WallMeasurement)
            measurement.touch()


def _registered_ids():
    """Ids of the measurement types of FreeCAD's measure tool; none if FreeCAD has no such tool."""
    registry = getattr(load_freecad(), "MeasureManager", None)
    return () if registry is None else [entry[0] for entry in registry.getMeasureTypes()]


def _face_and_solid(top, path):
    """The face at a sub-object path and the closed solid that it bounds, both placed; None if there is none."""
    object_path, element = split_at_element(path)
    if top is None or not element.startswith("Face"):
        return None
    shape = shape_at(top, object_path)
    number = int(element[4:])
    if shape.isNull() or not 1 <= number <= len(shape.Faces):
        return None
    face = shape.Faces[number - 1]
    solid = next((candidate for candidate in shape.Solids
                  if any(face.isSame(other) for other in candidate.Faces)), None)
    return None if solid is None else (face, solid)


def _object_matrix(top, path):
    """The global Matrix of the object at a sub-object path."""
    return matrix_at(top, split_at_element(path)[0])


def add_wall_measurement():
    """Register the measurement type with FreeCAD's measure tool. Returns whether FreeCAD has that tool."""
    App = load_freecad()
    if not hasattr(App, "MeasureManager"):
        return False
    if ID not in _registered_ids():
        App.MeasureManager.addMeasureType(ID, App.Qt.translate("ThinPart", "Wall thickness"), WallMeasurement)
    return True
