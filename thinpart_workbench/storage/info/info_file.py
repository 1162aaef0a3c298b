# SPDX-License-Identifier: LGPL-2.1-or-later
"""The info file of a document: complete, versioned, atomic, stable."""

import hashlib
import json
import os
from contextlib import contextmanager
from datetime import datetime, timezone
from functools import lru_cache
from pathlib import Path

from ... import __version__
from ...core.errors import ThinPartError
from ...core.file_formats import INFO_ENDING
from ...core.judging.older_record import is_enough
from ...core.kinds.file_marks import INFO
from ...core.message import message, with_messages
from ...core.regular_file import open_regular
from ...system.file_paths import path_in_tree, relative_path
from ..atomic_file import FileAccess, write_atomically
from ..fcstd_file import is_fcstd
from ..folder_lock import FolderIsLocked, folder_lock
from .annotations import carry_annotations
from .info_definition import VERSION
from .info_reading import DamagedInfoFile, fault_of, read_info

SUFFIX = INFO_ENDING

_ENCODE = json.JSONEncoder(ensure_ascii=False, allow_nan=False).encode

_PERMANENT = ("empty", "no_solid", "not_finite", "unreadable", "unsafe", "unsupported", "zero_volume")
"""Kinds of failures that recur for an unchanged document; others may be temporary."""


def info_path(document, info_folder=None, root=None):
    """The path of the info file of a document: Path.

    Parameters
    ----------
    document : str or Path
    info_folder : str or Path, optional
        Folder that mirrors the tree of the documents; by default the file lies beside the document.
    root : str or Path, optional
        Top of the tree that is mirrored; the document's own folder by default.
    """
    document = Path(document)
    name = document.name + SUFFIX
    if info_folder is None:
        return document.parent / name
    if root is None:
        return Path(info_folder) / name
    return Path(info_folder) / path_in_tree(document.parent, root) / name


def info_path_getter(folder=None, tree=None):
    """A function that maps documents to their info files; see `info_path`.

    Returns a callable: maps path to path. It caches the work per folder, since a folder may contain many thousands of
    documents.
    """
    @lru_cache(maxsize=1024)
    def folder_prefix(parent):
        return os.path.join(info_path(os.path.join(parent, "x"), folder, tree).parent, "")

    def get_info_path(document):
        parent, name = os.path.split(document)
        return folder_prefix(parent) + name + SUFFIX

    return get_info_path


def new_source(document, links=(), info_file=None):
    """The ``source`` entry: name, hash, size and time of a document in its current state.

    Raises ThinPartError, kind ``missing``, ``permission``, ``unreadable``, or ``empty`` for a file of 0 bytes.

    Parameters
    ----------
    document : str or Path
    links : list of Path, optional
        Other documents from which it takes shapes, missing ones included.
    info_file : str or Path, optional
        Path of the info file to be written; beside the document by default.
    """
    document = Path(document)
    fingerprint = _fingerprint(document)
    if fingerprint["bytes"] == 0:
        raise ThinPartError(message("{file} is empty (0 bytes).", file=document.name), "empty")
    source = {"file": document.name}
    folder = _relative_folder(info_file, document)
    if folder is not None:
        source["folder"] = folder
    source.update(fingerprint)
    if links:
        source["links"] = [_link(link, document) for link in links]
    return source


def _fingerprint(document, is_accepted=None):
    digest = hashlib.sha256()
    try:
        with open_regular(document) as file:
            status = os.fstat(file.fileno())
            if is_accepted is not None and not is_accepted(file):
                raise ThinPartError(message("{file} is not a FreeCAD document.", file=document.name), "unsupported")
            file.seek(0)
            for block in iter(lambda: file.read(1 << 20), b""):
                digest.update(block)
    except FileNotFoundError:
        raise ThinPartError(message("There is no file {file}.", file=os.fspath(document)), "missing") from None
    except PermissionError:
        raise ThinPartError(
            message("There is no permission to read {file}: check its permissions.", file=document.name), "permission"
        ) from None
    except OSError as error:
        raise ThinPartError(
            message("{file} cannot be read ({problem}).", file=document.name, problem=error.strerror), "unreadable"
        ) from None
    return {"sha256": digest.hexdigest(), "bytes": status.st_size,
            "modified": _iso_time(status.st_mtime)}


