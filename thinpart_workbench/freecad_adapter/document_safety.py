"""What a FreeCAD document would do besides being read, found before FreeCAD opens it.

FreeCAD writes the files of a document where the document says, and imports the Python modules that it names. So a
document can write anywhere and run what lies on the module path. Here the archive and its XML are looked at as
FreeCAD reads them; nothing of the document is run.
"""

import importlib.machinery
import os
import re
import struct
import sys
import zipfile
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

from ..core.errors import ThinPartError
from ..system.file_paths import is_below
from .bootstrap import trusted_code_folders
from .damaged_archive import DAMAGED_ARCHIVE
from .linked_files import linked_files

_LOCAL_HEADER = struct.Struct("<4s5H3I2H")
_LOCAL_SIGNATURE = b"PK\3\4"
_DESCRIPTOR_FLAG = 0x08
_DESCRIPTOR_SIZES = (12, 16, 20, 24)
"""Bytes that may follow an entry whose size is told after it."""

_MOST_XML = 1 << 30
"""Bytes of XML; more is no document but an attempt to fill the memory."""

_XML = ("Document.xml", "GuiDocument.xml")
_OWN_PACKAGE = __package__.partition(".")[0]


@dataclass(frozen=True)
class NamedModules:
    """Python modules that a document names.

    Attributes
    ----------
    trusted : tuple of str
        They lie in FreeCAD's own folders or those of its add-ons.
    others : tuple of str
        Of anywhere else; importing them runs what FreeCAD never meant to run.
    """

    trusted: tuple
    others: tuple

    @property
    def warning(self):
        """One sentence about the others; empty where there are none."""
        if not self.others:
            return ""
        named = ", ".join(self.others[:5]) + (", ..." if len(self.others) > 5 else "")
        return (f"The document names Python modules that are not FreeCAD's ({named}): they were not loaded, and "
                "objects that need them may lack their shape.")


def check_document(path):
    """Refuse a document that would write outside its own folder when it is opened, or one that it links to.

    Parameters
    ----------
    path : str or Path
        An .FCStd file; one that is damaged passes, since opening it says so.

    Raises
    ------
    ThinPartError
        kind ``unsafe``, with what was found.
    """
    for file in _documents(path):
        _check_file(file)


def named_modules(path):
    """Python modules that a document and those that it links to would have FreeCAD import.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    NamedModules
    """
    names = set().union(*map(_modules_of, _documents(path)))
    trusted = {name for name in names if _is_trusted(name)}
    return NamedModules(tuple(sorted(trusted)), tuple(sorted(names - trusted)))


@contextmanager
def without_modules(names):
    """While a document is opened, FreeCAD finds none of some modules, whether they are loaded or not.

    Parameters
    ----------
    names : iterable of str
    """
    missing = object()
    before = {name: sys.modules.get(name, missing) for name in names}
    for name in before:
        sys.modules[name] = None  # Python's own sign for a module that must not be imported
    try:
        yield
    finally:
        for name, module in before.items():
            if module is missing:
                sys.modules.pop(name, None)
            else:
                sys.modules[name] = module


def _documents(path):
    """The document, if it is one, and those that it links to: list of Path."""
    return [file for file in (Path(path), *linked_files(path))
            if file.suffix.lower() == ".fcstd" and file.is_file()]


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
        return  # it is damaged, which is said by whoever opens it


def _check_entries(file, archive):
    """Names that stay in their folder, each once, and nothing between the entries.

    FreeCAD reads the entries one after the other and never looks at the table at the end, which is what other
    programs show.
    """
    seen, end = set(), 0
    for entry in sorted(archive.infolist(), key=lambda each: each.header_offset):
        if leaves_its_folder(entry.orig_filename) or leaves_its_folder(entry.filename):
            raise _unsafe(file, f"an entry is called '{entry.orig_filename}'")
        if entry.filename in seen:
            raise _unsafe(file, f"two entries are called '{entry.filename}'")
        seen.add(entry.filename)
        if not _follows(entry.header_offset - end, end):
            raise _unsafe(file, f"{entry.header_offset - end} bytes that belong to no entry lie before "
                                f"'{entry.filename}'")
        end = _end_of(archive, entry)
    if not _follows(archive.start_dir - end, end):
        raise _unsafe(file, f"{archive.start_dir - end} bytes after its last entry belong to none")


def _follows(gap, end):
    return gap == 0 or end > 0 and gap in _DESCRIPTOR_SIZES


def _end_of(archive, entry):
    """Offset of the byte after an entry's content, from the entry's own header."""
    archive.fp.seek(entry.header_offset)
    fields = archive.fp.read(_LOCAL_HEADER.size)
    if len(fields) < _LOCAL_HEADER.size:
        raise zipfile.BadZipFile("an entry is cut off")
    values = _LOCAL_HEADER.unpack(fields)
    name = archive.fp.read(values[9])
    if values[0] != _LOCAL_SIGNATURE:
        raise zipfile.BadZipFile("an entry has no header")
    encoding = "utf-8" if entry.flag_bits & 0x800 else "cp437"
    if name.decode(encoding, "replace") != entry.orig_filename:
        raise zipfile.BadZipFile("an entry has two names")
    return entry.header_offset + _LOCAL_HEADER.size + values[9] + values[10] + entry.compress_size


def _check_xml(file, archive, name):
    for element in _elements(file, archive, name):
        stored = element.get("file", "")
        # Links to other documents may lie anywhere: those are read, and checked like this one.
        if stored and "XLink" not in element.tag and leaves_its_folder(stored):
            raise _unsafe(file, f"it stores a file as '{stored}'")
        if element.tag == "Property" and element.get("name") == "Resources":
            for each in element.iter("String"):
                if leaves_its_folder(each.get("value", "")):
                    raise _unsafe(file, f"it stores a resource as '{each.get('value')}'")


def _elements(file, archive, name):
    if archive.getinfo(name).file_size > _MOST_XML:
        raise _unsafe(file, f"its {name} would be larger than {_MOST_XML >> 30} GB")
    content = archive.read(name)
    if b"<!DOCTYPE" in content or b"<!ENTITY" in content:
        raise _unsafe(file, f"its {name} declares entities of its own")
    return ElementTree.fromstring(content).iter()


def _modules_of(file):
    """Modules of Python objects and of types, in a document's XML."""
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
"""Namespaces of FreeCAD's own types that are no modules."""


def _is_trusted(name):
    top = name.partition(".")[0]
    if top in _NO_MODULES and name == top or top == _OWN_PACKAGE:
        return True
    # By the module path as it is, since that is how FreeCAD would find it.
    spec = importlib.machinery.BuiltinImporter.find_spec(top) or importlib.machinery.PathFinder.find_spec(top)
    if spec is None:
        return True  # there is no such module: nothing is run
    places = [spec.origin] if spec.origin not in (None, "built-in", "frozen") else list(
        spec.submodule_search_locations or ())
    return bool(places) and all(_lies_in_freecad(place) for place in places)


def _lies_in_freecad(place):
    real = os.path.realpath(place)
    return any(is_below(real, os.path.realpath(folder)) for folder in trusted_code_folders())


def leaves_its_folder(path):
    """Whether a stored path is absolute, on any system, or leads out of the folder that it is put into."""
    parts = path.replace("\\", "/").split("/")
    return path.startswith(("/", "\\")) or bool(re.match(r"[A-Za-z]:", path)) or ".." in parts or "\0" in path


def _unsafe(file, found):
    return ThinPartError(
        f"{file.name} was not opened: {found}, so it would write outside its own folder or hide what it holds. "
        "Get it from somebody whom you trust.", "unsafe")
