# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a classified file in FreeCAD and selects one of its parts."""

import os

import FreeCAD as App
import FreeCADGui as Gui

from ...api.window.open_parts import check_file
from ...core.errors import ThinPartError
from ...core.file_formats import ENDINGS, is_document
from ...core.problem import NOT_READ_BY_FREECAD, problem_of
from ..application.qt import QtCore, QtWidgets, translate
from ..application.sentences import translated
from ..widgets.confirmation import is_confirmed

DANGEROUS = ("crash", "memory", "timeout")
"""Kinds of failures that could hit FreeCAD itself if it read the file."""

_imported = {}  # document name by imported file


def open_part(file, name=None):
    """Open a file, or activate its document where it is open already, and select the part of this unique name.

    Raises
    ------
    ThinPartError
        When the file no longer exists, FreeCAD cannot read it, or it would write outside its own folder.
    """
    check_to_open(file)
    try:
        document = _document(file)
    except Exception as error:  # each importer of FreeCAD raises its own exceptions
        raise ThinPartError(translate(
            "ThinPart", "FreeCAD cannot open {} ({}).").format(
                os.path.basename(file), translated(problem_of(error, NOT_READ_BY_FREECAD))), "unreadable") from None
    App.setActiveDocument(document.Name)
    Gui.Selection.clearSelection()
    part = document.getObject(name) if name else None
    if part is not None:
        Gui.Selection.addSelection(document.Name, part.Name)


def told_by(action):
    """Do something that takes a while, under the cursor that says so: str, what it returns, or why it cannot be done."""
    QtWidgets.QApplication.setOverrideCursor(QtCore.Qt.WaitCursor)
    try:
        return action() or ""
    except ThinPartError as error:
        return translated(error)
    finally:
        QtWidgets.QApplication.restoreOverrideCursor()


def check_to_open(file):
    """Refuse files that are not CAD files: FreeCAD would run a macro, and an info file may name any file.

    Raises
    ------
    ThinPartError
        kind ``missing`` or ``unsafe``.
    """
    if not os.path.isfile(file):
        raise ThinPartError(translate(
            "ThinPart", "The file {} no longer exists.").format(file), "missing")
    if not file.lower().endswith(ENDINGS):
        raise ThinPartError(translate(
            "ThinPart", "{} was not opened: it is not a CAD file that ThinPart reads.").format(file), "unsafe")
    check_file(file)


def confirm_dangerous_open(sentence, parent):
    """Ask whether to open a file that failed in one of the `DANGEROUS` ways; the sentence says what happened then."""
    return is_confirmed(
        parent, "ThinPart_FolderDare", QtWidgets.QMessageBox.Warning, sentence,
        translate("ThinPart", "FreeCAD may crash in the same way when it opens the file: save your documents first. "
                              "Open it anyway?"),
        QtWidgets.QMessageBox.Open)


def _document(file):
    if is_document(file):
        return App.openDocument(file)
    imported = App.listDocuments().get(_imported.get(file))
    if imported is not None:
        return imported
    before = set(App.listDocuments())
    App.loadFile(file)
    new = [name for name in App.listDocuments() if name not in before]
    if not new or not App.getDocument(new[0]).Objects:
        raise ValueError(translate("ThinPart", "nothing came in"))
    _imported[file] = new[0]
    fit_view()
    return App.getDocument(new[0])


def fit_view():
    """Show all of the active 3D view's document; a view of another kind stays."""
    view = Gui.activeView()
    if hasattr(view, "fitAll"):
        view.fitAll()
