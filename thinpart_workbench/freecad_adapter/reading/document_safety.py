# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check a FreeCAD document for harmful side effects before FreeCAD opens it.

FreeCAD writes a document's embedded files to the paths given in the document, and imports the Python modules that it
names. So a document can write anywhere and run any code on the module path. This module inspects the archive and its
XML in the way FreeCAD reads them, without running any of it.
"""

import importlib.machinery
import os
import re
import site
import struct
import sys
import zipfile
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from ...core.errors import ThinPartError
from ...core.file_formats import is_document
from ...core.foreign_text import printable, shortened
from ...core.message import message
from ...system.file_paths import is_below
from ..bootstrap import trusted_code_folders
from ..proxy_modules import OWN_PACKAGE, PROXY_MODULES
from .damaged_archive import DAMAGED_ARCHIVE
from .linked_files import linked_files

_LOCAL_HEADER = struct.Struct("<4s5H3I2H")
_LOCAL_SIGNATURE = b"PK\3\4"
_DESCRIPTOR_FLAG = 0x08
_DESCRIPTOR_SIZES = (12, 16, 20, 24)
"""Possible sizes, in bytes, of the data descriptor after an entry whose header does not give its size."""

_ENCODING = re.compile(rb"""[^>]{0,80}\bencoding\s*=\s*["']([^"']*)["']""")
_ENCODINGS = (b"utf-8", b"us-ascii")
_BEFORE_XML = b"\xef\xbb\xbf \t\r\n"

_LONGEST_NAME = 80
"""Characters of a name that a message shows."""

_MOST_XML = 1 << 30
"""Most bytes of XML; a larger file is an attempt to fill the memory."""

_XML = ("Document.xml", "GuiDocument.xml")


@dataclass(frozen=True)
class NamedModules:
    """Python modules that a document names.

    Attributes
    ----------
    trusted : tuple of str
        Modules in FreeCAD's own folders or those of its add-ons, and of ThinPart those of its objects in documents.
    others : tuple of str
        All others; importing them runs code that does not belong to FreeCAD.
    """

    trusted: tuple
    others: tuple

    @property
    def warning(self):
        """One sentence about the other modules; empty if there are none."""
        if not self.others:
            return ""
        named = ", ".join(_named(name) for name in self.others[:5]) + (", ..." if len(self.others) > 5 else "")
        return message("The document names Python modules that are not FreeCAD's ({names}): they were not loaded, "
                       "and objects that need them may lack their shape.", names=named)


def check_document(path):
    """Reject a document if opening it, or one that it links to, would write outside the document's own folder.

    Raises ThinPartError, kind ``unsafe``, with the reason.

    Parameters
    ----------
    path : str or Path
        An .FCStd file. A damaged one passes, because opening it reports the damage.
    """
    for file in _documents(path):
        _check_file(file)


def named_modules(path):
    """Python modules that FreeCAD would import for a document and those that it links to: NamedModules."""
    names = set().union(*map(_modules_of, _documents(path)))
    trusted = {name for name in names if _is_trusted(name)}
    return NamedModules(tuple(sorted(trusted)), tuple(sorted(names - trusted)))


@contextmanager
def without_modules(names):
    """Context manager that hides modules of some names from FreeCAD while it opens a document, even if they are loaded."""
    missing = object()
    before = {name: sys.modules.get(name, missing) for name in names}
    for name in before:
        sys.modules[name] = None  # makes Python refuse to import the module
    try:
        yield
    finally:
        for name, module in before.items():
            if module is missing:
                sys.modules.pop(name, None)
            else:
                sys.modules[name] = module


def _documents(path):
    """The document, if it is one, and the files that it links to, whatever their suffix: list of Path."""
    path = Path(path)
    own = [path] if is_document(path) else []
    return [file for file in [*own, *linked_files(path)] if os.path.isfile(file)]


def _check_file(file):
    try:
        with zipfile.ZipFile(file) as archive:
            _check_entries(file, archive)
            for name in _XML:
                if name in archive.namelist():
                    _check_xml(file, archive, name)
    except ThinPartError:
        raise
    except DAMAGED_ARCHIVE:
        return  # opening the document reports the damage


def _check_entries(file, archive):
    """Check that entry names are unique and stay in their folder, and that no bytes lie between the entries.

    FreeCAD reads the entries one after the other and ignores the central directory at the end, which is what other
    programs show.
    """
    seen, end = set(), 0
    for entry in sorted(archive.infolist(), key=lambda entry: entry.header_offset):
        if leaves_its_folder(entry.orig_filename) or leaves_its_folder(entry.filename):
            raise _unsafe(file, message("an entry is called '{entry}'", entry=_named(entry.orig_filename)))
        if entry.filename in seen:
            raise _unsafe(file, message("two entries are called '{entry}'", entry=_named(entry.filename)))
        seen.add(entry.filename)
        if not _follows(entry.header_offset - end, end):
            raise _unsafe(file, message("{bytes} bytes that belong to no entry lie before '{entry}'",
                                        bytes=entry.header_offset - end, entry=_named(entry.filename)))
        end = _end_of(archive, entry)
    if not _follows(archive.start_dir - end, end):
        raise _unsafe(file, message("{bytes} bytes after its last entry belong to no entry",
                                    bytes=archive.start_dir - end))


def _follows(gap, end):
    return gap == 0 or end > 0 and gap in _DESCRIPTOR_SIZES


def _end_of(archive, entry):
    """Offset of the byte after an entry's content, from the entry's own header."""
    archive.fp.seek(entry.header_offset)
    fields = archive.fp.read(_LOCAL_HEADER.size)
    if len(fields) < _LOCAL_HEADER.size:
        raise zipfile.BadZipFile(message("an entry is cut off"))
    values = _LOCAL_HEADER.unpack(fields)
    name = archive.fp.read(values[9])
    if values[0] != _LOCAL_SIGNATURE:
        raise zipfile.BadZipFile(message("an entry has no header"))
    encoding = "utf-8" if entry.flag_bits & 0x800 else "cp437"
    if name.decode(encoding, "replace") != entry.orig_filename:
        raise zipfile.BadZipFile(message("an entry has two names"))
    return entry.header_offset + _LOCAL_HEADER.size + values[9] + values[10] + entry.compress_size


def _check_xml(file, archive, name):
    for element in _elements(file, archive, name):
        stored = element.get("file", "")
        # Links may lead to documents anywhere: those are only read, and checked like this one.
        if stored and "XLink" not in element.tag and leaves_its_folder(stored):
            raise _unsafe(file, message("it stores a file as '{path}'", path=_named(stored)))
        if element.tag == "Property" and element.get("name") == "Resources":
            for string in element.iter("String"):
                if leaves_its_folder(string.get("value", "")):
                    raise _unsafe(file, message("it stores a resource as '{path}'",
                                                path=_named(string.get("value"))))


def _elements(file, archive, name):
    if archive.getinfo(name).file_size > _MOST_XML:
        raise _unsafe(file, message("its {entry} would be larger than {gigabytes} GB",
                                    entry=name, gigabytes=_MOST_XML >> 30))
    content = archive.read(name)
    declared = _ENCODING.match(content)
    is_other = declared is not None and declared[1].lower() not in _ENCODINGS
    if is_other or b"\0" in content or not content.lstrip(_BEFORE_XML).startswith(b"<"):
        # FreeCAD writes UTF-8 only, and the search below is for ASCII.
        raise _unsafe(file, message("its {entry} is not in UTF-8", entry=name))
    if b"<!DOCTYPE" in content or b"<!ENTITY" in content:
        raise _unsafe(file, message("its {entry} declares its own entities", entry=name))
    return ElementTree.fromstring(content).iter()


def _modules_of(file):
    """Names of the modules of Python objects and of types in a document's XML."""
    names = set()
    try:
        with zipfile.ZipFile(file) as archive:
            for element in _elements(file, archive, "Document.xml"):
                names.add(element.get("module", ""))
                namespace, of_module, _ = element.get("type", "").partition("::")
                names.add(namespace if of_module else "")
    except ThinPartError:
        raise
    except DAMAGED_ARCHIVE:
        return set()  # as in _check_file
    return {name for name in names if re.fullmatch(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*", name)}


_NO_MODULES = ("App", "Base", "Data", "Gui")
"""Namespaces of FreeCAD's own types that are not modules."""


def _is_trusted(name):
    top = name.partition(".")[0]
    if top in _NO_MODULES and name == top:
        return True
    if top == OWN_PACKAGE:
        return name in PROXY_MODULES
    # Search the current module path, as FreeCAD would.
    spec = importlib.machinery.BuiltinImporter.find_spec(top) or importlib.machinery.PathFinder.find_spec(top)
    if spec is None:
        return True  # there is no such module, so no code is run
    locations = [spec.origin] if spec.origin not in (None, "built-in", "frozen") else list(
        spec.submodule_search_locations or ())
    return bool(locations) and all(_lies_in_freecad(location) for location in locations)


def _lies_in_freecad(path):
    # The package `freecad` is that of FreeCAD and its add-ons, also where Debian or pip has put it.
    packages = [os.path.join(folder, "freecad") for folder in site.getsitepackages()]
    real = os.path.realpath(path)
    return any(is_below(real, os.path.realpath(folder)) for folder in (*trusted_code_folders(), *packages))


def leaves_its_folder(path):
    """Whether a stored path is absolute on any system or leads out of the folder that it is extracted to."""
    parts = path.replace("\\", "/").split("/")
    return path.startswith(("/", "\\")) or bool(re.match(r"[A-Za-z]:", path)) or ".." in parts or "\0" in path


def _named(name):
    """A name for a message, of no more characters than people read."""
    return shortened(printable(name[:_LONGEST_NAME + 1]), _LONGEST_NAME)


def _unsafe(file, found):
    return ThinPartError(
        message("{file} was not opened: {problem}, so it would write outside its own folder or hide some of its "
                "content. Get it from a source that you trust.", file=file.name, problem=found), "unsafe")
