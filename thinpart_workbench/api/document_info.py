# SPDX-License-Identifier: LGPL-2.1-or-later
"""The info file of an open document: its parts, as they were measured, and what panels keep with them and ask for."""

import os
from dataclasses import dataclass
from typing import Optional

from ..core.analysis_settings import given_settings
from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..core.message import message
from ..core.record.record_types import PersonLabel
from ..freecad_adapter.reading.linked_files import linked_files
from ..storage.info.info_file import info_content, new_source, stored_info, write_info
from ..storage.info.info_location import PATIENCE, call_in_folder, info_location
from .annotations import (
    face_limits,
    keep_mesh_settings,
    label_part,
    limit_faces,
    note_regions,
    region_notes,
    settings_that_worked,
)
from .document_verdicts import PartVerdict, document_verdicts


@dataclass(frozen=True)
class WrittenInfo:
    """An info file that was written.

    Attributes
    ----------
    path : str
    before : dict of str to PartVerdict, or None
        The verdicts of the info file that it replaces, if there was one; see `document_verdicts`.
    now : dict of str to PartVerdict
    labels : dict of str to list
        What people say of parts, by part name: kept from the replaced info file.
    """

    path: str
    before: Optional[dict[str, PartVerdict]]
    now: dict[str, PartVerdict]
    labels: dict[str, list[PersonLabel]]


def write_document_info(document, stamp, records, failures, profile, settings, folder="", patience=PATIENCE):
    """Write an info file: WrittenInfo.

    Parameters
    ----------
    document : str
        Path of the document.
    stamp : list of int
        `file_stamp` of the document at the time when its content was the measured one.
    records : list of PartRecord
    failures : list of FailureRecord
    profile : str, Path, dict or Profile
        That by which the parts were judged.
    settings : AnalysisSettings or dict
        Those with which they were measured.
    folder : str, optional
        See `info_location`.
    patience : float, optional
        Seconds to wait for the folder, which may be on another computer.

    Raises
    ------
    ThinPartError
        kind ``unreadable`` if the document was written again since, ``info_write`` if the folder does not answer or
        holds a file of that name that is no info file.

    Examples
    --------
    >>> from thinpart_workbench import AnalysisSettings
    >>> written = write_document_info(block, file_stamp(block), [record], [], "calibrated", AnalysisSettings())
    >>> [verdict["category"] for verdict in written.now.values()]
    ['thin']
    """
    path, profile = info_location(document, folder), given_profile(profile).content
    stored = call_in_folder(folder, lambda: stored_info(path), patience)
    source = new_source(document, linked_files(document), path)
    if file_stamp(document) != stamp:
        raise ThinPartError(
            message("{file} was saved again meanwhile: classify it again.",
                    file=os.path.basename(document)), "unreadable")
    content = info_content(source, given_settings(settings).content(), profile, records, failures)
    call_in_folder(folder, lambda: write_info(path, content), patience)
    return WrittenInfo(
        os.fspath(path), stored and document_verdicts(stored["parts"], stored["profile"]),
        document_verdicts(records, profile),
        {record["name"]: record["labels"] for record in content["parts"] if record.get("labels")})


def file_stamp(path):
    """Size and time of a file, to detect whether it has been written again: list of int.

    Examples
    --------
    >>> file_stamp(plate)[0] == os.stat(plate).st_size
    True
    """
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns]


def keep_label(path, part, category, is_sure, person=""):
    """Keep in an info file what a person says a part is; see `label_part`. Returns all its labels, list of PersonLabel.

    Examples
    --------
    >>> keep_label(plate + ".thinpart.json", "plate", "thin", True, "Ann")[0]["person"]
    'Ann'
    """
    return label_part(path, category, person, is_sure, part).get("labels", [])


def notes(document, folder=""):
    """What people said of the wall regions of a document, given by its path; see `region_notes` and `info_location`.

    Examples
    --------
    >>> list(notes(block).values())
    [[]]
    """
    return region_notes(info_location(document, folder))


def keep_notes(document, part, regions, folder="", person="", **said):
    """Keep what a person says of wall regions, and return what `notes` does; see `note_regions`.

    Examples
    --------
    >>> wall = record["regions"]["listed"][0]
    >>> kept = keep_notes(plate, "plate", [wall], person="Ann", excluded="cast")
    >>> [note["excluded"] for note in kept[record["name"]]]
    ['cast']
    """
    path = info_location(document, folder)
    note_regions(path, regions, person, part, **said)
    return region_notes(path)


def limited_faces(document, folder=""):
    """Limits for single faces of a document, given by its path; see `face_limits` and `info_location`.

    Examples
    --------
    >>> list(limited_faces(block).values())
    [[]]
    """
    return face_limits(info_location(document, folder))


def keep_face_limits(document, part, faces, folder="", person="", **limits):
    """Keep limits for single faces, and return what `limited_faces` does; see `limit_faces`.

    Examples
    --------
    >>> kept = keep_face_limits(plate, "plate", ["Face2"], person="Ann", reason="cast", min_mm=0.5)
    >>> [limit["min_mm"] for limit in kept[record["name"]] if limit["face"] == "Face2"]
    [0.5]
    """
    path = info_location(document, folder)
    limit_faces(path, faces, person=person, part=part, **limits)
    return face_limits(path)


def keep_settings(document, folder="", **worked):
    """Keep the settings with which a part was meshed, where its document has an info file; see `keep_mesh_settings`.

    Examples
    --------
    >>> keep_settings(f"{samples}/never_classified.step")  # there is no info file to keep them in
    """
    path = info_location(document, folder)
    if os.path.isfile(path):
        keep_mesh_settings(path, **worked)


def settings_for(record, document, folder="", roots=(), report=None):
    """Mesh settings that worked for a part or for one like it; see `settings_that_worked`.

    The document is an empty text where it was never saved; roots that are not there are left out.

    Examples
    --------
    >>> settings_for(record, plate) is None  # none has worked so far
    True
    """
    return settings_that_worked(record, [root for root in roots if os.path.isdir(root)],
                                info_location(document, folder) if document else None, report)
