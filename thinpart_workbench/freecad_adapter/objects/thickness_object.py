# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document object of a thickness map: its properties, and whether its sources have changed since."""

from dataclasses import dataclass

from ...core.analysis_settings import SHOWN_MEASURES
from ...core.rendering.colour_maps import COLOUR_MAPS
from ...core.rendering.colour_scale import UNMEASURED, ColourScale
from ..bootstrap import load_freecad
from ..guard import guarded_methods
from ..preferences import QT_TRANSLATE_NOOP, preference
from ..shapes.placements import global_placement, same_placement
from ..shapes.source_signature import same_signature, signature
from .map_recompute import RECOMPUTED
from .property_flags import COMPUTED, HIDDEN, SHOWN_ONLY

TYPE = "ThinPart::Thickness"
MILLIMETRES, SHARE = RANGE_UNITS = ("mm", "share of the diagonal")

OWN_CHECK = "own"
"""What `Check` is where the threshold itself is the limit that is checked."""


@dataclass(frozen=True)
class Property:
    """One property of the object.

    Attributes
    ----------
    name, type, group : str
    default : object
        None keeps FreeCAD's default. A tuple of str lists the choices of an enumeration; the first is set.
    meaning : str
    flags : int
        FreeCAD's ``App::Prop_`` flags.
    preference : str
        Name of the preference that gives the value of a new object instead of the default.
    before : object
        Value in objects that an older ThinPart saved without the property; None for that of a new object.
    """

    name: str
    type: str
    group: str
    default: object
    meaning: str
    flags: int = 0
    preference: str = ""
    before: object = None


