# SPDX-License-Identifier: LGPL-2.1-or-later
"""The definition of an info file: readers check files against it, and the JSON schema is generated from it.

    python3 -m thinpart_workbench.storage.info.info_definition > resources/info-file.schema.json
"""

import json
from typing import Annotated, Any, Optional, TypedDict

from ...core.kinds.file_marks import INFO
from ...core.kinds.key_presence import NotRequired, Required
from ...core.kinds.typed_kinds import LATER, Restricted, kind_of
from ...core.kinds.value_kinds import OneOf, Text
from ...core.record.record_types import (
    Annotations,
    FailureRecord,
    Notes,
    PartRecord,
    ProfileContent,
    SettingsRecord,
    Time,
)

VERSION = 1

Path = Annotated[str, Text(10_000, r"[^\x00]*", "a file name")]
Sha256 = Annotated[str, Text(64, "[0-9a-f]{64}", "64 digits of a hash")]


class LinkRecord(TypedDict):
    """Another document from which a document takes shapes; None for what was not there."""

    file: Annotated[Path, Restricted(about="path as seen from the document's folder")]
    sha256: Optional[Sha256]
    bytes: Optional[int]
    modified: Optional[Time]


class SourceRecord(TypedDict):
    """A document: name, hash, size and time."""

    file: Path
    sha256: Sha256
    bytes: int
    modified: Time
    folder: NotRequired[Annotated[Path, Restricted(
        meaning="a folder", about="the document's folder as seen from the info file's, where they differ")]]
    links: NotRequired[Annotated[list[LinkRecord], Restricted(
        least=1, most=100_000, about="other documents from which the document takes shapes; null for what was not there")]]


class SoftwareRecord(TypedDict):
    """The program that wrote a file."""

    name: Annotated[str, OneOf(("ThinPart",))]
    version: str


class MessageRecord(TypedDict):
    """What a sentence is made of; see `core/message`."""

    template: str
    fields: dict[str, Any]


class OrphanRecord(Annotations, total=False):
    """What was kept with a part that the document no longer has."""

    name: Required[str]
    label: str
    notes: Notes


class InfoFile(TypedDict):
    """The content of an info file of this version."""

    format: Annotated[str, OneOf((INFO.format,))]
    version: Annotated[int, OneOf((VERSION,))]
    source: SourceRecord
    software: SoftwareRecord
    settings: SettingsRecord
    profile: ProfileContent
    parts: Annotated[list[PartRecord], Restricted(least=1, most=1_000_000, distinct="name")]
    messages: NotRequired[Annotated[list[MessageRecord], Restricted(
        least=1, most=1_000_000, about="what sentences above are made of, to say them in other languages")]]
    kept_of_missing_parts: NotRequired[Annotated[list[OrphanRecord], Restricted(
        about="what was kept with parts that the document no longer has")]]
    failures: NotRequired[Annotated[list[FailureRecord], Restricted(most=1_000_000), LATER]]


HASH = kind_of(Sha256)
SOURCE = kind_of(SourceRecord)
INFO_FILE = kind_of(InfoFile)

_ABOUT = ("Lengths in mm, areas in mm2, volumes in mm3, angles in degrees; x is a distance divided by the diagonal "
          "of the part's box.")


def json_schema():
    """JSON schema of the files that are written; a reader accepts further keys, and files without the newer keys."""
    return {"$schema": "http://json-schema.org/draft-07/schema#",
            "title": f"ThinPart info file, version {VERSION}", "description": _ABOUT, **INFO_FILE.schema()}


if __name__ == "__main__":
    print(json.dumps(json_schema(), indent=1))
