"""The preferences of ThinPart in FreeCAD: one declared table, and reading and writing by its names."""

import json
from dataclasses import dataclass

from ..core.errors import ThinPartError
from .bootstrap import load_freecad

GROUP = "User parameter:BaseApp/Preferences/Mod/ThinPart"


@dataclass(frozen=True)
class Preference:
    """One preference.

    Attributes
    ----------
    name : str
        Key in FreeCAD's parameters.
    default : str, int or tuple
        A tuple is a colour: red, green and blue from 0 to 1.
    meaning : str
        One line for people.
    """

    name: str
    default: object
    meaning: str


PREFERENCES = {each.name: each for each in (
    Preference("Profile", "paper", "Thresholds to judge by: a shipped profile's name, or a file"),
    Preference("MemoryMegabytes", 6144, "Memory that measuring a document may take"),
    Preference("ThinColour", (0.84, 0.15, 0.12), "Faces that are thin on at least half their area"),
    Preference("PartlyThinColour", (0.96, 0.60, 0.11), "Faces that are thin on less of their area"),
    Preference("FolderHistory", "[]", "Folders that were classified, the last one first, as JSON"),
    Preference("FolderFormats", "FreeCAD STEP IGES BREP Mesh", "Formats taken from a folder"),
    Preference("FolderInclude", "", "Patterns of the names taken from a folder; empty: all"),
    Preference("FolderExclude", "", "Patterns of the names left out of a folder"),
    Preference("FolderUsesInfoFolder", 0, "1: info files of a folder go into FolderInfoFolder"),
    Preference("FolderInfoFolder", "", "Where info files of a folder go, if not beside documents"),
    Preference("FolderProfile", "", "Thresholds to judge a folder by; empty: those of Profile"),
    Preference("FolderJobs", 0, "Files of a folder that are measured at once; 0: one per processor"),
    Preference("Libraries", "[]", "Folders of classified parts that are searched, as JSON"),
    Preference("FolderSeconds", 600, "Seconds that one file of a folder may take"),
)}


def preference(name):
    """Value of a preference, its default where the user set none.

    Raises
    ------
    KeyError
        When no such preference is declared.
    """
    declared, group = PREFERENCES[name], load_freecad().ParamGet(GROUP)
    if isinstance(declared.default, tuple):
        return _colour(group.GetUnsigned(name, _packed(declared.default)))
    if isinstance(declared.default, int):
        return group.GetInt(name, declared.default)
    return group.GetString(name, declared.default) or declared.default


def set_preference(name, value):
    """Keep a preference in FreeCAD's parameters; `None` takes it back to its default.

    Raises
    ------
    KeyError
        When no such preference is declared.
    ThinPartError
        kind ``usage`` where the value is of another type than the default.
    """
    declared, group = PREFERENCES[name], load_freecad().ParamGet(GROUP)
    value = declared.default if value is None else value
    if type(value) is not type(declared.default):
        raise ThinPartError(f"{name} cannot be {value!r}.", "usage")
    if isinstance(value, tuple):
        group.SetUnsigned(name, _packed(value))
    elif isinstance(value, int):
        group.SetInt(name, value)
    else:
        group.SetString(name, value)


def preference_list(name):
    """list of str that a preference keeps as JSON; empty where somebody has spoilt it."""
    try:
        kept = json.loads(preference(name))
    except ValueError:
        return []
    return [each for each in kept if isinstance(each, str)] if isinstance(kept, list) else []


def set_preference_list(name, texts):
    """Keep a list of str; see `preference_list`."""
    set_preference(name, json.dumps(texts))


def _packed(colour):
    """As FreeCAD keeps colours: 0xRRGGBBAA."""
    red, green, blue = (round(255 * part) for part in colour)
    return red << 24 | green << 16 | blue << 8 | 0xFF


def _colour(packed):
    return tuple((packed >> shift & 0xFF) / 255.0 for shift in (24, 16, 8))
