# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading and checking info files. All readers use this module and need not check the content again."""

import os
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.kinds.file_marks import INFO
from ...core.kinds.json_file import UnreadableJson, parsed_json
from ...core.kinds.value_kinds import is_plain, shown
from ...core.message import message, restored
from ...core.regular_file import open_regular
from .info_definition import INFO_FILE, VERSION

LARGEST = 256 * 1024 * 1024
"""Size in bytes above which a file is not accepted as an info file."""


class DamagedInfoFile(ThinPartError):
    """An info file of this version that violates `INFO_FILE`. It may contain notes, so nothing overwrites it."""

    kind = "info_file"


def read_info(path):
    """Read and check an info file; raises ThinPartError of kind ``info_file``.

    Returns a dict: matches `info_definition.INFO_FILE`: callers need not check it again. Sentences whose template the file
    contains are Message objects.
    """
    path = Path(path)
    try:
        with open_regular(path) as file:
            return read_open_info(file, path.name)
    except OSError as error:
        raise ThinPartError(message("The info file {info_file} cannot be read ({problem}).",
                                    info_file=path.name, problem=error.strerror),
                            "info_file") from None


def read_open_info(file, name):
    """As `read_info`, from an open file. Raises ThinPartError or OSError.

    Parameters
    ----------
    file : binary file
    name : str
        Name of the file for messages.
    """
    size = os.fstat(file.fileno()).st_size
    if size > LARGEST:
        raise ThinPartError(message("{info_file} is too large for an info file.", info_file=name), "info_file")
    data = file.read(size + 1)  # without a limit, a growing file could fill the memory
    content = _parsed(data, name)
    if not INFO.is_of(content):
        raise ThinPartError(message("{info_file} is not a ThinPart info file.", info_file=name), "info_file")
    if content.get("version") != VERSION:
        raise ThinPartError(
            message("{info_file} has version {version}; this ThinPart reads version {known}: use a newer one.",
                    info_file=name, version=shown(content.get("version")), known=VERSION), "info_file",
        )
    fault = fault_of(content, is_plain(data))
    if fault is not None:
        raise DamagedInfoFile(
            message("The info file {info_file} is damaged ({problem}): move it away and classify its document again.",
                    info_file=name, problem=fault))
    return restored(content)


def fault_of(content, plain=False):
    """The first reason why content is not that of an info file: str or None.

    Such as "parts[0].label is 7, not a text that can be written".

    Parameters
    ----------
    content
        Parsed JSON.
    plain : bool
        `is_plain` of the bytes that it was parsed from.
    """
    return None if plain and INFO_FILE.holds_plain(content) else INFO_FILE.fault(content, "")


def _parsed(data, name):
    try:
        return parsed_json(data)
    except UnreadableJson as problem:
        raise ThinPartError(message("The info file {info_file} cannot be read ({problem}).",
                                    info_file=name, problem=str(problem)), "info_file") from None