def _link(link, document):
    # A document may link to any file: do not disclose even the hash of a file that is no FreeCAD document.
    try:
        fingerprint = _fingerprint(link, is_fcstd)
    except ThinPartError:
        fingerprint = {"sha256": None, "bytes": None, "modified": None}
    return {"file": relative_path(link, os.path.abspath(document.parent)), **fingerprint}


def _relative_folder(info_file, document):
    """The document's folder relative to that of its info file; None if they are the same."""
    if info_file is None:
        return None
    folder = relative_path(os.path.realpath(document.parent), os.path.realpath(Path(info_file).parent))
    return None if folder == os.curdir else folder


def sha256_of(document):
    """The hash of the bytes of a document: str; raises as `new_source`."""
    return _fingerprint(Path(document))["sha256"]


def source_is_unchanged(source, document):
    """Whether sizes and times of a document and its links still match its ``source``."""
    return all(_looks_unchanged(entry, path) for entry, path in _entries(source, document))


def _entries(source, document):
    """The recorded entry and the path of the document and of each document that it links to."""
    yield source, document
    for link in source.get("links", ()):
        yield link, os.path.join(os.path.dirname(os.path.abspath(document)), link["file"])


def _looks_unchanged(entry, path):
    if entry["bytes"] is None:
        return not _is_document(path)
    try:
        status = os.stat(path)
    except OSError:
        return False
    return entry["bytes"] == status.st_size and entry["modified"] == _iso_time(status.st_mtime)


def _is_document(path):
    try:
        with open_regular(path) as file:
            return is_fcstd(file)
    except OSError:
        return False


def _is_unchanged(entry, path):
    """As `_looks_unchanged`, but if only the time differs (a copied file), the hash decides."""
    if not os.path.exists(path):
        return False  # a link that was broken may lead to a file now
    if _looks_unchanged(entry, path):
        return True
    try:
        return os.stat(path).st_size == entry["bytes"] and (
            _fingerprint(Path(path))["sha256"] == entry["sha256"])
    except (OSError, ThinPartError):
        return False


def info_content(source, settings, profile, parts, failures=()):
    """Content of an info file: dict.

    Parameters
    ----------
    source : dict
        From `new_source`.
    settings, profile : dict
    parts : list of PartRecord
    failures : list of FailureRecord
        Parts of the document that could not be analysed.
    """
    return {
        "format": INFO.format,
        "version": VERSION,
        "source": source,
        "software": {"name": "ThinPart", "version": __version__},
        "settings": settings,
        "profile": profile,
        "parts": parts,
        "failures": list(failures),
    }


def is_current(content, document, settings, profile, info_file=None):
    """Whether a new analysis would give the same as an info file.

    Size and time of the document and of those that it links to decide; if only the time differs
    (a copied file), the hash decides. Where an earlier version measured the parts, and they were judged again since, the
    verdict has to be certain without what it did not measure.

    Parameters
    ----------
    content : dict
        From `read_info`.
    document : str or Path
    settings, profile : dict
        Those of the new analysis.
    info_file : str or Path, optional
        Path of the info file; beside the document by default.
    """
    source = content["source"]
    if source.get("folder") != _relative_folder(info_file, Path(document)) or not is_as_measured(content, settings, profile):
        return False
    return all(_is_unchanged(entry, path) for entry, path in _entries(source, document))


def is_as_measured(content, settings, profile):
    """Whether a new analysis of the same bytes would give the same as an info file; parameters as of `is_current`."""
    if content["settings"] != settings or content["profile"] != profile:
        return False
    if content["software"].get("version") != __version__:
        return False
    if any(failure.get("kind") not in _PERMANENT for failure in content.get("failures", ())):
        return False
    return all(is_enough(part, profile) for part in content["parts"])


def stored_info(path):
    """The content of an info file; None if there is none, or if it cannot be used.

    A file that is not an info file is not lost: `write_info` refuses to overwrite it.
    """
    if not os.path.lexists(path):
        return None
    try:
        return read_info(path)
    except ThinPartError:
        return None


