"""The dialog that writes a report about a document."""

import os
from dataclasses import dataclass
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui

from ..core.errors import ThinPartError
from ..freecad_adapter.additional_packages import has_package, install_folder
from ..freecad_adapter.settings import preference
from ..workflow.report_folder import OVERVIEW
from .command_arguments import info_place_arguments, measuring_arguments
from .document_observer import OBSERVER
from .folder_run import DONE, STOPPED, FolderRun
from .package_installation import PackageInstallation
from .push_button import add_button
from .qt import QtCore, QtGui, QtWidgets, translate
from .result_view import show_text, text_line
from .sentences import translated

_PACKAGE = "Jinja2"
"""Fills in the pages; bundles of FreeCAD have it not."""

ICON = Path(__file__).resolve().parents[2] / "resources" / "icons" / "ThinPart_Report.svg"


@dataclass(frozen=True)
class ReportSettings:
    """What a report is about and where it goes.

    Attributes
    ----------
    document : str
        File of the document.
    output : str
        Folder of the report.
    """

    document: str
    output: str

    @property
    def folder(self):
        """str: folder of the document, which files are named below."""
        return os.path.dirname(self.document)

    def arguments(self):
        """list of str: arguments of ``report`` without those of the conversation with it."""
        return [self.document, f"--output={self.output}", *measuring_arguments(),
                "--profile", preference("Profile"), "--timeout", str(preference("Seconds")),
                *info_place_arguments(preference("InfoFolder"))]


def proposed_folder(document_file):
    """Folder of a report: beside the document and its info file."""
    return str(Path(document_file).with_suffix("")) + "-report"


