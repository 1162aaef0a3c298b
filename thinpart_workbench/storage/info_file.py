"""The info file of a document: complete, versioned, atomic, stable."""

import hashlib
import json
import os
from contextlib import contextmanager
from datetime import datetime, timezone
from pathlib import Path

from .. import __version__
from ..core.errors import ThinPartError
from ..system.file_paths import place_in_tree, relative_path
from .atomic_file import write_atomically
from .folder_lock import folder_lock
from .kept_content import carry_kept
from .regular_file import open_regular

FORMAT, VERSION = "thinpart-info", 1
SUFFIX = ".thinpart.json"
LARGEST = 256 * 1024 * 1024
"""Bytes beyond which a file is taken for something else than an info file."""

_ENCODE = json.JSONEncoder(ensure_ascii=False, allow_nan=False).encode

_LASTING = ("empty", "no_solid", "not_finite", "unreadable", "unsafe", "unsupported", "zero_volume")
"""Kinds of failures that an unchanged document has again; others may have passed by."""


def info_path(document, info_folder=None, root=None):
    """Where the info file of a document lies.

    Parameters
    ----------
    document : str or Path
    info_folder : str or Path, optional
        Folder that mirrors the tree of the documents; beside the document when left out.
    root : str or Path, optional
        Top of the tree that is mirrored; the document's own folder when left out.

    Returns
    -------
    Path
    """
    document = Path(document)
    name = document.name + SUFFIX
    if info_folder is None:
        return document.with_name(name)
    if root is None:
        return Path(info_folder) / name
    return Path(info_folder) / place_in_tree(document.parent, root) / name


def new_source(document, links=(), info_file=None):
    """The ``source`` entry: name, hash, size and time of a document as it is now.

    Parameters
    ----------
    document : str or Path
    links : list of Path, optional
        Other documents from which it takes shapes; those that are not there count as well.
    info_file : str or Path, optional
        Where the info file is going to lie; beside the document when left out.

    Raises
    ------
    ThinPartError
        kind ``missing``, ``permission``, ``unreadable``, or ``empty`` for a file of 0 bytes.
    """
    document = Path(document)
    state = _state(document)
    if state["bytes"] == 0:
        raise ThinPartError(f"{document.name} is empty (0 bytes).", "empty")
    source = {"file": document.name}
    folder = _folder_seen_from(info_file, document)
    if folder is not None:
        source["folder"] = folder
    source.update(state)
    if links:
        source["links"] = [_link(link, document) for link in links]
    return source


def _state(document):
    digest = hashlib.sha256()
    try:
        with open_regular(document) as file:
            status = os.fstat(file.fileno())
            for block in iter(lambda: file.read(1 << 20), b""):
                digest.update(block)
    except FileNotFoundError:
        raise ThinPartError(f"There is no file {os.fspath(document)}.", "missing") from None
    except PermissionError:
        raise ThinPartError(
            f"{document.name} may not be read: check its permissions.", "permission"
        ) from None
    except OSError as error:
        raise ThinPartError(
            f"{document.name} cannot be read ({error.strerror}).", "unreadable"
        ) from None
    return {"sha256": digest.hexdigest(), "bytes": status.st_size,
            "modified": _time(status.st_mtime)}


def _link(link, document):
    try:
        state = _state(link)
    except ThinPartError:
        state = {"sha256": None, "bytes": None, "modified": None}
    return {"file": relative_path(link, os.path.abspath(document.parent)), **state}


def _folder_seen_from(info_file, document):
    """The document's folder as seen from its info file's; None where they are the same."""
    if info_file is None:
        return None
    folder = relative_path(os.path.realpath(document.parent), os.path.realpath(Path(info_file).parent))
    return None if folder == os.curdir else folder


def source_is_unchanged(source, document):
    """Whether sizes and times of a document and its links are still those of its ``source``."""
    return all(_looks_unchanged(entry, path) for entry, path in _entries(source, document))


def _entries(source, document):
    """The document and all that it links into: what was recorded, and where that is now."""
    yield source, document
    for link in source.get("links", ()):
        yield link, os.path.join(os.path.dirname(os.path.abspath(document)), link["file"])


def _looks_unchanged(entry, path):
    try:
        status = os.stat(path)
    except OSError:
        return entry["bytes"] is None
    return entry["bytes"] == status.st_size and entry["modified"] == _time(status.st_mtime)


def _is_unchanged(entry, path):
    """As above, but where the time alone differs (a copied file), the hash decides."""
    if entry["bytes"] is None or not os.path.exists(path):
        return False  # a link that leads nowhere may lead somewhere by now
    if _looks_unchanged(entry, path):
        return True
    try:
        return os.stat(path).st_size == entry["bytes"] and (
            _state(Path(path))["sha256"] == entry["sha256"])
    except (OSError, ThinPartError):
        return False


