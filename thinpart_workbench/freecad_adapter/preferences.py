# SPDX-License-Identifier: LGPL-2.1-or-later
"""ThinPart's preferences in FreeCAD: one table that declares them, and access to them by name."""

import json
from dataclasses import dataclass, replace

from ..core.analysis_settings import ANGULAR_DEFLECTIONS, DEFAULT_PROFILE, LINEAR_DEFLECTIONS, STANDARD, AnalysisSettings
from ..core.errors import ThinPartError
from ..core.file_formats import CHOICES
from ..core.rendering.colour_maps import COLOUR_MAPS, RED_IS_THIN
from ..system.user import user_name
from .bootstrap import load_freecad

GROUP = "User parameter:BaseApp/Preferences/Mod/ThinPart"


def QT_TRANSLATE_NOOP(_context, text):
    """Mark a text for translation; the window translates it when it shows it."""
    return text


_CLASSIFICATION = QT_TRANSLATE_NOOP("ThinPart", "Classification")
_DISPLAY = QT_TRANSLATE_NOOP("ThinPart", "Display")
_AUTOMATIC = QT_TRANSLATE_NOOP("ThinPart", "Automatic")

PAGES = (_CLASSIFICATION, _DISPLAY, _AUTOMATIC)
"""Titles of the preference pages, in their order."""

_OF_DIAGONAL = QT_TRANSLATE_NOOP("ThinPart", "of the diagonal")
MILLIMETRES = "mm"
"""Unit of lengths. It is never translated: the window shows lengths in FreeCAD's unit."""


@dataclass(frozen=True)
class Preference:
    """One preference.

    Attributes
    ----------
    name : str
        Key in FreeCAD's parameters.
    default : str, bool, int, float or tuple
        A tuple is a colour: red, green and blue from 0 to 1.
    meaning : str
        Description in one line, shown to the user.
    title : str
        Title on its page; empty if it is on no page.
    page, group : str
        One of `PAGES`, and the heading on that page.
    unit : str
    range : tuple
        Least and greatest value; empty if every value is allowed.
    zero : str
        Meaning of 0, which is then allowed in addition to the range.
    choices : tuple
        ``(value, title)`` of every allowed value.
    names : str
        What the text refers to: ``profile``, ``folder``, ``processes`` or ``person``.
    needs : tuple
        ``(name, value)`` of another preference without which this one has no effect.
    """

    name: str
    default: object
    meaning: str
    title: str = ""
    page: str = ""
    group: str = ""
    unit: str = ""
    range: tuple = ()
    zero: str = ""
    choices: tuple = ()
    names: str = ""
    needs: tuple = ()

    def allows(self, value):
        """Whether a value of the right type is allowed."""
        if self.choices:
            return value in [choice for choice, _ in self.choices]
        if self.zero and value == 0:
            return True
        return not self.range or self.range[0] <= value <= self.range[1]


def _on(page, group, *rows):
    """The preferences with their page and group set."""
    return tuple(replace(row, page=page, group=group) for row in rows)