class ReportDialog(QtWidgets.QDialog):
    """Where the report goes, how far it is, and whether to look at it; stays beside the work in FreeCAD."""

    def __init__(self, parent):
        super().__init__(parent)
        self.setObjectName("ThinPart_ReportDialog")
        self.setWindowTitle(translate("ThinPart", "Report"))
        self.setWindowIcon(QtGui.QIcon(str(ICON)))
        self._document = None
        self._failures = []
        self._run = FolderRun(self, "report")
        self._run.found.connect(self._take)
        self._run.ended.connect(self._show_end)
        self._installation = PackageInstallation(self)
        self._installation.ended.connect(self._show_installed)
        column = QtWidgets.QVBoxLayout(self)
        self._subject = text_line(self, column, "ThinPart_ReportSubject")
        self._add_folder(column)
        self._open = QtWidgets.QCheckBox(
            translate("ThinPart", "&Open it in the browser when it is ready"), self)
        self._open.setObjectName("ThinPart_ReportOpen")
        self._open.setChecked(True)
        column.addWidget(self._open)
        self._bar = QtWidgets.QProgressBar(self)
        self._bar.setObjectName("ThinPart_ReportProgress")
        self._bar.setRange(0, 0)
        column.addWidget(self._bar)
        self._message = text_line(self, column, "ThinPart_ReportMessage")
        self._add_buttons(column)
        self._show_state()

    def show_document(self, document):
        """Be about a document, unless one is being reported on."""
        if self._is_busy or document is None:
            return
        self._document = document.Name
        show_text(self._subject, translate(
            "ThinPart", "Report about all parts of '{}'").format(document.Label))
        self._folder.setText(proposed_folder(document.FileName) if document.FileName else "")
        self._say("")
        self._show_state()

    def start(self):
        """Write the report about the document as it was saved."""
        problem = self._problem() or self._lacking()
        if problem:
            self._say(problem)
            self._show_state()
            return
        document = App.getDocument(self._document)
        output = self._folder.text().strip() or proposed_folder(document.FileName)
        self._folder.setText(output)
        self._failures = []
        self._output = os.path.abspath(os.path.join(os.path.dirname(document.FileName), output))
        try:
            self._run.start(ReportSettings(os.path.abspath(document.FileName), self._output))
        except ThinPartError as error:
            self._say(translated(error))
        else:
            self._say(translate("ThinPart", "Measuring and drawing\u2026"))
        self._show_state()

    def save(self):
        """Have FreeCAD save the document, by its own dialog where it has no file yet."""
        if self._document in App.listDocuments():
            App.setActiveDocument(self._document)
            Gui.runCommand("Std_Save")
            document = App.getDocument(self._document)
            if document.FileName and not self._folder.text():
                self._folder.setText(proposed_folder(document.FileName))
        self._say(self._problem())
        self._show_state()

    def install(self):
        """Install what reports need, and write the report then."""
        try:
            self._installation.start(_PACKAGE)
        except ThinPartError as error:
            self._say(translated(error))
        else:
            self._say(translate("ThinPart", "Installing {}\u2026").format(_PACKAGE))
        self._show_state()

    def cancel(self):
        """Stop; the pages that are written stay."""
        if self._installation.is_running:
            self._installation.stop()
            self._say(translate("ThinPart", "Stopped before the end, as asked."))
            self._show_state()
            return
        self._run.stop()
        self._say(translate("ThinPart", "Stopping\u2026"))

    def open_report(self):
        """Show the report in the browser."""
        QtGui.QDesktopServices.openUrl(QtCore.QUrl.fromLocalFile(os.path.join(self._output, OVERVIEW)))

    def end(self):
        """Stop at once and go, since there is no one left to ask."""
        self._installation.stop()
        self._run.end_now()
        self.hide()
        self.deleteLater()

    def _problem(self):
        """Why no report can be written now, one sentence; empty where it can."""
        if self._document not in App.listDocuments():
            return translate("ThinPart", "The document is closed: open it again for a report about it.")
        document = App.getDocument(self._document)
        if not document.FileName or not os.path.exists(document.FileName):
            return translate("ThinPart", "The document has never been saved. Save the document first.")
        if OBSERVER.differs_from_file(document):
            return translate("ThinPart", "The document has changes that are not saved. Save the document first.")
        return ""

    @property
    def _is_busy(self):
        return self._run.is_running or self._installation.is_running

    @staticmethod
    def _lacking():
        """What a report needs and this FreeCAD has not, one sentence; else empty."""
        if has_package(_PACKAGE.lower()):
            return ""
        return translate("ThinPart", "Reports need the Python package {}, which this FreeCAD does not have: install "
                                     "it from the internet into {}?").format(_PACKAGE, install_folder())

    def _show_installed(self, problem):
        if problem:
            self._say(problem)
            self._show_state()
        else:
            self.start()

    def _take(self, rows):
        self._failures += [translated(row.error) for row in rows if row.error_kind]

    def _show_end(self, end):
        self._show_state()
        if end.how == STOPPED:
            self._say(translate("ThinPart", "Stopped before the end, as asked."))
        elif end.how != DONE:
            self._say(end.sentence)
        else:
            self._say(self._summary())
            self._look.setEnabled(True)
            if self._open.isChecked():
                self.open_report()

    def _summary(self):
        ready = translate("ThinPart", "The report is in {}.").format(self._output)
        if not self._failures:
            return ready
        failed = translate("ThinPart", "Not measured: {}").format(" ".join(self._failures[:3]))
        return f"{ready} {failed}"

    def _say(self, text):
        show_text(self._message, text)

    def _show_state(self):
        running = self._is_busy
        self._bar.setVisible(running)
        self._start.setEnabled(not running)
        self._cancel.setEnabled(running)
        self._save.setVisible(not running and bool(self._document) and bool(self._problem()))
        self._install.setVisible(not running and bool(self._lacking()))
        for each in (self._folder, self._browse):
            each.setEnabled(not running)
        self._look.setEnabled(False)

    def _choose(self):
        folder = QtWidgets.QFileDialog.getExistingDirectory(
            self, translate("ThinPart", "Folder of the report"), os.path.dirname(self._folder.text()))
        if folder:
            self._folder.setText(folder)

    def _add_folder(self, column):
        row = QtWidgets.QHBoxLayout()
        label = QtWidgets.QLabel(translate("ThinPart", "&Folder:"), self)
        self._folder = QtWidgets.QLineEdit(self)
        self._folder.setObjectName("ThinPart_ReportFolder")
        self._folder.setMinimumWidth(380)
        label.setBuddy(self._folder)
        row.addWidget(label)
        row.addWidget(self._folder)
        self._browse = add_button(
            row, self, "ThinPart_ReportBrowse", translate("ThinPart", "&Browse\u2026"), self._choose)
        column.addLayout(row)

    def _add_buttons(self, column):
        row = QtWidgets.QHBoxLayout()

        def button(name, text, act):
            made = add_button(row, self, name, text, act)
            made.setAutoDefault(False)
            return made

        self._save = button("ThinPart_ReportSave", translate("ThinPart", "&Save the document"), self.save)
        self._install = button(
            "ThinPart_ReportInstall", translate("ThinPart", "&Install {}").format(_PACKAGE), self.install)
        row.addStretch(1)
        self._start = button("ThinPart_ReportStart", translate("ThinPart", "&Write report"), self.start)
        self._start.setDefault(True)
        self._cancel = button("ThinPart_ReportCancel", translate("ThinPart", "&Cancel"), self.cancel)
        self._look = button("ThinPart_ReportLook", translate("ThinPart", "&Open report"), self.open_report)
        button("ThinPart_ReportClose", translate("ThinPart", "Close"), self.close)
        column.addLayout(row)
