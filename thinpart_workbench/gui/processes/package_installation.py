"""Installs Python packages that FreeCAD's bundle lacks, in the folder that its Addon Manager uses."""

import os
import tempfile
from collections import deque

from ...core.errors import ThinPartError
from ...freecad_adapter.additional_packages import install_folder
from ...system.exit_cause import ExitCause
from ..application import lifelong
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from .child_process import ChildProcess
from .freecad_python import python_program

_NO_NETWORK = ("NewConnectionError", "ConnectTimeoutError", "ReadTimeoutError", "No matching distribution",
               "ProxyError", "SSLError")
"""Found in pip's output when it cannot reach the index."""

_LAST_LINES = 400
"""Lines of pip's output that are kept: the error is at the end."""


class PackageInstallation(QtCore.QObject):
    """Runs pip in another process, so that FreeCAD stays responsive.

    Signals
    -------
    ended(str)
        Empty on success, else one sentence. Not emitted after `stop`.
    """

    ended = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._process = ChildProcess(self)
        self._package = ""
        self._output = deque(maxlen=_LAST_LINES)
        self._process.line.connect(self._output.append)
        self._process.error_line.connect(self._output.append)
        self._process.ended.connect(self._on_ended)
        self._process.failed_to_start.connect(lambda: self.ended.emit(
            translate("ThinPart", "The installation process could not be started.")))

    @property
    def is_running(self):
        """Whether pip is running."""
        return self._process.is_running

    def start(self, package):
        """Install a package, by its name in the index, and its dependencies.

        Returns what to show: that it is being installed, or why it cannot be, such as where there is no Python.
        """
        try:
            self._start(package)
        except ThinPartError as error:
            return translated(error)
        return translate("ThinPart", "Installing {}\u2026").format(package)

    def _start(self, package):
        python_program()  # first, so that no folder is created where there is no Python
        folder = install_folder()
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise ThinPartError(translate(
                "ThinPart", "The folder {} for Python packages cannot be created ({}): {} was not installed."
            ).format(folder, error.strerror, package), "failed") from None
        self._package = package
        self._output.clear()
        self._process.start("pip", [
            "install", "--disable-pip-version-check", "--no-input", "--retries", "1", "--target", folder, package],
            folder=tempfile.gettempdir())

    def stop(self):
        """End pip, if it is running."""
        self._process.end_now()

    def _on_ended(self, end):
        if end.cause() is ExitCause.WELL:
            self.ended.emit("")
        else:
            lifelong.notifications.report_output(self._output_text())
            self.ended.emit(self._reason())

    def _output_text(self):
        return b"\n".join(self._output).decode("utf-8", "replace")

    def _reason(self):
        output = self._output_text()
        if "No module named pip" in output:
            return translate(
                "ThinPart", "FreeCAD's Python has no pip, so {} was not installed: install it into {} by another "
                "Python's 'pip install --target'.").format(self._package, install_folder())
        if any(sign in output for sign in _NO_NETWORK):
            return translate(
                "ThinPart", "{} was not found in the index of Python packages: connect this computer to the "
                "internet, or set up pip's proxy, and try again.").format(self._package)
        return translate(
            "ThinPart", "pip could not install {}; the report view shows its output.").format(self._package)
