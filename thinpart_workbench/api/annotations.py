# SPDX-License-Identifier: LGPL-2.1-or-later
"""Set the annotations of a part in its info file: notes, mesh settings, links, labels, notes on walls; check links; find
settings that worked for parts alike."""

import os
import re
from datetime import datetime, timezone
from pathlib import Path
from urllib.parse import urlsplit

from .. import __version__
from ..core.categories import NORMAL
from ..core.errors import ThinPartError
from ..core.foreign_text import printable
from ..core.kinds.json_file import UnreadableJson, parsed_json
from ..core.message import message
from ..core.problem import problem_of
from ..core.record.mesh_settings import LEAST_ALIKE, settings_for, wall_sizes_for, worked_settings
from ..core.record.record_types import PART, PERSON
from ..core.record.region_groups import equal_regions
from ..core.regular_file import open_regular
from ..storage.info.annotations import set_annotation, set_face_limit, set_label, set_region_note
from ..storage.info.info_file import change_info, stored_info
from ..storage.info.stored_records import info_file_of, select_record
from ..system.file_paths import is_below
from ..system.user import user_name
from .libraries import Libraries

LARGEST_SETTINGS = 1024 * 1024
"""Maximum bytes of mesh settings that are copied into an info file; of a larger file only the name is stored."""

_ASKED = 30
"""The parts most alike, among which settings are looked for."""

_PROGRAM_ENDINGS = (
    ".app", ".appimage", ".bat", ".cmd", ".com", ".command", ".cpl", ".desktop", ".exe", ".fcmacro", ".hta", ".inf",
    ".jar", ".js", ".jse", ".lnk", ".msc", ".msi", ".pif", ".ps1", ".py", ".pyw", ".reg", ".scf", ".scr", ".sh", ".url",
    ".vbe", ".vbs", ".wsf", ".wsh")
"""Endings of files that a desktop runs when they are opened."""

_SCHEME = re.compile(r"[A-Za-z][A-Za-z0-9+.-]+:")


def annotate_part(path, part=None, info_folder=None, **values):
    """Set annotations of a part, or remove those whose value is empty; returns its PartRecord.

    Parameters
    ----------
    path : str or Path
        Document or info file.
    part : str, optional
        Name or label; optional if the document has only one part.
    info_folder : str or Path, optional
        See `info_file_of`.
    values
        ``notes``, ``mesh``, ``link``; None leaves one unchanged.

    Raises
    ------
    ThinPartError
        kind ``usage`` if it is ambiguous which part is meant.

    Examples
    --------
    >>> annotate_part(plate, notes="of the cover")["notes"]
    'of the cover'
    """
    return _changed(path, part, info_folder, lambda record, _: set_annotation(record, **values))


def label_part(path, category, person="", is_sure=True, part=None, info_folder=None):
    """Keep with a part what a person says it is; the answers of others stay. Returns its PartRecord.

    Parameters
    ----------
    path, part, info_folder
        See `annotate_part`.
    category : str
        A category of the profile by which the part was judged, or ``normal``. Empty removes the person's answer.
    person : str, optional
        By default the name of the user on this computer.
    is_sure : bool, optional

    Raises
    ------
    ThinPartError
        kind ``usage`` if it is ambiguous which part is meant, or there is no such category.

    Examples
    --------
    >>> label_part(plate, "thin", "Ann")["labels"][0]["category"]
    'thin'
    """
    person = _checked_person(person)

    def change(record, profile):
        known = [*(each["name"] for each in profile["categories"]), NORMAL]
        if category and category not in known:
            raise ThinPartError(message("{category!r} is no category: there are {known}.",
                                        category=category, known=", ".join(known)), "usage")
        return set_label(record, person, category, is_sure)

    return _changed(path, part, info_folder, change)


def note_regions(path, regions, person="", part=None, info_folder=None, excluded=None, mesh_size_mm=None):
    """Keep with wall regions of a part what a person says of them; the verdict stays. Returns its PartRecord.

    Parameters
    ----------
    path, part, info_folder
        See `annotate_part`.
    regions : list of dict
        As in a part record; they are found again by place and faces.
    person : str, optional
        By default the name of the user on this computer.
    excluded : str, optional
        Why they are left out; empty includes them again, None changes nothing.
    mesh_size_mm : float, optional
        Wanted element size; 0 removes it, None changes nothing.

    Raises
    ------
    ThinPartError
        kind ``usage`` if it is ambiguous which part is meant, or if something cannot be kept.

    Examples
    --------
    >>> wall = record["regions"]["listed"][0]
    >>> note_regions(plate, [wall], "Ann", mesh_size_mm=0.5)["region_notes"][0]["mesh_size_mm"]
    0.5
    """
    person = _checked_person(person)
    return _changed(path, part, info_folder,
                    lambda record, _: set_region_note(record, regions, person, excluded, mesh_size_mm))


