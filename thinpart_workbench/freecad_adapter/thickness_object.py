"""A thickness map as an object of a document: what it keeps, and whether its sources are still the same."""

from dataclasses import dataclass

from ..core.colour_scale import COLOUR_MAPS, UNMEASURED, ColourScale
from .bootstrap import load_freecad
from .edge import guarded_methods
from .settings import QT_TRANSLATE_NOOP, preference
from .source_signature import global_placement, same_place, same_signature, signature

TYPE = "ThinPart::Thickness"
MILLIMETRES, SHARE = RANGE_UNITS = ("mm", "share of the diagonal")

_SHOWN_ONLY = 16  # App::Prop_NoRecompute: a change is seen at once and recomputes nothing
_FOUND = 1 | 8 | 16  # read-only, an output of the object, and no reason to recompute it
_HIDDEN = 4


@dataclass(frozen=True)
class Property:
    """One property of the object.

    Attributes
    ----------
    name, type, group : str
    default : object
        None leaves FreeCAD's; a tuple of str is what an enumeration offers, the first of which is set.
    meaning : str
    flags : int
        FreeCAD's ``App::Prop_`` flags.
    preference : str
        Name of the preference that a new object takes in place of the default.
    """

    name: str
    type: str
    group: str
    default: object
    meaning: str
    flags: int = 0
    preference: str = ""


