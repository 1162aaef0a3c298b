"""Opening a classified file in FreeCAD's window, with one part of it selected."""

import os

import FreeCAD as App
import FreeCADGui as Gui

from ..core.errors import ThinPartError
from ..freecad_adapter.document_safety import check_document
from .qt import QtWidgets, translate
from .question_box import is_confirmed

DANGEROUS = ("crash", "memory", "timeout")
"""Kinds of failures that FreeCAD would meet itself if it read the file."""

_imported = {}  # names of documents by the files that they were imported from


def open_part(file, name=None):
    """Open a file, or bring its document to the front, and select a part.

    Parameters
    ----------
    file : str
    name : str, optional
        The part's unique name.

    Raises
    ------
    ThinPartError
        When the file is gone, FreeCAD cannot read it, or it would write outside its own folder.
    """
    if not os.path.isfile(file):
        raise ThinPartError(translate(
            "ThinPart", "There is no file {} any more.").format(file), "missing")
    check_document(file)
    try:
        document = _document(file)
    except Exception as error:  # every importer of FreeCAD raises what it likes
        raise ThinPartError(translate(
            "ThinPart", "FreeCAD cannot open {} ({}).").format(os.path.basename(file), error),
            "unreadable") from None
    App.setActiveDocument(document.Name)
    Gui.Selection.clearSelection()
    part = document.getObject(name) if name else None
    if part is not None:
        Gui.Selection.addSelection(document.Name, part.Name)


def ask_to_dare(sentence, parent):
    """Whether the user wants a file opened that failed in one of the `DANGEROUS` ways.

    Parameters
    ----------
    sentence : str
        What happened when it was classified.
    parent : QWidget
    """
    return is_confirmed(
        parent, "ThinPart_FolderDare", QtWidgets.QMessageBox.Warning, sentence,
        translate("ThinPart", "The same may happen to FreeCAD when it opens the file: save your documents "
                  "first. Open it nevertheless?"),
        QtWidgets.QMessageBox.Open)


def _document(file):
    if file.lower().endswith(".fcstd"):
        return App.openDocument(file)
    known = App.listDocuments().get(_imported.get(file))
    if known is not None:
        return known
    before = set(App.listDocuments())
    App.loadFile(file)
    new = [name for name in App.listDocuments() if name not in before]
    if not new or not App.getDocument(new[0]).Objects:
        raise ValueError(translate("ThinPart", "nothing came in"))
    _imported[file] = new[0]
    Gui.SendMsgToActiveView("ViewFit")
    return App.getDocument(new[0])
