"""Reads the parts of a CAD or mesh file. Foreign files may end the process: call it in a worker."""

import importlib
import os
import tempfile
import zipfile
from contextlib import contextmanager, suppress
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from ..core.errors import ThinPartError
from .bootstrap import load_freecad
from .damaged_archive import DAMAGED_ARCHIVE
from .document_parts import DocumentContent, document_content
from .document_safety import check_document, named_modules, without_modules
from .equal_solids import equal_part
from .linked_files import linked_files
from .mesh_file_check import check_mesh_file
from .part import MeshedPart, Occurrence, SolidPart
from .solids import solids_of


def read_parts(path):
    """Read the distinct parts of a file.

    Parameters
    ----------
    path : str or Path
        A file that is there and not empty; `storage.info_file.new_source` has seen to that.

    Returns
    -------
    DocumentContent
        At least one part, or one that is broken.

    Raises
    ------
    ThinPartError
        kind ``unsupported``, ``unreadable``, ``empty`` (document) or ``no_solid``.
    """
    path = Path(path)
    reader = READERS.get(path.suffix.lower())
    if reader is None:
        raise ThinPartError(
            f"{path.name} has no ending that ThinPart reads ({', '.join(sorted(READERS))}).",
            "unsupported",
        )
    load_freecad()
    content = reader(path)
    if not content.parts and not content.broken:
        raise ThinPartError(
            f"{path.name} holds no closed solid, only surfaces, wires or points: "
            "close or thicken it first.", "no_solid",
        )
    return content


@contextmanager
def _name_for_freecad(path):
    """A path to a file that FreeCAD takes: text, which the bytes of old file names are not always, with no
    backslash, which FreeCAD takes for a slash.
    """
    if _is_fit_for_freecad(path):
        yield os.fspath(path)
        return
    with tempfile.TemporaryDirectory(prefix="thinpart-name-") as folder:
        link = os.path.join(folder, "part" + path.suffix)
        os.symlink(path.absolute(), link)  # only Unix has such names
        yield link


def _is_fit_for_freecad(path):
    try:
        os.fspath(path).encode()
    except UnicodeEncodeError:
        return False
    return os.sep == "\\" or "\\" not in os.fspath(path)


def _read_document(path):
    import FreeCAD

    if not _is_fit_for_freecad(path) and linked_files(path):
        # By another name it would not find the documents that it links into.
        raise ThinPartError(
            f"FreeCAD follows no links from a document whose path is no UTF-8 text or has a backslash: rename "
            f"{path.name} or the folder that it lies in.", "unsupported",
        )
    check_document(path)
    try:
        with zipfile.ZipFile(path) as archive:
            damaged = archive.testzip()
            names = archive.namelist()
            hidden = _hidden_objects(archive) if "GuiDocument.xml" in names else set()
    except DAMAGED_ARCHIVE as error:
        raise ThinPartError(f"{path.name} is damaged or no FreeCAD document ({error}).",
                            "unreadable") from None
    if damaged is not None or "Document.xml" not in names:
        raise ThinPartError(
            f"{path.name} is damaged or no FreeCAD document ({damaged or 'no Document.xml'}).",
            "unreadable",
        )
    modules = named_modules(path)
    # Without a window FreeCAD does not get them by itself while it reads, and such an object, a Draft array for
    # one, then has no shape.
    for module in modules.trusted:
        with suppress(Exception):  # an add-on that is not there or not whole: its shape is stored
            importlib.import_module(module)
    try:
        with without_modules(modules.others), _name_for_freecad(path) as name:
            document = FreeCAD.openDocument(name, True)
    except Exception as error:  # FreeCAD raises its own classes, which differ between versions
        raise ThinPartError(f"FreeCAD cannot open {path.name} ({error}).", "unreadable") from None
    if not document.Objects:
        raise ThinPartError(f"{path.name} is an empty document.", "empty")
    for name in hidden & {each.Name for each in document.Objects}:
        # In memory only: without its window FreeCAD does not read what older files hid.
        document.getObject(name).Visibility = False
    # The document stays open while its shapes are in use; the worker drops it afterwards.
    content = document_content(document)
    if modules.warning:
        for part in content.parts:
            part.warnings = (*part.warnings, modules.warning)
    return content


def _hidden_objects(archive):
    """Names of the objects that the document's view hides."""
    try:
        view = ElementTree.fromstring(archive.read("GuiDocument.xml"))
    except ElementTree.ParseError:
        return set()  # it matters for nothing else, so a part is not lost to it
    return {
        provider.get("name")
        for provider in view.iter("ViewProvider")
        for flag in provider.findall("Properties/Property[@name='Visibility']/Bool")
        if flag.get("value") == "false"
    }


def _read_shape(path):
    import Part

    try:
        with _name_for_freecad(path) as name:
            shape = Part.read(name)
    except Exception as error:  # as above
        raise ThinPartError(f"{path.name} is damaged or not what its ending says ({error}).",
                            "unreadable") from None
    if shape.isNull():
        raise ThinPartError(f"{path.name} is damaged or holds no shape.", "unreadable")
    solids, warnings = solids_of(shape)
    parts = []
    for index, solid in enumerate(solids):
        known = equal_part(parts, solid)
        if known is None:
            number = len(parts) + 1
            label = path.stem if len(solids) == 1 else f"{path.stem} ({number})"
            known = SolidPart(f"Solid{number}", label, warnings=warnings, shape=solid)
            parts.append(known)
        known.occurrences.append(Occurrence("", "", index))
    return DocumentContent(parts)


def _read_mesh(path):
    import Mesh

    check_mesh_file(path)
    try:
        with _name_for_freecad(path) as name:
            mesh = Mesh.Mesh(name)
        points, triangles = mesh.Topology
    except Exception as error:  # as above
        kind = "unsupported" if path.suffix.lower() == ".3mf" else "unreadable"
        raise ThinPartError(f"FreeCAD cannot read {path.name} ({error}).", kind) from None
    if not triangles:
        raise ThinPartError(f"{path.name} is damaged, or its faces are no triangles: "
                            "triangulate it first.", "unreadable")
    points = np.array([(p.x, p.y, p.z) for p in points], dtype=np.float64)
    return DocumentContent([MeshedPart("Mesh", path.stem, points=points,
                                       triangles=np.array(triangles, dtype=np.int64))])


READERS = {
    ".fcstd": _read_document,
    ".step": _read_shape, ".stp": _read_shape,
    ".iges": _read_shape, ".igs": _read_shape,
    ".brep": _read_shape, ".brp": _read_shape,
    ".stl": _read_mesh, ".obj": _read_mesh, ".ply": _read_mesh, ".off": _read_mesh,
    ".3mf": _read_mesh,
}
"""Reader by file ending, lower case."""
