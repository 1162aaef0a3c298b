"""Measures a part and asks for element sizes and meshes, in another process."""

import shutil
import tempfile

from ...freecad_adapter.objects.snapshot import write_snapshot
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from .conversation import Conversation
from .snapshot_job import disk_full_error


class SizeClient(QtCore.QObject):
    """One part, measured once; of several proposals that are asked for, only the last is answered.

    Attributes
    ----------
    folder : str or None
        With the files of `api.window.part_sizes`, until `end`.

    Signals
    -------
    progressed(float)
    measured(object)
        See `size_worker`.
    proposed(object), meshed(object), shelled(object)
        The answer.
    refused(str)
        Why a request cannot be answered.
    ended(str)
        Why the process has ended; it may be started again.
    """

    progressed = Signal(float)
    measured = Signal(object)
    proposed = Signal(object)
    meshed = Signal(object)
    shelled = Signal(object)
    refused = Signal(str)
    ended = Signal(str)

    def __init__(self, megabytes, gmsh, parent=None):
        super().__init__(parent)
        self.folder = None
        self._job = {"megabytes": megabytes, "gmsh": gmsh}
        self._process = Conversation("size_worker", self)
        self._process.received.connect(self._on_answer)
        self._process.finished.connect(self._on_finished)
        self._number = self._asked = 0
        self._next = None
        self._is_meshing = self._is_measured = False

    @property
    def is_running(self):
        """Whether the part is being measured or meshed."""
        return self._process.is_running and (not self._is_measured or self._is_meshing)

    @property
    def is_meshing(self):
        """Whether a mesh or a shell is being made."""
        return self._is_meshing

    @property
    def is_ready(self):
        """Whether the part is measured, so that a request is answered."""
        return self._process.is_running and self._is_measured

    def start(self, part, settings, profile):
        """Write a part to a temporary folder and measure it.

        Raises
        ------
        ThinPartError
        """
        self.end()
        try:
            self.folder = tempfile.mkdtemp(prefix="thinpart-")
            list(write_snapshot([part], self.folder, settings, profile))
        except Exception as error:  # FreeCAD raises its own exception classes where a disk is full
            self.end()
            raise disk_full_error(error) from None
        self.restart()

    def restart(self):
        """Measure the part again, after its process was stopped."""
        self._process.end_now()
        self._is_meshing = self._is_measured = False
        self._asked, self._next = 0, None
        sentence = self._process.ensure_started()
        if sentence:
            self.ended.emit(sentence)
        else:
            self._process.send(folder=self.folder, **self._job)

    def ask(self, settings, sizes):
        """Ask for a proposal: see `PartSizes.proposed`."""
        self._next = {"settings": settings, "sizes_wanted": sizes}
        self._send_next()

    def mesh(self, settings, sizes):
        """Ask for a mesh: see `PartSizes.mesh`."""
        self._is_meshing = True
        self._next = {"settings": settings, "sizes_wanted": sizes, "mesh": True}
        self._send_next()

    def shell(self, settings):
        """Ask for a shell: see `PartSizes.shell`."""
        self._is_meshing = True
        self._next = {"shell": settings}
        self._send_next()

    def end(self):
        """End the process and remove its files."""
        self._is_meshing = self._is_measured = False
        self._process.end_now()
        if self.folder is not None:
            shutil.rmtree(self.folder, ignore_errors=True)
            self.folder = None

    def _send_next(self):
        if self._next is not None and not self._asked and self._is_measured:
            self._number += 1
            self._asked, request, self._next = self._number, self._next, None
            self._process.send(number=self._number, **request)

    def _on_answer(self, answer):
        if "progress" in answer:
            self.progressed.emit(answer["progress"])
        elif "measured" in answer:
            self._is_measured = True
            self.measured.emit(answer["measured"])
            self._send_next()
        elif answer.get("number") == self._asked:
            self._asked = 0
            is_outdated = self._next is not None
            self._send_next()
            if "meshed" in answer:
                self._is_meshing = False
                self.meshed.emit(answer["meshed"])
            elif "shelled" in answer:
                self._is_meshing = False
                self.shelled.emit(answer["shelled"])
            elif "refused" in answer:
                self._is_meshing = False
                self.refused.emit(translated(answer["refused"]))
            elif not is_outdated:
                self.proposed.emit(answer["proposed"])

    def _on_finished(self, sentence):
        self._is_meshing = self._is_measured = False
        self.ended.emit(sentence or translate("ThinPart", "The worker process ended unexpectedly."))
