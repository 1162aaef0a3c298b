"""Notes, mesh settings and links of a part: read and set in its info file."""

import json
import os
from pathlib import Path

from ..core.errors import ThinPartError
from ..storage.info_file import SUFFIX, change_info, info_path, read_info
from ..storage.kept_content import set_kept

LARGEST_SETTINGS = 1024 * 1024
"""Bytes of mesh settings that are taken into an info file; a larger file is kept by its name."""


def info_file_of(path, info_folder=None):
    """The info file of a document, or the info file itself.

    Raises
    ------
    ThinPartError
        kind ``missing`` where the document was not classified yet.
    """
    path = Path(path)
    info = path if path.name.endswith(SUFFIX) else info_path(path, info_folder)
    if not info.is_file():
        raise ThinPartError(
            f"There is no info file {info}: classify {path.name} first, or name the folder of its info file "
            "with --info-dir.", "missing",
        )
    return info


def stored_records(path, part=None, info_folder=None):
    """Records of a document from its info file: all of them, or that of one part.

    Parameters
    ----------
    path : str or Path
        Document or info file.
    part : str, optional
        Name or label.

    Returns
    -------
    list of dict
    """
    return _chosen(read_info(info_file_of(path, info_folder))["parts"], part, path)


def the_record(path, part=None, info_folder=None):
    """As `stored_records`, the one record that is meant.

    Raises
    ------
    ThinPartError
        kind ``usage`` where the document has several parts and none was named.
    """
    return one_of(read_info(info_file_of(path, info_folder))["parts"], part, path)


def keep_with_part(path, part=None, info_folder=None, **values):
    """Set what is kept with a part; see `storage.kept_content.set_kept`.

    Parameters
    ----------
    path : str or Path
        Document or info file.
    part : str, optional
        Name or label; may be left out where there is only one.
    info_folder : str or Path, optional
    values
        ``notes``, ``mesh``, ``link``.

    Returns
    -------
    dict
        The part's record.

    Raises
    ------
    ThinPartError
        kind ``usage`` where it is not clear which part is meant.
    """
    def change(content):
        return set_kept(one_of(content["parts"], part, path), **values)

    return one_of(change_info(info_file_of(path, info_folder), change)["parts"], part, path)


def mesh_settings(text):
    """What a person gave as mesh settings.

    Parameters
    ----------
    text : str
        A JSON object, the name of a JSON file with one, or the name of any other file; empty removes.

    Returns
    -------
    dict
        ``{"settings": object}``, ``{"file": path}``, or empty.
    """
    if not text.strip():
        return {}
    if text.lstrip().startswith("{"):
        return {"settings": _settings(text, "The mesh settings")}
    file = Path(text)
    if not file.is_file():
        raise ThinPartError(f"There is no file {text}: --mesh takes a JSON object or a file.", "missing")
    if file.suffix.lower() == ".json" and file.stat().st_size <= LARGEST_SETTINGS:
        try:
            return {"settings": _settings(file.read_text(encoding="utf-8"), f"The file {text}")}
        except (OSError, UnicodeDecodeError) as error:
            raise ThinPartError(f"The file {text} cannot be read ({error}).", "unreadable") from None
    return {"file": os.path.abspath(file)}


def _settings(text, what):
    try:
        content = json.loads(text, parse_constant=_refuse)
    except (ValueError, RecursionError) as error:
        raise ThinPartError(f"{what} is no JSON object ({error}).", "usage") from None
    if not isinstance(content, dict):
        raise ThinPartError(f"{what} is no JSON object.", "usage")
    return content


def _refuse(constant):
    raise ValueError(f"{constant} is no number of JSON")


def one_of(records, part, path):
    """The one of a document's records that has a name or label, or the only one.

    Parameters
    ----------
    records : list of dict
    part : str or None
    path : str or Path
        Of the document, for what is said.

    Raises
    ------
    ThinPartError
        kind ``usage``.
    """
    chosen = _chosen(records, part, path)
    if len(chosen) > 1:
        raise ThinPartError(
            f"{Path(path).name} holds {len(chosen)} parts: say which one is meant with --part, by name or "
            f"label: {_names(chosen)}.", "usage",
        )
    return chosen[0]


def _chosen(records, part, path):
    if part is None:
        return records
    chosen = [each for each in records if each["name"] == part] or [
        each for each in records if each["label"] == part]
    if not chosen:
        raise ThinPartError(f"{Path(path).name} has no part {part!r}: it has {_names(records)}.", "usage")
    return chosen


def _names(records):
    return ", ".join(each["name"] for each in records)
