"""The definition of an info file: readers check files against it, and the JSON schema is generated from it.

    python3 -m thinpart_workbench.storage.info.info_definition > resources/info-file.schema.json
"""

import json

from ...core.kinds.compound_kinds import ListOf, Record
from ...core.kinds.value_kinds import OneOf, OrNull, Text, Whole
from ...core.message import MESSAGES_KEY
from ...core.record.part_definition import ANNOTATIONS, FAILURE, PART, PROFILE, SETTINGS, TIME
from .annotations import ORPHANS

FORMAT, VERSION = "thinpart-info", 1

_PATH = Text(10_000, r"[^\x00]*", "a file name")
_SHA256 = Text(64, "[0-9a-f]{64}", "64 digits of a hash")
_BYTES = Whole()

_LINK = Record({
    "file": Text(10_000, r"[^\x00]*", "a file name", about="path as seen from the document's folder"),
    "sha256": OrNull(_SHA256),
    "bytes": OrNull(_BYTES),
    "modified": OrNull(TIME),
})

SOURCE = Record({"file": _PATH, "sha256": _SHA256, "bytes": _BYTES, "modified": TIME}, {
    "folder": Text(10_000, r"[^\x00]*", "a folder",
                   about="the document's folder as seen from the info file's, where they differ"),
    "links": ListOf(_LINK, 1, 100_000, about="other documents from which the document takes shapes; null for "
                    "what was not there"),
})

INFO_FILE = Record(
    {
        "format": OneOf((FORMAT,)),
        "version": OneOf((VERSION,)),
        "source": SOURCE,
        "software": Record({"name": OneOf(("ThinPart",)), "version": Text()}),
        "settings": SETTINGS,
        "profile": PROFILE,
        "parts": ListOf(PART, 1, 1_000_000, distinct="name"),
    },
    {MESSAGES_KEY: ListOf(Record({"template": Text(), "fields": Record({}, is_open=True)}), 1, 1_000_000,
                  about="what sentences above are made of, to say them in other languages"),
     ORPHANS: ListOf(Record({"name": Text()}, {"label": Text(), **ANNOTATIONS}),
                     about="what was kept with parts that the document no longer has")},
    later={"failures": ListOf(FAILURE, most=1_000_000)})
"""The definition of an info file of this version."""

_ABOUT = ("Lengths in mm, areas in mm2, volumes in mm3, angles in degrees; x is a distance divided by the diagonal "
          "of the part's box.")


def json_schema():
    """JSON schema of the files that are written; a reader accepts further keys, and files without the newer keys."""
    return {"$schema": "http://json-schema.org/draft-07/schema#",
            "title": f"ThinPart info file, version {VERSION}", "description": _ABOUT, **INFO_FILE.schema()}


if __name__ == "__main__":
    print(json.dumps(json_schema(), indent=1))
