# SPDX-License-Identifier: LGPL-2.1-or-later
"""Records of parts as info files hold them: found by document, name or label."""

import os
import stat
from pathlib import Path

from ...core.errors import ThinPartError
from ...core.message import message
from .info_file import SUFFIX, info_path
from .info_reading import read_info


def info_file_of(path, info_folder=None):
    """The info file of a document, or the info file itself.

    Raises ThinPartError, kind ``missing`` if the document has not been classified yet, ``info_file`` if the system cannot
    say.
    """
    path = Path(path)
    info = path if path.name.endswith(SUFFIX) else info_path(path, info_folder)
    if not _is_file(info):
        raise ThinPartError(
            message("There is no info file {info_file}: classify {file} first, or name the folder of its info file "
                    "with --info-dir.", info_file=info, file=path.name or path), "missing",
        )
    return info


def _is_file(info):
    try:
        return stat.S_ISREG(os.stat(info).st_mode)
    except (FileNotFoundError, NotADirectoryError):
        return False
    except OSError as error:
        raise ThinPartError(message("The info file {info_file} cannot be read ({problem}).",
                                    info_file=info.name, problem=error.strerror), "info_file") from None


def stored_records(path, part=None, info_folder=None):
    """Records of a document from its info file: all of them, or that of one part, list of PartRecord.

    Parameters
    ----------
    path : str or Path
        Document or info file.
    part : str, optional
        Name or label.
    """
    return _matching(read_info(info_file_of(path, info_folder))["parts"], part, path)


def single_record(path, part=None):
    """As `stored_records`, but exactly one record.

    Raises ThinPartError, kind ``usage`` if the document has several parts and `part` is None.
    """
    return select_record(read_info(info_file_of(path))["parts"], part, path)


def select_record(records, part, path):
    """The record with a name or label, or the only record of a document; raises ThinPartError of kind ``usage``.

    Parameters
    ----------
    records : list of PartRecord
    part : str or None
    path : str or Path
        Path of the document, for messages.
    """
    matching = _matching(records, part, path)
    if len(matching) > 1:
        raise ThinPartError(
            message("{file} holds {count} parts: choose one with --part, by name or label: {parts}.",
                    file=Path(path).name, count=len(matching), parts=_names(matching)), "usage",
        )
    return matching[0]


def _matching(records, part, path):
    if part is None:
        return records
    matching = [record for record in records if record["name"] == part] or [
        record for record in records if record["label"] == part]
    if not matching:
        raise ThinPartError(message("{file} has no part {part!r}: it has {parts}.",
                                    file=Path(path).name, part=part, parts=_names(records)), "usage")
    return matching


def _names(records):
    return ", ".join(record["name"] for record in records)
