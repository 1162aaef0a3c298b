# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dialogs that write reports have in common: the folder, progress, and whether to open what was written."""

import os

from ..application import lifelong
from ..application.icons import icon
from ..application.qt import QtCore, QtGui, QtWidgets, translate
from ..guide.command import help_button
from ..record.kept_room import keep_room
from ..record.record_view import show_text, text_line
from ..widgets.buttons import add_button
from ..widgets.file_dialogs import choose_folder


class ReportForm(QtWidgets.QDialog):
    """Non-modal dialog. A subclass has ``start()`` and ``_stop()``, which ends what `start` has begun.

    Parameters
    ----------
    parent : QWidget
    name : str
        Begins the object names of its widgets.
    title : str
        Of the window.
    page : str
        The command or panel whose page of the guide the help shows.
    job : str
        What FreeCAD's status bar says while a report is being written.
    """

    def __init__(self, parent, name, title, page, job):
        super().__init__(parent)
        self._name, self._job_text = name, job
        self._written = ""  # path of the page to open
        self._is_writing = False
        self.setObjectName(f"{name}Dialog")
        self.setWindowTitle(title)
        self.setWindowIcon(icon("ThinPart_Report"))
        column = QtWidgets.QVBoxLayout(self)
        self._subject = text_line(self, column, f"{name}Subject")
        self._add_folder(column)
        self._open_when_done = QtWidgets.QCheckBox(
            translate("ThinPart", "&Open it in the browser when it is ready"), self)
        self._open_when_done.setObjectName(f"{name}Open")
        self._open_when_done.setChecked(True)
        column.addWidget(self._open_when_done)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName(f"{name}Progress")
        column.addWidget(self._bar)
        keep_room(self._bar)
        self._add_buttons(column, page)
        self._message = text_line(self, column, f"{name}Message")  # below what is pressed: it may take many lines
        keep_room(self._message, 2)
        column.addStretch(1)
        self._show_state()

    def cancel(self):
        """Stop; pages already written stay."""
        self._stop()
        self._is_writing = False
        self._show_message(translate("ThinPart", "Stopped on request before the end."))
        self._show_state()

    def open_report(self):
        """Open the report in the browser."""
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(self._written))

    def end(self):
        """Stop at once and delete the dialog, without asking the user."""
        self._stop()
        lifelong.running_jobs.end(self._name)
        self.hide()
        self.deleteLater()

    def _chosen_folder(self, proposed, base):
        """Absolute path of the chosen folder, or of the proposed one where there is none; relative ones are in `base`."""
        output = self._folder.text().strip() or proposed
        self._folder.setText(output)
        return os.path.abspath(os.path.join(base, output))

    def _show_begun(self, text, steps):
        """Show that a report is being written, and in how many steps; 0 where that is not known yet."""
        self._is_writing = True
        self._bar.setRange(0, steps)
        self._bar.setValue(0)
        self._show_message(text)

    def _show_end(self, sentence, written="", said=""):
        """Show why no report was written, or else what is said of the page that was, and open it if that is wanted."""
        self._is_writing = False
        self._show_state()
        if sentence:
            self._show_message(sentence)
            return
        self._written = written
        self._show_message(said)
        self._open_button.setEnabled(True)
        if self._open_when_done.isChecked():
            self.open_report()

    def _show_message(self, text):
        show_text(self._message, text)
        self.resize(self.width(), max(self.height(), self.heightForWidth(self.width())))  # Qt would cut its last lines off

    def _show_state(self):
        running = self._is_writing
        if running:
            lifelong.running_jobs.show(self._name, self._job_text, self)
        else:
            lifelong.running_jobs.end(self._name)
        self._bar.setVisible(running)
        self._start.setEnabled(not running)
        self._cancel.setEnabled(running)
        for widget in (self._folder, self._browse):
            widget.setEnabled(not running)
        self._open_button.setEnabled(False)

    def _choose(self):
        choose_folder(self, os.path.dirname(self._folder.text()), self._folder.setText,
                      translate("ThinPart", "Folder of the report"))

    def _add_folder(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "&Folder:"), self)
        self._folder = QtWidgets.QLineEdit(self)
        self._folder.setObjectName(f"{self._name}Folder")
        self._folder.setMinimumWidth(380)
        label.setBuddy(self._folder)
        row.addWidget(label)
        row.addWidget(self._folder)
        self._browse = add_button(
            row, self, f"{self._name}Browse", translate("ThinPart", "&Browse\u2026"), self._choose)
        column.addLayout(row)

    def _add_buttons(self, column, page):
        row = QtWidgets.QHBoxLayout()

        def add(name, text, callback):
            return add_button(row, self, f"{self._name}{name}", text, callback, is_for_enter=False)

        row.addStretch(1)
        self._start = add("Start", translate("ThinPart", "&Write report"), self.start)
        self._start.setDefault(True)
        self._cancel = add("Cancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._open_button = add("Look", translate("ThinPart", "&Open report"), self.open_report)
        row.addWidget(help_button(self, page))
        add("Close", translate("ThinPart", "Close"), self.close)
        column.addLayout(row)
