# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inserts a part of a library into the active document."""

import importlib
import os

import FreeCAD as App

from ...core.errors import ThinPartError
from ...core.file_formats import format_of, is_document
from ...core.problem import NOT_READ_BY_FREECAD, problem_of
from ..application.qt import translate
from ..application.sentences import translated
from .open_part import check_to_open, fit_view
from .transaction import transaction


def insert_part(file, name=None):
    """Insert a file, or the part of this unique name in it, into the active document; returns one sentence about it: str.

    Raises
    ------
    ThinPartError
        Where there is no active document, no file, FreeCAD cannot read it, or it would write outside its own
        folder.
    """
    document = App.ActiveDocument
    if document is None:
        raise ThinPartError(translate(
            "ThinPart", "There is no document to insert into: open or create one first."), "usage")
    check_to_open(file)
    try:
        with transaction(document, translate("ThinPart", "Insert part")):
            template = _insert(document, file, name)
            document.recompute()
    except Exception as error:  # each importer of FreeCAD raises its own exceptions
        raise ThinPartError(translate("ThinPart", "FreeCAD cannot insert {} ({}).").format(
            os.path.basename(file), translated(problem_of(error, NOT_READ_BY_FREECAD))), "unreadable") from None
    App.setActiveDocument(document.Name)
    fit_view()
    return template.format(os.path.basename(file), document.Label)


def _insert(document, file, name):
    if not is_document(file):
        known = format_of(file)
        if known is not None and known.name == "BREP":
            _insert_shape(document, file)
        else:
            _importer(file).insert(file, document.Name)
        return translate("ThinPart", "{} was imported into {}.")
    if document.FileName and os.path.samefile(document.FileName, file):
        raise ValueError(translate("ThinPart", "it is the active document itself"))
    if document.FileName:
        _link(document, file, name)
        return translate("ThinPart", "A link to {} was put into {}.")
    # Links between documents are stored by file name, and this document has none yet.
    document.mergeProject(file)
    return translate("ThinPart", "The content of {} was copied into {}: a link needs a saved document.")


def _insert_shape(document, file):
    """Insert a BREP file: FreeCAD 1.1 warns of the importer of `Part`, which has no other successor."""
    import Part  # loaded on demand, it takes long

    name = os.path.splitext(os.path.basename(file))[0]
    inserted = document.addObject("Part::Feature", name)
    inserted.Label, inserted.Shape = name, Part.read(file)


def _importer(file):
    modules = App.getImportType(os.path.splitext(file)[1][1:])
    if not modules:
        raise ThinPartError(translate("ThinPart", "there is no importer for such files"), "unsupported")
    # Of several importers, prefer the GUI's own, which keeps names and colours.
    names = sorted(modules, key=lambda module: (module != "ImportGui", module != "Part"))
    return importlib.import_module(names[0])


def _link(document, file, name):
    open_documents = {other.FileName: other for other in App.listDocuments().values() if other.FileName}
    source = next((other for path, other in open_documents.items() if os.path.samefile(path, file)), None)
    if source is None:
        source = App.openDocument(file, hidden=True)
        App.setActiveDocument(document.Name)
    target = source.getObject(name) if name else None
    if target is None:
        roots = [root for root in source.RootObjects if root.isDerivedFrom("App::GeoFeature")]
        if not roots:
            raise ValueError(translate("ThinPart", "it holds nothing to link to"))
        target = roots[0]
    link = document.addObject("App::Link", target.Name)
    link.LinkedObject = target
    link.Label = target.Label