PROPERTIES = (
    Property("Sources", "App::PropertyLinkListGlobal", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "What was measured")),
    Property("Map", "App::PropertyFileIncluded", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "The measured thickness"), 16 | _HIDDEN),
    Property("Signature", "App::PropertyString", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "The sources' shapes when measured"), _FOUND | _HIDDEN),
    Property("SourcePlacements", "App::PropertyPlacementList", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Where the sources stood when measured"), _FOUND | _HIDDEN),
    Property("Stale", "App::PropertyBool", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether the sources have changed since"), _FOUND),
    Property("Diagonal", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Of the largest part's box, mm"), _FOUND),
    Property("Thinnest", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Thinnest wall of the map, mm"), _FOUND),
    Property("Thickest", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickest wall of the map, mm"), _FOUND),
    Property("RangeUnit", "App::PropertyEnumeration", "Scale", RANGE_UNITS,
             QT_TRANSLATE_NOOP("App::Property", "Unit of Low and High"), 16),
    Property("AutomaticRange", "App::PropertyBool", "Scale", True,
             QT_TRANSLATE_NOOP("App::Property", "Whether colours run from the thinnest to the thickest wall"),
             16),
    Property("Low", "App::PropertyFloat", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickness at the lower end of the colours"), 16),
    Property("High", "App::PropertyFloat", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickness at the upper end of the colours"), 16),
    Property("ColourMap", "App::PropertyEnumeration", "Scale", COLOUR_MAPS,
             QT_TRANSLATE_NOOP("App::Property", "Colours from thin to thick"), 16, "HeatMapColours"),
    Property("Reversed", "App::PropertyBool", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether the colours run the other way"), 16, "HeatMapReversed"),
    Property("Bands", "App::PropertyInteger", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Number of steps; 0: smooth"), 16, "HeatMapBands"),
    Property("UnmeasuredColour", "App::PropertyColor", "Scale", UNMEASURED,
             QT_TRANSLATE_NOOP("App::Property", "Where nothing was measured"), 16, "UnmeasuredColour"),
    Property("Threshold", "App::PropertyFloat", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Walls under it are thin, mm"), 16),
    Property("ThinOnly", "App::PropertyBool", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether only thin walls are coloured"), 16),
    Property("ProbePoints", "App::PropertyVectorList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "Where thickness was asked for"), 16),
    Property("ProbeOpposites", "App::PropertyVectorList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "The opposite sides of those"), 16),
    Property("ProbeValues", "App::PropertyFloatList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "The thickness there, mm"), 16),
)
"""Every property of the object. Those of the group Scale and Thin say how it looks; see `scale_of`."""

_RANGE = ("RangeUnit", "AutomaticRange", "Low", "High", "Diagonal", "Thinnest", "Thickest")


def is_thickness(candidate):
    """Whether an object of a document is a thickness map."""
    return isinstance(getattr(candidate, "Proxy", None), ThicknessObject)


def thickness_objects(document):
    """list of FreeCAD.DocumentObject: the thickness maps of a document, in their order."""
    return [each for each in document.findObjects("App::FeaturePython") if is_thickness(each)]


def scale_of(thickness):
    """The colours of a thickness map, its range in mm: ColourScale."""
    unit = unit_in_mm(thickness)
    return ColourScale(
        thickness.Low * unit, thickness.High * unit, thickness.ColourMap, thickness.Reversed,
        max(0, thickness.Bands), tuple(thickness.UnmeasuredColour[:3]),
    )


def unit_in_mm(thickness):
    """float: what 1 of the map's `RangeUnit` is in mm."""
    return thickness.Diagonal if thickness.RangeUnit == SHARE and thickness.Diagonal > 0.0 else 1.0


@guarded_methods("onDocumentRestored", "onChanged", "execute")
class ThicknessObject:
    """Behaviour of the object. Everything that is kept is in its properties.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        An App::FeaturePython, which gets the properties.
    """

    def __init__(self, thickness):
        thickness.Proxy = self
        self._start()
        _complete(thickness)

    def _start(self):
        self._unit = None  # what Low and High are in at present, to convert them
        self._seen = None  # the sources when they were last looked at, see `_look`
        self.kept_parts = None  # see `document_maps`

    def dumps(self):
        """Nothing is kept here; FreeCAD 1.0 asks so."""
        return TYPE

    def loads(self, _state):
        """After opening; FreeCAD 1.0 asks so."""
        self._start()

    def __getstate__(self):
        return TYPE

    def __setstate__(self, _state):
        self._start()

    def onDocumentRestored(self, thickness):
        """A document was opened; a map of an older ThinPart lacks properties."""
        _complete(thickness)
        self._unit = unit_in_mm(thickness)

    def onChanged(self, thickness, name):
        """Keep the range what it is, or what it has to be."""
        if name in _RANGE and not (
                thickness.Document.Restoring or "Restore" in thickness.State
                or _is_undoing(thickness.Document)) and hasattr(thickness, "ThinOnly"):
            self._follow(thickness, name)

    def execute(self, thickness):
        """Tell whether the sources are still those that were measured; asked again, ask for measuring.

        A recompute that follows a change of the sources only marks the map, since measuring takes seconds.
        """
        was_stale, seen = thickness.Stale, self._seen
        self.check(thickness)
        view = getattr(getattr(thickness, "ViewObject", None), "Proxy", None)
        if not hasattr(view, "ask_for_measuring"):
            return  # there is no window
        view.move()
        if was_stale and thickness.Stale and seen is not None and _same_look(seen, self._seen):
            view.ask_for_measuring()

    def check(self, thickness):
        """Compare the sources with what was measured, and set `Stale`; whether that has changed."""
        self._seen = _look(thickness.Sources)
        stale = not (thickness.Sources and same_signature(thickness.Signature, self._seen[0])) or (
            motion(thickness) is None)
        if stale == thickness.Stale:
            return False
        thickness.Stale = stale
        return True

    def measured(self, thickness):
        """Take the sources as they are for what was measured."""
        self._seen = _look(thickness.Sources)
        thickness.Signature, thickness.SourcePlacements = self._seen
        thickness.Stale = False

    def _follow(self, thickness, name):
        unit = unit_in_mm(thickness)
        if self._unit is None:
            self._unit = unit
        if thickness.AutomaticRange:
            low, high = thickness.Thinnest / unit, thickness.Thickest / unit
        elif unit != self._unit and name == "RangeUnit":
            low, high = thickness.Low * self._unit / unit, thickness.High * self._unit / unit
        else:
            low, high = thickness.Low, thickness.High
        self._unit = unit
        for each, value in (("Low", low), ("High", high)):
            if getattr(thickness, each) != value:
                setattr(thickness, each, value)


def _look(sources):
    """The shapes of objects, as `signature`, and where they stand, list of Placement."""
    return signature(sources), [global_placement(each) for each in sources]


def _same_look(one, other):
    return same_signature(one[0], other[0]) and len(one[1]) == len(other[1]) and all(
        map(same_place, one[1], other[1]))


def motion(thickness):
    """How the sources have moved since they were measured.

    Returns
    -------
    FreeCAD.Placement or None
        None where they have not all moved alike, so that the map does not fit them any more.
    """
    then, sources = thickness.SourcePlacements, thickness.Sources
    if len(then) != len(sources) or not sources:
        return None
    moved = [global_placement(each) * old.inverse() for each, old in zip(sources, then)]
    # Compared where the sources stand: an angle says more, the further away from the origin.
    if all(same_place(moved[0] * old, each * old) for each, old in zip(moved, then)):
        return moved[0]
    return None


def _complete(thickness):
    """Add the properties that the object does not have."""
    for each in PROPERTIES:
        if each.name in thickness.PropertiesList:
            continue
        thickness.addProperty(each.type, each.name, each.group, each.meaning, each.flags)
        start = each.default
        if each.type == "App::PropertyEnumeration":
            setattr(thickness, each.name, list(each.default))
            start = each.default[0]
        if each.preference:
            start = preference(each.preference)
        if start is not None:
            setattr(thickness, each.name, start)


def _is_undoing(document):
    # FreeCAD puts back every property itself. 0.20 does not tell Python of it.
    return getattr(document, "Transacting", False) or load_freecad().isRestoring()
