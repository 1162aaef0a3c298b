# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the parts of a CAD or mesh file. A foreign file may crash the process, so call this in a worker."""

import importlib
import os
import tempfile
import zipfile
from contextlib import contextmanager, suppress
from pathlib import Path
from xml.etree import ElementTree

from ...core.errors import ThinPartError
from ...core.file_formats import DOCUMENT, ENDINGS, MESH, SHAPE, format_of
from ...core.message import message
from ...core.problem import NOT_READ_BY_FREECAD, problem_of
from ...system.exit_cause import is_out_of_memory
from ..bootstrap import load_freecad
from ..mesh_arrays import mesh_arrays
from ..shapes.part import MeshedPart
from .closed_links import closed_links_warning, keep_closed, special_links
from .damaged_archive import DAMAGED_ARCHIVE
from .document_parts import DocumentContent, document_content
from .document_safety import check_document, named_modules, without_modules
from .linked_files import linked_files
from .mesh_file_check import check_mesh_file
from .shape_parts import shape_parts


def read_parts(path):
    """Read the distinct parts of a file: DocumentContent, at least one part or broken part.

    Raises ThinPartError, kind ``unsupported``, ``unreadable``, ``empty`` (document) or ``no_solid``.

    Parameters
    ----------
    path : str or Path
        A file that exists and is not empty; `storage/info/info_file.new_source` has checked this.
    """
    path = Path(path)
    found = format_of(path)
    if found is None:
        raise ThinPartError(
            message("{file} has no ending that ThinPart reads ({endings}).",
                    file=path.name, endings=", ".join(sorted(ENDINGS))),
            "unsupported",
        )
    load_freecad()
    content = _READERS.get(found.name, _READERS[found.kind])(path)
    if not content.parts and not content.broken:
        raise ThinPartError(
            message("{file} holds no closed solid, only surfaces, wires or points: close or thicken it first.",
                    file=path.name), "no_solid",
        )
    return content


@contextmanager
def _readable_path(path):
    """Context manager for a path to a file that FreeCAD accepts.

    FreeCAD needs a path that is valid UTF-8, which old file names may not be, and takes a backslash for a slash.
    """
    if _is_readable_path(path):
        yield os.fspath(path)
        return
    with tempfile.TemporaryDirectory(prefix="thinpart-name-") as folder:
        link = os.path.join(folder, "part" + path.suffix)
        os.symlink(path.absolute(), link)  # such names exist on Unix only
        yield link


def _is_readable_path(path):
    try:
        os.fspath(path).encode()
    except UnicodeEncodeError:
        return False
    return os.sep == "\\" or "\\" not in os.fspath(path)


def _read_document(path):
    import FreeCAD

    if not _is_readable_path(path) and linked_files(path):
        # Opened by another name, it would not find the documents that it links to.
        raise ThinPartError(
            message("FreeCAD does not follow links from a document whose path is not UTF-8 text or has a backslash: "
                    "rename {file} or its folder.", file=path.name), "unsupported",
        )
    check_document(path)
    try:
        with zipfile.ZipFile(path) as archive:
            damaged = archive.testzip()
            names = archive.namelist()
            hidden = _hidden_objects(archive) if "GuiDocument.xml" in names else set()
    except DAMAGED_ARCHIVE as error:
        raise ThinPartError(message("{file} is damaged or not a FreeCAD document ({problem}).",
                                    file=path.name, problem=problem_of(error, message("it cannot be unpacked"))),
                            "unreadable") from None
    if damaged is not None or "Document.xml" not in names:
        raise ThinPartError(
            message("{file} is damaged or not a FreeCAD document ({problem}).",
                    file=path.name, problem=damaged or "no Document.xml"),
            "unreadable",
        )
    modules, closed = named_modules(path), special_links(path)
    # Without a window FreeCAD does not import these modules while it reads, and objects that need them, such as a
    # Draft array, would have no shape.
    for module in modules.trusted:
        with suppress(Exception):  # the add-on is missing or incomplete: the document has the stored shape
            importlib.import_module(module)
    keep_closed(closed)
    try:
        with without_modules(modules.others), _readable_path(path) as name:
            document = FreeCAD.openDocument(name, True)
    except MemoryError:
        raise
    except Exception as error:  # FreeCAD raises its own classes, which differ between versions
        raise ThinPartError(message("FreeCAD cannot open {file} ({problem}).",
                                    file=path.name, problem=_problem(error)), "unreadable") from None
    if not document.Objects:
        raise ThinPartError(message("{file} is an empty document.", file=path.name), "empty")
    for name in hidden & {candidate.Name for candidate in document.Objects}:
        # In memory only: without a window FreeCAD does not read the visibility stored in older files.
        with suppress(AttributeError):  # a damaged document may have locked the property; the object counts as visible
            document.getObject(name).Visibility = False
    # The document stays open while its shapes are in use; the worker closes it afterwards.
    content = document_content(document)
    for warning in filter(None, (modules.warning, closed_links_warning(closed))):
        for part in content.parts:
            part.warnings = (*part.warnings, warning)
    return content


def _hidden_objects(archive):
    """Names of the objects that are hidden in the document's view."""
    try:
        view = ElementTree.fromstring(archive.read("GuiDocument.xml"))
    except ElementTree.ParseError:
        return set()  # only visibility depends on this file, so damage to it does not reject the document
    return {
        provider.get("name")
        for provider in view.iter("ViewProvider")
        for flag in provider.findall("Properties/Property[@name='Visibility']/Bool")
        if flag.get("value") == "false"
    }


def _read_shape(path):
    import Part

    try:
        with _readable_path(path) as name:
            shape = Part.read(name)
    except MemoryError:
        raise
    except Exception as error:  # as above
        raise ThinPartError(message("{file} is damaged or not what its ending says ({problem}).",
                                    file=path.name, problem=_problem(error)), "unreadable") from None
    if shape.isNull():
        raise ThinPartError(message("{file} is damaged or holds no shape.", file=path.name), "unreadable")
    return DocumentContent(shape_parts(shape, path.stem))


def _read_mesh(path):
    import Mesh

    check_mesh_file(path)
    try:
        with _readable_path(path) as name:
            points, triangles = mesh_arrays(Mesh.Mesh(name))
    except MemoryError:
        raise
    except Exception as error:  # as above
        kind = "unsupported" if format_of(path).is_recent else "unreadable"
        raise ThinPartError(message("FreeCAD cannot read {file} ({problem}).",
                                    file=path.name, problem=_problem(error)), kind) from None
    if not len(triangles):
        raise ThinPartError(message("{file} is damaged, or its faces are not triangles: triangulate it first.",
                                    file=path.name), "unreadable")
    return DocumentContent([MeshedPart("Mesh", path.stem, points=points, triangles=triangles)])


def _problem(error):
    """Why FreeCAD could not read a file. A lack of memory is no fault of the file."""
    if is_out_of_memory(error):
        raise MemoryError from None
    return problem_of(error, NOT_READ_BY_FREECAD)


_READERS = {
    DOCUMENT: _read_document,
    SHAPE: _read_shape,
    MESH: _read_mesh,
}
"""By kind, what FreeCAD reads. A format that it does not read has a reader by its name."""