def limit_faces(path, faces, reason="", min_mm=None, max_mm=None, person="", part=None, info_folder=None):
    """Keep limits of the wall for single faces of a part, which checks respect; returns its PartRecord.

    Parameters
    ----------
    path, part, info_folder
        See `annotate_part`.
    faces : list of str
        Names, such as ``Face3``.
    reason : str
        Why the faces have limits of their own.
    min_mm, max_mm : float, optional
        The least and the greatest wall; without both, the limits of the faces are removed.
    person : str, optional
        By default the name of the user on this computer.

    Raises
    ------
    ThinPartError
        kind ``usage`` if it is ambiguous which part is meant, there is no such face, or no reason is given.

    Examples
    --------
    >>> limit_faces(plate, ["Face1"], "crush rib", min_mm=0.5)["face_limits"][0]["reason"]
    'crush rib'
    """
    person, reason = _checked_person(person), reason.strip()
    is_limited = min_mm is not None or max_mm is not None
    if is_limited and not reason:
        raise ThinPartError(message("A limit for single faces needs a reason."), "usage")
    for value in (min_mm, max_mm):
        if value is not None and not 1e-9 <= value <= 1e9 or None not in (min_mm, max_mm) and min_mm > max_mm:
            raise ThinPartError(
                message("Limits for single faces are lengths over 0, the least one no greater than the other."), "usage")

    def change(record, _):
        known = {face["face"] for face in record["faces"]}
        if not is_limited:
            known |= {limit["face"] for limit in record.get("face_limits", ())}
        missing = [face for face in faces if face not in known]
        if missing:
            raise ThinPartError(message("{part} has no {face}: names of faces are those of FreeCAD, such as Face1.",
                                        part=record["label"], face=missing[0]), "usage")
        return set_face_limit(record, faces, person, reason, min_mm, max_mm)

    return _changed(path, part, info_folder, change)


def region_notes(path):
    """What people said of wall regions, by an info file: dict of list by part name; None where it cannot be read.

    Examples
    --------
    >>> list(region_notes(block + ".thinpart.json").values())
    [[]]
    """
    content = stored_info(path)
    return None if content is None else {part["name"]: part.get("region_notes", []) for part in content["parts"]}


def face_limits(path):
    """Limits for single faces, by an info file: dict of list by part name; None where it cannot be read.

    Examples
    --------
    >>> list(face_limits(block + ".thinpart.json").values())
    [[]]
    """
    content = stored_info(path)
    return None if content is None else {part["name"]: part.get("face_limits", []) for part in content["parts"]}


def keep_mesh_settings(path, part, settings, global_size, diagonal, rows, figures, info_folder=None):
    """Keep with a part the settings with which it was meshed, in its info file.

    Parameters
    ----------
    path, part, info_folder
        See `annotate_part`.
    settings, global_size, diagonal, rows, figures
        See `core.record.mesh_settings.worked_settings`.

    Returns
    -------
    dict
        What is kept, ``meshed`` of the part record.

    Raises
    ------
    ThinPartError
        kind ``missing`` where there is no info file, ``usage`` if it is ambiguous which part is meant.

    Examples
    --------
    >>> settings = {"order": 2, "error": 0.02, "layers": None, "growth": 1.5, "size": None, "budget": None}
    >>> figures = {"elements": 900, "poor_share": 0.0, "gamma_least": 0.3, "layers_share": 1.0, "tries": []}
    >>> keep_mesh_settings(plate, None, settings, 8.0, 100.0, [], figures)["elements"]
    900
    """
    kept = worked_settings(settings, global_size, diagonal, rows, figures,
                           datetime.now(timezone.utc).isoformat(timespec="seconds"), __version__)
    _changed(path, part, info_folder, lambda record, _: set_annotation(record, meshed=kept))
    return kept


def _changed(path, part, info_folder, change):
    """The record of a part after `change`, which is given it and the content of the profile, and says whether it did."""
    content = change_info(info_file_of(path, info_folder),
                          lambda content: change(select_record(content["parts"], part, path), content["profile"]))
    return select_record(content["parts"], part, path)


def settings_that_worked(record, roots, info_file=None, report=None):
    """Mesh settings that worked for a part, or else for the part of some libraries that is most like it.

    Parameters
    ----------
    record : PartRecord
        Of the part that is to be meshed.
    roots : list of str or Path
        Folders of info files; may be empty.
    info_file : str or Path, optional
        Of the document of the part.
    report : callable, optional
        See `Libraries`.

    Returns
    -------
    dict or None
        ``label`` of the part that has them, its ``file``, ``alike`` from 0 to 100, ``is_own``, ``meshed``, and for the given
        part: ``settings`` as arguments of `SizingSettings`, ``sizes`` of walls, by number of the listed region.

    Examples
    --------
    >>> settings_that_worked(record, []) is None  # neither an info file nor a library to look at
    True
    """
    content = stored_info(info_file) if info_file is not None else None
    own: dict = next((part for part in (content or {"parts": ()})["parts"] if part["name"] == record["name"]), {})
    if "meshed" in own:
        return _offer(record, own["label"], str(info_file), 100.0, True, own["meshed"])
    if not roots:
        return None
    with Libraries(roots, report) as libraries:
        for match in libraries.similar(record, _ASKED):
            if match.score < LEAST_ALIKE:
                break
            try:
                found = match.record()
            except ThinPartError:  # it is gone since the library was read
                continue
            if "meshed" in found:
                return _offer(record, match.label, match.file, match.score, False, found["meshed"])
    return None