def write_info(path, content, beside=None):
    """Write an info file atomically; annotations of its parts are carried over.

    Raises ThinPartError, kind ``info_write``. No partial file is left, and no content is written that could not be read
    again. A damaged info file, one of an unknown version, and a file that is no info file are not overwritten, nor is that
    of another existing document of the same name (two calls with one info folder).

    Parameters
    ----------
    path : str or Path
    content : dict
        From `info_content`. Receives the annotations of the existing file.
    beside : str, optional
        The document, if it is in the same folder: see `write_atomically`.
    """
    path = Path(path)
    with _writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        # Read under the lock: a note may have been added while the document was measured.
        with folder_lock(path.parent):
            if os.path.lexists(path):
                existing = _read_existing(path)
                _check_same_document(path, existing, content)
                carry_annotations(content, existing)
            write_atomically(path, _checked_bytes(path, content), beside=beside, access=_access(path, content))


def change_info(path, change):
    """Change an info file atomically; no other program can write it meanwhile.

    Returns a dict: the current content. Raises ThinPartError, kind ``info_file`` or ``info_write``.

    Parameters
    ----------
    path : str or Path
    change : callable
        Receives the content, changes it in place and returns whether it did.
    """
    path = Path(path)
    with _writing(path), folder_lock(path.parent):
        content = read_info(path)
        if change(content):
            write_atomically(path, _checked_bytes(path, content), access=_access(path, content))
    return content


def _access(path, content):
    """The access that all documents have of which an info file tells."""
    return FileAccess.of(each for _, each in _entries(content["source"], _document_of(path, content)))


@contextmanager
def _writing(path):
    try:
        yield
    except FolderIsLocked:
        raise ThinPartError(
            message("The info file {info_file} could not be written: another program keeps the folder {folder} locked; end "
                    "that program, or choose another place for info files.", info_file=path.name, folder=path.parent),
            "info_write") from None
    except OSError as error:
        raise ThinPartError(
            message("The info file {info_file} could not be written ({problem}): make room or choose another place "
                    "for it.", info_file=path, problem=error.strerror), "info_write",
        ) from None


def _checked_bytes(path, content):
    content = with_messages(content)
    fault = fault_of(content)
    if fault is not None:
        raise ThinPartError(message("The info file {info_file} was not written: {problem}.",
                                    info_file=path, problem=fault), "info_write")
    return dumps(content)


def dumps(content):
    """The bytes of an info file: UTF-8, keys in their order, one per line, lists of numbers on one line."""
    text = "".join(_lines(content, "\n")) + "\n"
    # Bytes of a file name that are not valid text become JSON escapes.
    return text.encode("utf-8", "backslashreplace")


def _lines(value, line):
    """Yield pieces of JSON text; `line` is a line break and the indentation."""
    inner = line + " "
    if isinstance(value, dict) and value:
        separator = "{"
        for key, item in value.items():
            yield f"{separator}{inner}{_ENCODE(key)}: "
            yield from _lines(item, inner)
            separator = ","
        yield line + "}"
    elif isinstance(value, list) and any(isinstance(item, (dict, list)) for item in value):
        separator = "["
        for item in value:
            yield separator + inner
            yield from _lines(item, inner)
            separator = ","
        yield line + "]"
    else:
        yield _ENCODE(value)


def _read_existing(path):
    try:
        return read_info(path)
    except DamagedInfoFile as error:
        raise ThinPartError(message("{sentence} It was not changed.", sentence=error), "info_write") from None
    except ThinPartError as error:
        raise ThinPartError(
            message("{sentence} It was not changed: move it away to have a new one written.",
                    sentence=error), "info_write"
        ) from None


def _check_same_document(path, existing, content):
    theirs, ours = _document_of(path, existing), _document_of(path, content)
    try:
        is_another = not os.path.samefile(theirs, ours)
    except OSError:
        return  # the other document is gone: most likely it was moved here
    if is_another:
        raise ThinPartError(
            message("The info file {info_file} belongs to {other} and was not changed: choose another folder for the "
                    "info file of {own}.", info_file=path, other=theirs, own=ours), "info_write",
        )


def _document_of(path, content):
    source = content["source"]
    folder = os.path.join(os.path.realpath(path.parent), source.get("folder", ""))
    return os.path.normpath(os.path.join(folder, source["file"]))


def _iso_time(seconds):
    return datetime.fromtimestamp(seconds, timezone.utc).isoformat(timespec="microseconds")