def info_content(source, settings, profile, parts, failures=()):
    """Content of an info file.

    Parameters
    ----------
    source : dict
        From `new_source`.
    settings, profile : dict
    parts : list of dict
        Part records.
    failures : list of dict
        Parts of the document that could not be analysed.

    Returns
    -------
    dict
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "source": source,
        "software": {"name": "ThinPart", "version": __version__},
        "settings": settings,
        "profile": profile,
        "parts": parts,
        "failures": list(failures),
    }


def is_current(content, document, settings, profile, info_file=None):
    """Whether an info file still says all about its document that a new analysis would.

    Size and time decide, of the document and of those that it links into; where the time alone
    differs (a copied file), the hash does.

    Parameters
    ----------
    content : dict
        From `read_info`.
    document : str or Path
    settings, profile : dict
        What a new analysis would have.
    info_file : str or Path, optional
        Where the info file lies; beside the document when left out.
    """
    if content["settings"] != settings or content["profile"] != profile:
        return False
    if content["software"].get("version") != __version__:
        return False
    if any(each.get("kind") not in _LASTING for each in content.get("failures", ())):
        return False
    source = content["source"]
    if source.get("folder") != _folder_seen_from(info_file, Path(document)):
        return False
    return all(_is_unchanged(entry, path) for entry, path in _entries(source, document))


def read_info(path):
    """Read and check an info file.

    Raises
    ------
    ThinPartError
        kind ``info_file``.
    """
    path = Path(path)
    try:
        with open_regular(path) as file:
            return read_open_info(file, path.name)
    except OSError as error:
        raise ThinPartError(f"The info file {path.name} cannot be read ({error.strerror}).",
                            "info_file") from None


def read_open_info(file, name):
    """As `read_info`, from a file that is open.

    Parameters
    ----------
    file : binary file
    name : str
        For what is said.

    Raises
    ------
    ThinPartError
    OSError
    """
    if os.fstat(file.fileno()).st_size > LARGEST:
        raise ThinPartError(f"{name} is too large for an info file.", "info_file")
    try:
        content = json.loads(file.read(LARGEST + 1))
    except (ValueError, RecursionError) as error:
        raise ThinPartError(f"The info file {name} cannot be read ({error}).", "info_file") from None
    if not isinstance(content, dict) or content.get("format") != FORMAT:
        raise ThinPartError(f"{name} is not a ThinPart info file.", "info_file")
    if content.get("version") != VERSION:
        raise ThinPartError(
            f"{name} has version {content.get('version')!r}; this ThinPart reads version "
            f"{VERSION}: use a newer one.", "info_file",
        )
    missing = [key for key in ("source", "settings", "profile", "parts", "software")
               if key not in content]
    if missing:
        raise ThinPartError(f"The info file {name} lacks {', '.join(missing)}.", "info_file")
    return content


def stored_info(path):
    """What an info file says so far; None where there is none, or nothing that can be used.

    What is no info file is not lost by that: `write_info` refuses to overwrite it.
    """
    if not os.path.lexists(path):
        return None
    try:
        return read_info(path)
    except ThinPartError:
        return None


def write_info(path, content):
    """Write an info file atomically; what people keep with its parts is carried over.

    Parameters
    ----------
    path : str or Path
    content : dict
        From `info_content`. Takes what was kept from the file that is there.

    Raises
    ------
    ThinPartError
        kind ``info_write``. Nothing half-written is left. A file that is no info file of a version
        that is understood is not overwritten, nor is that of another document, still there, which
        has the same name (two calls with one info folder).
    """
    path = Path(path)
    with _writing(path):
        path.parent.mkdir(parents=True, exist_ok=True)
        # Under the lock: a note that was written while the document was measured is there by now.
        with folder_lock(path.parent):
            if os.path.lexists(path):
                there = _refuse_foreign(path)
                _refuse_another(path, there, content)
                carry_kept(content, there)
            write_atomically(path, dumps(content))


def change_info(path, change):
    """Change an info file atomically, with no other program writing it meanwhile.

    Parameters
    ----------
    path : str or Path
    change : callable
        Is given the content and changes it in place; returns whether it did.

    Returns
    -------
    dict
        The content as it is now.

    Raises
    ------
    ThinPartError
        kind ``info_file`` or ``info_write``.
    """
    path = Path(path)
    with _writing(path), folder_lock(path.parent):
        content = read_info(path)
        if change(content):
            write_atomically(path, dumps(content))
    return content


@contextmanager
def _writing(path):
    try:
        yield
    except OSError as error:
        raise ThinPartError(
            f"The info file {path} could not be written ({error.strerror}): "
            "make room or choose another place for it.", "info_write",
        ) from None


def dumps(content):
    """The bytes of an info file: UTF-8, keys in their order, a line each, lists of numbers on one line."""
    text = "".join(_lines(content, "\n")) + "\n"
    # Bytes of a file name that are no text become JSON escapes.
    return text.encode("utf-8", "backslashreplace")


def _lines(value, line):
    """Pieces of JSON text; `line` is a line break and the indentation."""
    inner = line + " "
    if isinstance(value, dict) and value:
        separator = "{"
        for key, each in value.items():
            yield f"{separator}{inner}{_ENCODE(key)}: "
            yield from _lines(each, inner)
            separator = ","
        yield line + "}"
    elif isinstance(value, list) and any(isinstance(each, (dict, list)) for each in value):
        separator = "["
        for each in value:
            yield separator + inner
            yield from _lines(each, inner)
            separator = ","
        yield line + "]"
    else:
        yield _ENCODE(value)


def _refuse_foreign(path):
    try:
        return read_info(path)
    except ThinPartError as error:
        raise ThinPartError(
            f"{error} It was left as it is: move it away to have it written anew.", "info_write"
        ) from None


def _refuse_another(path, there, content):
    theirs, ours = _document_of(path, there), _document_of(path, content)
    try:
        another = not os.path.samefile(theirs, ours)
    except OSError:
        return  # the other one is gone: moved, most likely, and this is where it is now
    if another:
        raise ThinPartError(
            f"The info file {path} belongs to {theirs} and was left as it is: choose another "
            f"folder for the info file of {ours}.", "info_write",
        )


def _document_of(path, content):
    source = content["source"]
    folder = os.path.join(os.path.realpath(path.parent), source.get("folder", ""))
    return os.path.normpath(os.path.join(folder, source["file"]))


def _time(seconds):
    return datetime.fromtimestamp(seconds, timezone.utc).isoformat(timespec="microseconds")