def _offer(record, label, file, alike, is_own, meshed):
    diagonal = record["descriptors"]["diagonal_mm"]
    listed = record.get("regions", {"listed": ()})["listed"]
    groups = equal_regions(record)
    # Equal walls have one size, that of the first, though their measures scatter.
    walls = [(listed[numbers[0]]["kind"], listed[numbers[0]]["median"]) for numbers in groups]
    sizes = wall_sizes_for(meshed, walls, diagonal)
    return {"label": label, "file": file, "alike": alike, "is_own": is_own, "meshed": meshed,
            "settings": settings_for(meshed, diagonal),
            "sizes": sorted((number, size) for group, size in sizes.items() for number in groups[group])}


def no_settings(part):
    """The sentence for a part for which there are none.

    Examples
    --------
    >>> print(no_settings("lid"))
    No part like lid has mesh settings that worked: the usual ones are used.
    """
    return message("No part like {part} has mesh settings that worked: the usual ones are used.", part=part)


def mesh_settings(text):
    """Parse mesh settings.

    Parameters
    ----------
    text : str
        A JSON object, the name of a JSON file with one, the name of any other file, or empty to remove them.

    Returns
    -------
    dict
        ``{"settings": object}``, ``{"file": path}``, or empty.

    Examples
    --------
    >>> mesh_settings('{"size": 2}')
    {'settings': {'size': 2}}
    """
    if not text.strip():
        return {}
    if text.lstrip().startswith("{"):
        return {"settings": _settings(os.fsencode(text), message("The mesh settings"))}
    if not os.path.isfile(text):  # Path.is_file raises an error for a name that is too long
        raise ThinPartError(message("There is no file {file}: --mesh takes a JSON object or a file.",
                                    file=text), "missing")
    if Path(text).suffix.lower() == ".json":
        try:
            with open_regular(text) as file:
                content = file.read(LARGEST_SETTINGS + 1)
        except OSError as error:
            raise ThinPartError(message("The file {file} cannot be read ({problem}).",
                                        file=text, problem=problem_of(error)), "unreadable") from None
        if len(content) <= LARGEST_SETTINGS:
            return {"settings": _settings(content, message("The file {file}", file=text))}
    return {"file": os.path.abspath(text)}


def _checked_person(person):
    """The name under which something is kept; see `label_part`."""
    person = person.strip() or user_name()
    if PERSON.fault(person, "") is not None:
        raise ThinPartError(message("{person!r} cannot be kept as a person's name: choose a shorter one, in one line.",
                                    person=person[:100]), "usage")
    return person


def _settings(data, what):
    try:
        content = parsed_json(data)
    except UnreadableJson as problem:
        raise ThinPartError(message("{what} is not a JSON object ({problem}).",
                                    what=what, problem=str(problem)), "usage") from None
    if not isinstance(content, dict):
        raise ThinPartError(message("{what} is not a JSON object.", what=what), "usage")
    fault = PART.kinds["mesh"].fault({"settings": content}, "")
    if fault:
        raise ThinPartError(message("{what} cannot be stored ({problem}).", what=what, problem=fault), "usage")
    return content


def link_address(text, library, info_file):
    """The address or path to open for a link.

    Parameters
    ----------
    text : str
    library : str
        Root folder of the library with the part.
    info_file : str
        Info file of the part: relative paths start from its folder.

    Returns
    -------
    str
        An http or https address, or the absolute path of a file or folder in the library.

    Raises
    ------
    ThinPartError
        kind ``unsafe`` for any other link, ``missing`` for a path that does not exist.

    Examples
    --------
    >>> link_address("https://example.org/lid", samples, plate + ".thinpart.json")
    'https://example.org/lid'
    """
    text = text.strip()
    if not text.isprintable():
        raise _refused(printable(text))
    if re.match("https?://", text, re.IGNORECASE):
        try:
            if urlsplit(text).hostname:
                return text
        except ValueError:
            pass  # not a valid address
        raise _refused(text)
    if _SCHEME.match(text) or text.startswith(("//", "\\\\")):
        raise _refused(text)
    path = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(info_file)), text))
    if not is_below(os.path.realpath(path), os.path.realpath(library)):
        raise _refused(text)
    if not os.path.isfile(path) and not os.path.isdir(path):
        raise ThinPartError(message("There is no file {file}.", file=path), "missing")
    if os.path.realpath(path).lower().endswith(_PROGRAM_ENDINGS) or path.lower().endswith(_PROGRAM_ENDINGS):
        raise ThinPartError(message("{file} is a program: it was not opened.", file=path), "unsafe")
    return path


def _refused(text):
    return ThinPartError(
        message("{link} was not opened: a link may lead to http:// or https://, or to a file of the library.",
                link=text), "unsafe")
