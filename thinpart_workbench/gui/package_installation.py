"""Python packages that FreeCAD's bundle lacks, installed where its Addon Manager puts them."""

import os
import tempfile

from ..core.errors import ThinPartError
from ..freecad_adapter.additional_packages import install_folder
from .notices import NOTICES
from .qt import QtCore, QtWidgets, Signal, translate
from .worker_python import listen, new_process, python_program, start_module

_NO_NETWORK = ("NewConnectionError", "ConnectTimeoutError", "ReadTimeoutError", "No matching distribution",
               "ProxyError", "SSLError")
"""In what pip says where it does not reach the index."""


class PackageInstallation(QtCore.QObject):
    """pip at work in another process, so that FreeCAD goes on meanwhile.

    Signals
    -------
    ended(str)
        Empty when all went well, else one sentence. Not sent after `stop`.
    """

    ended = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._process = None
        self._package = ""
        self._said = b""

    @property
    def is_running(self):
        """Whether pip is at work."""
        return self._process is not None

    def start(self, package):
        """Install a package and what it needs.

        Parameters
        ----------
        package : str
            Its name in the index.

        Raises
        ------
        ThinPartError
            Where there is no Python, or no place for the package.
        """
        program, folder = python_program(), install_folder()
        try:
            os.makedirs(folder, exist_ok=True)
        except OSError as error:
            raise ThinPartError(translate(
                "ThinPart", "The folder {} for Python packages cannot be made ({}): {} was not installed."
            ).format(folder, error.strerror, package), "failed") from None
        self._package, self._said = package, b""
        process = new_process(self)
        process.setWorkingDirectory(tempfile.gettempdir())
        listen(process, self._read, self._read, self._finished, self._failed_to_start)
        # Set first: a program that cannot be started may say so before `start` returns.
        self._process = process
        QtWidgets.QApplication.instance().aboutToQuit.connect(self.stop)
        start_module(process, program, "pip", [
            "install", "--disable-pip-version-check", "--no-input", "--retries", "1", "--target", folder, package])

    def stop(self):
        """End pip, if it runs."""
        process = self._clear()
        if process is not None:
            process.blockSignals(True)
            process.kill()
            process.waitForFinished(3000)

    def _read(self):
        if self._process is not None:
            self._said += bytes(self._process.readAllStandardOutput()) + bytes(self._process.readAllStandardError())

    def _finished(self, *_):
        self._read()
        process = self._clear()
        if process is None:
            return  # it could not even be started
        if process.exitStatus() == QtCore.QProcess.NormalExit and process.exitCode() == 0:
            self.ended.emit("")
        else:
            NOTICES.quote(self._said.decode("utf-8", "replace"))
            self.ended.emit(self._reason())

    def _failed_to_start(self, error):
        if error == QtCore.QProcess.FailedToStart and self._clear() is not None:
            self.ended.emit(translate("ThinPart", "The process that installs could not be started."))

    def _reason(self):
        said = self._said.decode("utf-8", "replace")
        if "No module named pip" in said:
            return translate(
                "ThinPart", "FreeCAD's Python has no pip, so {} was not installed: install it into {} by another "
                "Python's 'pip install --target'.").format(self._package, install_folder())
        if any(sign in said for sign in _NO_NETWORK):
            return translate(
                "ThinPart", "{} was not found in the index of Python packages: connect this computer to the "
                "internet, or set up pip's proxy, and try again.").format(self._package)
        return translate(
            "ThinPart", "pip could not install {}; the report view has its words.").format(self._package)

    def _clear(self):
        process, self._process = self._process, None
        if process is not None:
            QtWidgets.QApplication.instance().aboutToQuit.disconnect(self.stop)
            process.deleteLater()
        return process
