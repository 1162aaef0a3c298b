"""Mesh settings that worked: kept with a part in its info file, and found for parts like it."""

from datetime import datetime, timezone

from .. import __version__
from ..core.errors import ThinPartError
from ..core.message import message
from ..core.record.mesh_settings import LEAST_ALIKE, settings_for, wall_sizes_for, worked_settings
from ..storage.info.annotations import set_annotation
from ..storage.info.info_file import change_info, stored_info
from ..storage.info.stored_records import info_file_of, select_record
from .libraries import Libraries

_ASKED = 30
"""The parts most alike, among which settings are looked for."""


def keep_mesh_settings(path, part, settings, global_size, diagonal, rows, figures, info_folder=None):
    """Keep with a part the settings with which it was meshed, in its info file.

    Parameters
    ----------
    path : str or Path
        Document or info file.
    part : str or None
        Name or label; None if the document has only one part.
    settings, global_size, diagonal, rows, figures
        See `core.record.mesh_settings.worked_settings`.
    info_folder : str or Path, optional

    Returns
    -------
    dict
        What is kept, ``meshed`` of the part record.

    Raises
    ------
    ThinPartError
        kind ``missing`` where there is no info file, ``usage`` if it is ambiguous which part is meant.
    """
    kept = worked_settings(settings, global_size, diagonal, rows, figures,
                           datetime.now(timezone.utc).isoformat(timespec="seconds"), __version__)
    change_info(info_file_of(path, info_folder),
                lambda content: set_annotation(select_record(content["parts"], part, path), meshed=kept))
    return kept


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
    """
    content = stored_info(info_file) if info_file is not None else None
    own = next((part for part in (content or {"parts": ()})["parts"] if part["name"] == record["name"]), {})
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
    walls = [(wall["kind"], wall["median"]) for wall in record.get("regions", {"listed": ()})["listed"]]
    return {"label": label, "file": file, "alike": alike, "is_own": is_own, "meshed": meshed,
            "settings": settings_for(meshed, diagonal),
            "sizes": sorted(wall_sizes_for(meshed, walls, diagonal).items())}


def no_settings(part):
    """The sentence for a part for which there are none."""
    return message("No part like {part} has mesh settings that worked: the usual ones are used.", part=part)
