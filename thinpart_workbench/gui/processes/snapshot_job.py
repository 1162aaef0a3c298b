# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures a document in another process, which works on a snapshot of it."""

import shutil
import tempfile

from ...core.errors import ThinPartError
from ...core.problem import NOT_WRITTEN_BY_FREECAD, problem_of
from ...freecad_adapter.objects.snapshot import write_snapshot
from ..application import lifelong
from ..application.qt import QtCore, Signal, call_later, translate
from ..application.sentences import translated


class SnapshotJob(QtCore.QObject):
    """Measures the parts of a `DocumentAnalysis` in another process, so that FreeCAD stays responsive.

    Parameters
    ----------
    analysis : DocumentAnalysis
    megabytes : int
        Limit of the address space.
    parent : QObject, optional
    report : dict, optional
        The parameters of `OpenDocumentReport` besides those of the snapshot: a report is written instead of maps.

    Signals
    -------
    progressed(object)
        The worker's ``progress`` entry.
    measured(str)
        Name of a part whose record or failure is now in the analysis.
    mapped(str, str)
        Name of a part and the path of its thickness map, a temporary file that exists only while the slots run.
    first_mapped(str, str)
        The same of its coarse map, before any part is measured.
    ended(str)
        Empty on success, else one sentence. Not emitted after `stop`.
    """

    progressed = Signal(object)
    measured = Signal(str)
    mapped = Signal(str, str)
    first_mapped = Signal(str, str)
    ended = Signal(str)

    def __init__(self, analysis, megabytes, parent=None, report=None):
        super().__init__(parent)
        self._analysis = analysis
        self._megabytes = megabytes
        self._request = {"megabytes": megabytes, **({} if report is None else {"report": report})}
        self._folder = None
        self._process = None
        self._pending_shapes = iter(())

    @property
    def is_running(self):
        """Whether the process is running."""
        return self._process is not None

    def start(self):
        """Write the snapshot and start the process.

        Raises
        ------
        ThinPartError
            When the snapshot cannot be written or there is no Python.
        """
        process = lifelong.standby_worker.take()
        try:
            self._folder = tempfile.mkdtemp(prefix="thinpart-")
            self._pending_shapes = write_snapshot(
                self._analysis.measuring_order, self._folder, self._analysis.settings,
                self._analysis.profile_content, self._analysis.thin_limit, self._analysis.maps,
                self._analysis.first_maps)
        except Exception as error:  # FreeCAD raises its own exception classes where a disk is full
            process.end_now()
            process.deleteLater()
            self._remove_folder()
            raise disk_full_error(error) from None
        if not process.is_running:
            self._remove_folder()
            raise ThinPartError(process.not_started(), "failed")
        process.setParent(self)
        process.received.connect(self._on_message)
        process.finished.connect(self.ended)
        process.released.connect(self._on_released)
        self._process = process
        process.megabytes = self._megabytes
        process.send(folder=self._folder, **self._request)
        call_later(self, self._write_next_shape)

    def _write_next_shape(self):
        """Write one shape of the snapshot, then let the event loop run before the next one."""
        if self._process is None:
            return
        try:
            next(self._pending_shapes)
        except StopIteration:
            self._process.close_input()
        except Exception as error:  # FreeCAD raises its own exception classes where a disk is full
            self.stop()
            self.ended.emit(disk_full_error(error).args[0])
        else:
            call_later(self, self._write_next_shape)

    def stop(self):
        """End the process, if it is running, and remove its snapshot."""
        if self._process is not None:
            # The system may take long to free the memory of the process, which is not waited for.
            self._process.detach(kill=True)

    def _on_message(self, message):
        kind = self._analysis.on_message(message)
        if kind == "progress":
            self.progressed.emit(message["progress"])
        elif kind == "map":
            self.mapped.emit(message["map"]["part"], message["map"]["file"])
        elif kind == "first_map":
            self.first_mapped.emit(message["first_map"]["part"], message["first_map"]["file"])
        elif kind == "done":
            # No further message comes; do not wait until the process has freed its memory.
            self._process.detach(kill=True)
            self.ended.emit("")
        else:
            name = message["record"]["name"] if kind == "record" else message["failure"]["part"]
            self.measured.emit(name)

    def _on_released(self):
        """Clean up after the process, and prepare the next one."""
        process, self._process = self._process, None
        process.deleteLater()
        self._pending_shapes = iter(())
        self._remove_folder()
        lifelong.standby_worker.prepare_next()

    def _remove_folder(self):
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)
            self._folder = None


def disk_full_error(error):
    """ThinPartError for a snapshot that could not be written: FreeCAD raises its own exception classes."""
    return ThinPartError(translate(
        "ThinPart", "Temporary files cannot be written ({}): free some disk space. Nothing was measured."
    ).format(translated(problem_of(error, NOT_WRITTEN_BY_FREECAD))), "failed")
