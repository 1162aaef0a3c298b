# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a document of the same bytes was measured, so that copies of it are not measured again.

The cache holds, by the hash of a document, the path of its info file, whose content is then the proof. Only the bytes of
whole documents are compared: a reader that a document has taken over could claim anything else of another one's solids.
"""

import json
import os
import re
from contextlib import suppress

from ...core.errors import ThinPartError
from ...core.kinds.json_file import UnreadableJson, read_json
from ..cache_folder import cache_folder, write_cached
from .annotations import ANNOTATION_KEYS
from .info_file import is_as_measured, sha256_of, stored_info

_LARGEST = 1 << 16


def keep_measured(document, source, info_file):
    """Remember where a document was measured; a full disk only costs time later.

    Parameters
    ----------
    document : str
        Its bytes are hashed here, whatever the process that has read it says.
    source : dict
        The ``source`` of its info file.
    info_file : str
    """
    with suppress(OSError, ThinPartError):
        if "links" not in source and sha256_of(document) == source["sha256"]:
            write_cached(_path(source["sha256"]), json.dumps({"info_file": os.path.abspath(info_file)}).encode())


def copied_records(source, settings, profile):
    """The part records of a document of the same bytes, as a new analysis would make them, without what people noted.

    Returns a dict by name, None where there is none.

    Parameters
    ----------
    source : dict
        As `new_source` makes it.
    settings, profile : dict
        Those of the analysis.
    """
    if "links" in source or not re.fullmatch("[0-9a-f]{64}", source["sha256"]):
        return None
    try:
        info_file = read_json(_path(source["sha256"]), _LARGEST)["info_file"]
    except (OSError, UnreadableJson, KeyError, TypeError):
        return None
    content = stored_info(info_file) if isinstance(info_file, str) else None
    if content is None or content["source"]["sha256"] != source["sha256"] or "links" in content["source"]:
        return None
    if content.get("failures") or not is_as_measured(content, settings, profile):
        return None
    return {part["name"]: {key: "" if key == "notes" else value for key, value in part.items()
                           if key == "notes" or key not in ANNOTATION_KEYS} for part in content["parts"]}


def _path(sha256):
    return cache_folder() / "measured" / sha256[:2] / f"{sha256}.json"