PROPERTIES = (
    Property("Sources", "App::PropertyLinkListGlobal", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "What was measured")),
    Property("Map", "App::PropertyFileIncluded", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "The measured thickness"), SHOWN_ONLY | HIDDEN),
    Property("MapBefore", "App::PropertyFileIncluded", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "The thickness before the sources were changed last"), SHOWN_ONLY | HIDDEN),
    Property("Measure", "App::PropertyEnumeration", "Base", SHOWN_MEASURES,
             QT_TRANSLATE_NOOP("App::Property", "How it was measured: across the wall, or as the largest ball inside"),
             COMPUTED),
    Property("Signature", "App::PropertyString", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "The sources' shapes when measured"), COMPUTED | HIDDEN),
    Property("SourcePlacements", "App::PropertyPlacementList", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Placements of the sources when they were measured"), COMPUTED | HIDDEN),
    Property("Stale", "App::PropertyBool", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether the sources have changed since"), COMPUTED),
    Property("Diagonal", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Diagonal of the largest part's bounding box, mm"), COMPUTED),
    Property("Thinnest", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Thinnest wall of the map, mm"), COMPUTED),
    Property("Thickest", "App::PropertyFloat", "Base", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickest wall of the map, mm"), COMPUTED),
    Property("RangeUnit", "App::PropertyEnumeration", "Scale", RANGE_UNITS,
             QT_TRANSLATE_NOOP("App::Property", "Unit of Low and High"), SHOWN_ONLY),
    Property("AutomaticRange", "App::PropertyBool", "Scale", True,
             QT_TRANSLATE_NOOP("App::Property", "Whether colours run from the thinnest to the thickest wall"),
             SHOWN_ONLY),
    Property("Low", "App::PropertyFloat", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickness at the lower end of the colours"), SHOWN_ONLY),
    Property("High", "App::PropertyFloat", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Thickness at the upper end of the colours"), SHOWN_ONLY),
    Property("ColourMap", "App::PropertyEnumeration", "Scale", COLOUR_MAPS,
             QT_TRANSLATE_NOOP("App::Property", "Colours from thin to thick"), SHOWN_ONLY, "HeatMapColours"),
    Property("Reversed", "App::PropertyBool", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether the colours run the other way"), SHOWN_ONLY, "HeatMapReversed"),
    Property("Bands", "App::PropertyInteger", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Number of steps; 0: smooth"), SHOWN_ONLY, "HeatMapBands"),
    Property("Logarithmic", "App::PropertyBool", "Scale", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether equal ratios of thickness are equally far apart on the scale"),
             SHOWN_ONLY, "HeatMapLogarithmic", before=False),
    Property("Shaded", "App::PropertyBool", "Scale", None,
             QT_TRANSLATE_NOOP(
                 "App::Property", "Whether the map is lit; off: flat colours, exactly those of the colour bar"),
             SHOWN_ONLY, "HeatMapShading", before=False),
    Property("UnmeasuredColour", "App::PropertyColor", "Scale", UNMEASURED,
             QT_TRANSLATE_NOOP("App::Property", "Colour where no wall was measured"), SHOWN_ONLY, "UnmeasuredColour"),
    Property("Threshold", "App::PropertyFloat", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Walls thinner than this are thin, mm"), SHOWN_ONLY),
    Property("ThinOnly", "App::PropertyBool", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Whether only thin walls are coloured"), SHOWN_ONLY),
    Property("Check", "App::PropertyString", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Process whose walls are at least Threshold and at most CheckMost"),
             SHOWN_ONLY),
    Property("CheckMost", "App::PropertyFloat", "Thin", None,
             QT_TRANSLATE_NOOP("App::Property", "Greatest wall that the process allows, mm; 0: any"), SHOWN_ONLY),
    Property("ProbePoints", "App::PropertyVectorList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "Points where the thickness was probed"), SHOWN_ONLY),
    Property("ProbeOpposites", "App::PropertyVectorList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "Points opposite the probed points"), SHOWN_ONLY),
    Property("ProbeValues", "App::PropertyFloatList", "Probes", None,
             QT_TRANSLATE_NOOP("App::Property", "Wall thickness at the probed points, mm"), SHOWN_ONLY),
)
"""Every property of the object. The groups Scale and Thin hold the display settings; see `scale_of`."""

_RANGE = ("RangeUnit", "AutomaticRange", "Low", "High", "Diagonal", "Thinnest", "Thickest")


def is_thickness(candidate):
    """Whether an object of a document is a thickness map."""
    return isinstance(getattr(candidate, "Proxy", None), ThicknessObject)


def thickness_objects(document):
    """list of FreeCAD.DocumentObject: the thickness maps of a document, in their order."""
    return [candidate for candidate in document.findObjects("App::FeaturePython") if is_thickness(candidate)]


def scale_of(thickness):
    """The ColourScale of a thickness map, with its range in mm."""
    unit = unit_in_mm(thickness)
    return ColourScale(
        thickness.Low * unit, thickness.High * unit, thickness.ColourMap, thickness.Reversed,
        max(0, thickness.Bands), tuple(thickness.UnmeasuredColour[:3]), thickness.Logarithmic,
    )


def unit_in_mm(thickness):
    """float: size of one `RangeUnit` of the map in mm."""
    return thickness.Diagonal if thickness.RangeUnit == SHARE and thickness.Diagonal > 0.0 else 1.0


@guarded_methods("onDocumentRestored", "onChanged", "execute")
class ThicknessObject:
    """Proxy of the object. All saved state is in the object's properties.

    Parameters
    ----------
    thickness : FreeCAD.DocumentObject
        An App::FeaturePython; the properties are added to it.
    """

    def __init__(self, thickness):
        thickness.Proxy = self
        self._reset()
        _add_missing_properties(thickness)

    def _reset(self):
        self._unit = None  # current unit of Low and High in mm, to convert them when it changes
        self._last_state = None  # the sources at the last check, see `_source_state`
        self.cached_parts = None  # see `document_maps`
        self.cached_check = None  # what the window knows of its facets beside the limits

    def dumps(self):
        """The proxy saves no state of its own. Called by FreeCAD 1.0."""
        return TYPE

    def loads(self, _state):
        """Restore after opening. Called by FreeCAD 1.0."""
        self._reset()

    def __getstate__(self):
        return TYPE

    def __setstate__(self, _state):
        self._reset()

    def onDocumentRestored(self, thickness):
        """Add the properties that a map saved by an older ThinPart lacks."""
        _add_missing_properties(thickness, is_restored=True)
        _add_missing_colour_maps(thickness)
        self._unit = unit_in_mm(thickness)

    def onChanged(self, thickness, name):
        """Update Low and High when the unit or the automatic range changes."""
        if name in _RANGE and not (
                thickness.Document.Restoring or "Restore" in thickness.State
                or _is_undoing(thickness.Document)) and hasattr(thickness, "ThinOnly"):
            self._update_range(thickness, name)

    def execute(self, thickness):
        """Mark the map as stale if its sources changed; on a second recompute request a new measurement.

        A recompute after a change of the sources only marks the map, because measuring takes seconds.
        """
        was_stale, last_state = thickness.Stale, self._last_state
        self.check(thickness)
        is_to_be_measured = was_stale and thickness.Stale and last_state is not None and _same_source_state(
            last_state, self._last_state)
        RECOMPUTED(thickness, is_to_be_measured)

    def check(self, thickness):
        """Compare the sources with the measured ones and set `Stale`. Returns whether `Stale` changed."""
        self._last_state = _source_state(thickness.Sources)
        stale = not (thickness.Sources and same_signature(thickness.Signature, self._last_state[0])) or (
            motion(thickness) is None)
        if stale == thickness.Stale:
            return False
        thickness.Stale = stale
        return True

    def measured(self, thickness):
        """Record the current state of the sources as the measured one."""
        self._last_state = _source_state(thickness.Sources)
        thickness.Signature, thickness.SourcePlacements = self._last_state
        thickness.Stale = False

    def _update_range(self, thickness, name):
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
        for bound, value in (("Low", low), ("High", high)):
            if getattr(thickness, bound) != value:
                setattr(thickness, bound, value)


def _source_state(sources):
    """The `signature` of objects, and their global placements as a list of Placement."""
    return signature(sources), [global_placement(source) for source in sources]


def _same_source_state(one, other):
    return same_signature(one[0], other[0]) and len(one[1]) == len(other[1]) and all(
        map(same_placement, one[1], other[1]))


def motion(thickness):
    """How the sources have moved since they were measured: FreeCAD.Placement or None.

    None if they have not all moved alike, so that the map no longer fits them.
    """
    measured, sources = thickness.SourcePlacements, thickness.Sources
    if len(measured) != len(sources) or not sources:
        return None
    motions = [global_placement(source) * old.inverse() for source, old in zip(sources, measured)]
    # Compare at the sources' own positions: the farther from the origin, the more an angle matters.
    if all(same_placement(motions[0] * old, other * old) for other, old in zip(motions, measured)):
        return motions[0]
    return None


def _add_missing_properties(thickness, is_restored=False):
    """Add the properties that the object lacks; one that was saved without them keeps its look."""
    for declared in PROPERTIES:
        if declared.name in thickness.PropertiesList:
            continue
        thickness.addProperty(declared.type, declared.name, declared.group, declared.meaning, declared.flags)
        value = declared.default
        if declared.type == "App::PropertyEnumeration":
            setattr(thickness, declared.name, list(declared.default))
            value = declared.default[0]
        if declared.preference:
            value = preference(declared.preference)
        if is_restored and declared.before is not None:
            value = declared.before
        if value is not None:
            setattr(thickness, declared.name, value)


def _add_missing_colour_maps(thickness):
    """Offer the colour maps that there are now also where the object was saved with fewer; the chosen one stays."""
    if set(thickness.getEnumerationsOfProperty("ColourMap")) != set(COLOUR_MAPS):
        chosen = thickness.ColourMap
        thickness.ColourMap = list(COLOUR_MAPS)
        thickness.ColourMap = chosen if chosen in COLOUR_MAPS else COLOUR_MAPS[0]


def _is_undoing(document):
    # FreeCAD restores every property itself. FreeCAD 0.20 does not expose this to Python.
    return getattr(document, "Transacting", False) or load_freecad().isRestoring()
