# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table of parts of libraries, whose documents can be opened, inserted and found."""

import os

from ..application.qt import QtCore, QtGui, QtWidgets, translate
from ..application.sentences import translated
from ..document.insert_part import insert_part
from ..document.open_part import DANGEROUS, confirm_dangerous_open, open_part, told_by
from ..record.thumbnails import PicturesView


class PartFilesView(PicturesView):
    """Shows rows with the fields of a StoredPart: pictures, and what can be done with the document of a part."""

    def __init__(self, name, table, parent=None):
        self._table = table
        super().__init__(name, table, parent)
        self.doubleClicked.connect(lambda _: self.open_current())

    @property
    def current_part(self):
        """The part at the current index, or None."""
        index = self.currentIndex()
        return self._table.row_at(index.row()) if index.isValid() else None

    def open_current(self):
        """Open the part's document."""
        part = self.current_part
        if part is None:
            return
        if part.error_kind in DANGEROUS and not confirm_dangerous_open(translated(part.error_message), self):
            return
        self.message.emit(told_by(lambda: open_part(part.file, part.name)))

    def insert_current(self):
        """Insert the part into the active document."""
        part = self.current_part
        if part is not None:
            self.message.emit(told_by(lambda: insert_part(part.file, part.name)))

    def show_folder(self):
        """Show the part's folder in the desktop's file manager."""
        folder = os.path.dirname(self.current_part.file)
        if not os.path.isdir(folder):
            self.message.emit(translate("ThinPart", "The folder {} no longer exists.").format(folder))
        elif not QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(folder)):
            self.message.emit(translate(
                "ThinPart", "No file manager was found: open the folder {} yourself.").format(folder))

    def copy_path(self):
        """Put the path of the part's document on the clipboard."""
        QtWidgets.QApplication.clipboard().setText(self.current_part.file)

    def file_actions(self):
        """What can be done with the document of a part: list of (name, text, callable)."""
        return [
            ("Open", translate("ThinPart", "Open"), self.open_current),
            ("Insert", translate("ThinPart", "Insert into active document"), self.insert_current),
            ("Folder", translate("ThinPart", "Show in file manager"), self.show_folder),
            ("CopyPath", translate("ThinPart", "Copy path"), self.copy_path),
        ]

    def keyPressEvent(self, event):
        """Open the part on Enter."""
        if event.key() in (QtCore.Qt.Key_Return, QtCore.Qt.Key_Enter):
            self.open_current()
            return
        super().keyPressEvent(event)
