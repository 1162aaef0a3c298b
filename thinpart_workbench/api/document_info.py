"""Write the info file of a document whose parts were measured while it was open."""

import os
from dataclasses import dataclass
from typing import Optional

from ..core.errors import ThinPartError
from ..core.judging.criteria import given_profile
from ..core.message import message
from ..core.record.record_types import PersonLabel
from ..freecad_adapter.reading.linked_files import linked_files
from ..storage.info.info_file import info_content, new_source, stored_info, write_info
from ..storage.info.info_location import PATIENCE, call_in_folder, info_location
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
    """Write an info file.

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
    settings : AnalysisSettings
        Those with which they were measured.
    folder : str, optional
        See `info_location`.
    patience : float, optional
        Seconds to wait for the folder, which may be on another computer.

    Returns
    -------
    WrittenInfo

    Raises
    ------
    ThinPartError
        kind ``unreadable`` if the document was written again since, ``info_write`` if the folder does not answer or
        holds a file of that name that is no info file.
    """
    path, profile = info_location(document, folder), given_profile(profile).content
    stored = call_in_folder(folder, lambda: stored_info(path), patience)
    source = new_source(document, linked_files(document), path)
    if file_stamp(document) != stamp:
        raise ThinPartError(
            message("{file} was saved again meanwhile: classify it again.",
                    file=os.path.basename(document)), "unreadable")
    content = info_content(source, settings.content(), profile, records, failures)
    call_in_folder(folder, lambda: write_info(path, content), patience)
    return WrittenInfo(
        os.fspath(path), stored and document_verdicts(stored["parts"], stored["profile"]),
        document_verdicts(records, profile),
        {record["name"]: record["labels"] for record in content["parts"] if record.get("labels")})


def file_stamp(path):
    """Size and time of a file, to detect whether it has been written again: list of int."""
    status = os.stat(path)
    return [status.st_size, status.st_mtime_ns]