PREFERENCES = {declared.name: declared for declared in (
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Verdict"),
        Preference("Profile", DEFAULT_PROFILE, QT_TRANSLATE_NOOP(
            "ThinPart", "Thresholds to judge by: a shipped profile, or a file"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Thresholds"), names="profile"),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Limits of the wall"),
        Preference("Checks", "", QT_TRANSLATE_NOOP(
            "ThinPart", "Processes, with commas between them, whose least and greatest wall every part is checked against"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Check for"), names="processes"),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Surface mesh that is measured"),
        Preference("Accuracy", STANDARD, QT_TRANSLATE_NOOP(
            "ThinPart", "How finely parts are measured at first; where the error of a quantity could turn the verdict, a "
                        "part is measured again, more finely"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Accuracy"), choices=(
                ("verdict", QT_TRANSLATE_NOOP("ThinPart", "only as the verdict needs")),
                (STANDARD, QT_TRANSLATE_NOOP("ThinPart", "standard")),
                ("fine", QT_TRANSLATE_NOOP("ThinPart", "fine")))),
        Preference("LinearDeflection", AnalysisSettings.linear_deflection, QT_TRANSLATE_NOOP(
            "ThinPart", "How far the mesh may lie from the surface, as a share of the part's diagonal; "
            "where walls are thin it is made finer anyway"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Linear deflection"), unit=_OF_DIAGONAL,
            range=LINEAR_DEFLECTIONS),
        Preference("AngularDeflection", AnalysisSettings.angular_deflection, QT_TRANSLATE_NOOP(
            "ThinPart", "Angle between neighbouring facets of a curved face"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Angular deflection"),
            unit=QT_TRANSLATE_NOOP("ThinPart", "\u00b0"), range=ANGULAR_DEFLECTIONS),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Info files"),
        Preference("InfoFolder", "", QT_TRANSLATE_NOOP(
            "ThinPart", "Folder for the info files, which mirrors the folders of the documents; it may be on another "
                        "computer. Empty: beside each document"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Folder"), names="folder",
            zero=QT_TRANSLATE_NOOP("ThinPart", "beside each document")),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Libraries"),
        Preference("KnownParts", True, QT_TRANSLATE_NOOP(
            "ThinPart", "Say below a verdict whether the libraries of Find parts have the part already, its mirror image, "
                        "another size, or one like it"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Say what libraries have already")),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Labels"),
        Preference("Person", "", QT_TRANSLATE_NOOP(
            "ThinPart", "Your name, under which your labels of parts are kept. Empty: your name on this computer"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Your name"), names="person",
            zero=QT_TRANSLATE_NOOP("ThinPart", "as on this computer")),
    ),
    *_on(
        _CLASSIFICATION, QT_TRANSLATE_NOOP("ThinPart", "Limits"),
        Preference("Jobs", 0, QT_TRANSLATE_NOOP(
            "ThinPart", "Number of files of a folder that are measured at the same time"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Files at once"), range=(1, 1024),
            zero=QT_TRANSLATE_NOOP("ThinPart", "one per processor")),
        Preference("Seconds", 600, QT_TRANSLATE_NOOP(
            "ThinPart", "Time limit for one file of a folder, or for one document that is classified automatically"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Time per file"),
            unit=QT_TRANSLATE_NOOP("ThinPart", "s"), range=(1, 7 * 24 * 3600)),
        Preference("MemoryMegabytes", 6144, QT_TRANSLATE_NOOP(
            "ThinPart", "Memory limit for measuring one document"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Memory per file"),
            unit=QT_TRANSLATE_NOOP("ThinPart", "MB"), range=(700, 1_000_000)),
    ),
    *_on(
        _DISPLAY, QT_TRANSLATE_NOOP("ThinPart", "Walls that are shown as thin"),
        Preference("ThinLimit", "verdict", QT_TRANSLATE_NOOP(
            "ThinPart", "Walls thinner than this are coloured as thin; the verdict does not depend on it"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Thin below"), choices=(
                ("verdict", QT_TRANSLATE_NOOP("ThinPart", "same limit as the verdict")),
                ("millimetres", QT_TRANSLATE_NOOP("ThinPart", "a thickness")),
                ("share", QT_TRANSLATE_NOOP("ThinPart", "a share of the part's diagonal")))),
        Preference("ThinLimitMillimetres", 2.0, QT_TRANSLATE_NOOP(
            "ThinPart", "Walls thinner than this are coloured as thin"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Thickness"), unit=MILLIMETRES, range=(0.001, 100_000.0),
            needs=("ThinLimit", "millimetres")),
        Preference("ThinLimitShare", 0.05, QT_TRANSLATE_NOOP(
            "ThinPart", "Walls thinner than this share of the part's diagonal are coloured as thin"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Share"), unit=_OF_DIAGONAL, range=(0.0005, 1.0),
            needs=("ThinLimit", "share")),
    ),
    *_on(
        _DISPLAY, QT_TRANSLATE_NOOP("ThinPart", "Colours"),
        Preference("ThinColour", (0.84, 0.15, 0.12), QT_TRANSLATE_NOOP(
            "ThinPart", "Faces that are thin on at least half their area"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Thin faces")),
        Preference("PartlyThinColour", (0.96, 0.60, 0.11), QT_TRANSLATE_NOOP(
            "ThinPart", "Faces that are thin on less of their area"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Faces thin in places")),
        Preference("UnmeasuredColour", (0.55, 0.55, 0.55), QT_TRANSLATE_NOOP(
            "ThinPart", "Heat map colour where no wall could be measured"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Not measured")),
    ),
    *_on(
        _DISPLAY, QT_TRANSLATE_NOOP("ThinPart", "Heat map of the thickness"),
        Preference("HeatMapColours", COLOUR_MAPS[0], QT_TRANSLATE_NOOP(
            "ThinPart", "Colours from the thinnest to the thickest wall"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Colours"), choices=(
                (RED_IS_THIN, QT_TRANSLATE_NOOP("ThinPart", "red is thin")), *((name, name) for name in COLOUR_MAPS[1:]))),
        Preference("HeatMapReversed", False, QT_TRANSLATE_NOOP(
            "ThinPart", "The first colour stands for the thickest wall"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Reversed")),
        Preference("HeatMapShading", True, QT_TRANSLATE_NOOP(
            "ThinPart", "The map is lit, so that its shape is seen: colours get darker away from the light. Off: flat "
                        "colours, exactly those of the colour bar"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Shaded")),
        Preference("HeatMapLogarithmic", False, QT_TRANSLATE_NOOP(
            "ThinPart", "Equal ratios of thickness are equally far apart on the scale"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Logarithmic")),
        Preference("HeatMapBands", 0, QT_TRANSLATE_NOOP(
            "ThinPart", "Into how many steps the colours are divided"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Bands"), range=(2, 64),
            zero=QT_TRANSLATE_NOOP("ThinPart", "smooth")),
    ),
    *_on(
        _AUTOMATIC, QT_TRANSLATE_NOOP("ThinPart", "On every save"),
        Preference("AutomaticClassification", False, QT_TRANSLATE_NOOP(
            "ThinPart", "Each document is classified in the background when it is saved; the status "
            "bar shows the verdict"),
            title=QT_TRANSLATE_NOOP("ThinPart", "Classify in the background")),
    ),
    *_on(
        _AUTOMATIC, QT_TRANSLATE_NOOP("ThinPart", "Warnings"),
        Preference("WarnOfCategory", True, QT_TRANSLATE_NOOP(
            "ThinPart", "Compared with what the info file said before"),
            title=QT_TRANSLATE_NOOP("ThinPart", "When the category of a part changes"),
            needs=("AutomaticClassification", True)),
        Preference("WarnWallUnder", 0.0, QT_TRANSLATE_NOOP(
            "ThinPart", "When the thinnest wall of a part falls below this thickness, or is below it in a part that "
                        "was not classified before"),
            title=QT_TRANSLATE_NOOP("ThinPart", "When a wall is thinner than"), unit=MILLIMETRES,
            range=(0.001, 100_000.0), zero=QT_TRANSLATE_NOOP("ThinPart", "off"),
            needs=("AutomaticClassification", True)),
        Preference("KnownPartsOnSave", False, QT_TRANSLATE_NOOP(
            "ThinPart", "The same part, its mirror image, another size, or one like it; each is said once"),
            title=QT_TRANSLATE_NOOP("ThinPart", "When libraries have a part already"),
            needs=("AutomaticClassification", True)),
    ),
    Preference("ColourBarShown", True, "Whether thickness maps have a colour bar in the view"),
    Preference("ColourBarAcross", 0.0, "Where the colour bar stands: 0 left, 1 right", range=(0.0, 1.0)),
    Preference("ColourBarDown", 0.5, "Where the colour bar stands: 0 above, 1 below", range=(0.0, 1.0)),
    Preference("ColourBarSize", 1.0, "Size of the colour bar, of that which it has at first", range=(0.5, 2.5)),
    Preference("MapLabels", True, "Whether the thinnest, the thickest and the pinned walls of maps have labels in the view"),
    Preference("FolderHistory", "[]", "Folders that were classified, the last one first, as JSON"),
    Preference("FolderFormats", " ".join(CHOICES), "Formats taken from a folder"),
    Preference("FolderInclude", "", "Patterns of the names taken from a folder; empty: all"),
    Preference("FolderExclude", "", "Patterns of the names left out of a folder"),
    Preference("FolderUsesInfoFolder", 0, "1: info files of a folder go into FolderInfoFolder"),
    Preference("FolderInfoFolder", "", "Where info files of a folder go, if not where all go"),
    Preference("FolderProfile", "", "Thresholds to judge a folder by; empty: those of Profile"),
    Preference("FolderJobs", -1, "Files of a folder that are measured at once; -1: as Jobs says"),
    Preference("FolderSeconds", 0, "Seconds that one file of a folder may take; 0: as Seconds says"),
    Preference("Libraries", "[]", "Folders of classified parts that are searched, as JSON"),
    Preference("ProfileVersionsTold", "[]", "Versions of shipped profiles and libraries of which it was said that another "
                                            "version has judged info files, as JSON"),
)}


_STORED_AS = {bool: "Bool", int: "Int", float: "Float", str: "String"}
"""How FreeCAD's parameters call the types of values; a colour is an unsigned number."""


def preference(name):
    """Value of a preference; its default if it is not set or its stored value is invalid.

    Raises KeyError when no such preference is declared.
    """
    declared, group = PREFERENCES[name], load_freecad().ParamGet(GROUP)
    default = declared.default
    if isinstance(default, tuple):
        return _colour(group.GetUnsigned(name, _packed(default)))
    value = getattr(group, f"Get{_STORED_AS[type(default)]}")(name, default)
    return default if value == "" or not declared.allows(value) else value


def set_preference(name, value):
    """Store a preference in FreeCAD's parameters; `None` resets it to its default.

    Raises KeyError when no such preference is declared; ThinPartError, kind ``usage`` if the value has another type than the
    default, or is not allowed.
    """
    declared, group = PREFERENCES[name], load_freecad().ParamGet(GROUP)
    value = declared.default if value is None else value
    if type(value) is not type(declared.default) or not declared.allows(value):
        raise ThinPartError(f"{declared.title or name} cannot be {value!r}.", "usage")
    if isinstance(value, tuple):
        group.SetUnsigned(name, _packed(value))
    else:
        getattr(group, f"Set{_STORED_AS[type(value)]}")(name, value)


def preferred_analysis():
    """AnalysisSettings from the user's preferences."""
    return AnalysisSettings.at(preference("Accuracy"), **changed_deflections())


def changed_deflections():
    """dict of str to float: fields of `AnalysisSettings` that the user has changed; the others follow from the accuracy."""
    chosen = {"linear_deflection": preference("LinearDeflection"), "angular_deflection": preference("AngularDeflection")}
    return {name: value for name, value in chosen.items() if value != getattr(AnalysisSettings, name)}


def preferred_thin_limit():
    """The thickness below which a wall is shown as thin: dict or None.

    ``millimetres`` or ``share`` (of the diagonal) with its value; None for the verdict's own limit.
    """
    chosen = preference("ThinLimit")
    if chosen == "verdict":
        return None
    return {chosen: preference("ThinLimitMillimetres" if chosen == "millimetres" else "ThinLimitShare")}


def preferred_person():
    """The name under which the user's labels are kept."""
    return preference("Person").strip() or user_name()


def preference_list(name):
    """list of str that a preference stores as JSON; empty if the stored text is invalid."""
    try:
        stored = json.loads(preference(name))
    except ValueError:
        return []
    return [text for text in stored if isinstance(text, str)] if isinstance(stored, list) else []


def set_preference_list(name, texts):
    """Store a list of str; see `preference_list`."""
    set_preference(name, json.dumps(texts))


def _packed(colour):
    """A colour as FreeCAD stores it: 0xRRGGBBAA."""
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8 | 0xFF


def _colour(packed):
    return tuple((packed >> shift & 0xFF) / 255.0 for shift in (24, 16, 8))
