"""A document that is being measured: its snapshot, and the process that works on it."""

import json
import shutil
import tempfile

import FreeCAD as App

from ..core.errors import ThinPartError
from ..freecad_adapter.snapshot import write_snapshot
from .qt import QtCore, QtWidgets, Signal, soon, translate
from .ready_process import READY
from .sentences import translated
from .worker_python import hand_over, listen

_OUT_OF_MEMORY = ("bad_alloc", "MemoryError", "Unable to allocate", "OutOfMemory", "length_error")


class DocumentRun(QtCore.QObject):
    """Measures the parts of a `DocumentAnalysis` in another process, so that FreeCAD never waits.

    Signals
    -------
    progressed(object)
        The worker's ``progress`` entry.
    measured(str)
        Name of a part of which the analysis now holds the record or the failure.
    mapped(str, str)
        Name of a part and the file with its thickness map, which is gone once this returns to the run.
    ended(str)
        Empty when all went well, else one sentence. Not sent after `stop`.
    """

    progressed = Signal(object)
    measured = Signal(str)
    mapped = Signal(str, str)
    ended = Signal(str)

    def __init__(self, analysis, megabytes, parent=None):
        super().__init__(parent)
        self._analysis = analysis
        self._megabytes = megabytes
        self._folder = None
        self._process = None
        self._errors = b""
        self._unwritten = iter(())

    @property
    def is_running(self):
        """Whether the process is at work."""
        return self._process is not None

    def start(self):
        """Write the snapshot and start the process.

        Raises
        ------
        ThinPartError
            When the snapshot cannot be written or there is no Python.
        """
        process = READY.take()
        try:
            self._folder = tempfile.mkdtemp(prefix="thinpart-")
            self._unwritten = write_snapshot(
                self._analysis.in_turn, self._folder, self._analysis.settings,
                self._analysis.profile_content, self._analysis.thin_limit, self._analysis.maps)
        except Exception as error:  # FreeCAD raises classes of its own where a disk is full
            process.kill()
            process.waitForFinished(3000)
            process.deleteLater()
            self._remove_folder()
            raise ThinPartError(translate(
                "ThinPart", "There is no room for temporary files ({}): nothing was measured."
            ).format(getattr(error, "strerror", None) or error), "failed") from None
        process.setParent(self)
        listen(process, self._read, self._read_errors, self._finished, self._failed_to_start)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self.stop)
        self._process = process
        process.write(json.dumps({"folder": self._folder, "megabytes": self._megabytes}).encode() + b"\n")
        self._write_on()

    def _write_on(self):
        """Write one more shape of the snapshot, and go on when the window has done what else there is."""
        if self._process is None:
            return
        try:
            next(self._unwritten)
        except Exception:  # the end; or there is no room for it, which FreeCAD says in classes of its own
            self._process.closeWriteChannel()
        else:
            soon(self, self._write_on)

    def stop(self):
        """End the process, if it runs, and remove what was written for it."""
        process, self._process = self._process, None
        if process is not None:
            QtWidgets.QApplication.instance().aboutToQuit.disconnect(self.stop)
            process.blockSignals(True)
            process.kill()
            process.waitForFinished(3000)
            process.deleteLater()
            READY.make_soon()
        self._unwritten = iter(())
        self._remove_folder()

    def _leave_process(self):
        """Nothing more comes: nobody waits until the process has cleared its memory away."""
        process, self._process = self._process, None
        QtWidgets.QApplication.instance().aboutToQuit.disconnect(self.stop)
        hand_over(process)
        process.finished.connect(process.deleteLater)
        process.kill()
        self._remove_folder()
        READY.make_soon()

    def _read(self):
        while self._process is not None and self._process.canReadLine():
            try:
                line = json.loads(bytes(self._process.readLine()))
            except ValueError:
                continue  # half a line, from a process that was killed: the end tells
            self._take(line)

    def _take(self, line):
        kind = self._analysis.take(line)
        if kind == "progress":
            self.progressed.emit(line["progress"])
        elif kind == "map":
            self.mapped.emit(line["map"]["part"], line["map"]["file"])
        elif kind == "done":
            self._leave_process()
            self.ended.emit("")
        else:
            name = line["record"]["name"] if kind == "record" else line["failure"]["part"]
            self.measured.emit(name)

    def _read_errors(self):
        if self._process is not None:
            self._errors += bytes(self._process.readAllStandardError())

    def _finished(self, *_):
        self._read()
        self._read_errors()
        if self._process is None:
            return  # whoever was told of the last line has stopped the run
        self.stop()
        App.Console.PrintLog(self._errors.decode("utf-8", "replace") + "\n")
        self.ended.emit(self._reason())

    def _failed_to_start(self, error):
        if error == QtCore.QProcess.FailedToStart:
            self.stop()
            self.ended.emit(translate(
                "ThinPart", "The process that measures could not be started."
            ))

    def _reason(self):
        errors = self._errors.decode("utf-8", "replace")
        if any(sign in errors for sign in _OUT_OF_MEMORY):
            return translate(
                "ThinPart", "Measuring needs more than {} MB of memory: raise the limit in the "
                "preferences.",
            ).format(self._megabytes)
        name, found, message = errors.strip().rpartition("\n")[2].partition("ThinPartError: ")
        if found and not name.strip().strip("abcdefghijklmnopqrstuvwxyz_."):
            return translated(message)
        return translate(
            "ThinPart", "The process that measures ended unexpectedly; the document is unharmed. "
            "Check the part with 'Check geometry' of the Part workbench.",
        )

    def _remove_folder(self):
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)
            self._folder = None
