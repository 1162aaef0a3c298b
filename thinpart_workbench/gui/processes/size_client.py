# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measures a part and asks for element sizes and meshes, in another process."""

import shutil
import tempfile

from ...freecad_adapter.objects.fem_mesh import preferred_gmsh
from ...freecad_adapter.objects.snapshot import write_snapshot
from ...freecad_adapter.preferences import preference
from ..application.qt import QtCore, Signal, translate
from ..application.sentences import translated
from .conversation import Conversation
from .snapshot_job import disk_full_error


class SizeClient(QtCore.QObject):
    """One part, measured once; of several proposals that are asked for, only the last is answered.

    Parameters
    ----------
    document : FreeCAD.Document or None
        The one of the part.
    parent : QObject, optional

    Attributes
    ----------
    name : str or None
        Of the document.
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

    def __init__(self, document, parent=None):
        super().__init__(parent)
        self.name, self.folder = document.Name if document is not None else None, None
        self._job = {"megabytes": preference("MemoryMegabytes"), "gmsh": preferred_gmsh()}
        self._process = Conversation("size_worker", self)
        self._process.received.connect(self._on_answer)
        self._process.finished.connect(self._on_finished)
        self._next = None  # the request that is to be sent
        self._is_asked = self._is_meshing = self._is_measured = False

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
        """Write a part to a temporary folder and measure it; a ThinPartError says that the disk is full."""
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
        self._is_asked = self._is_meshing = self._is_measured = False
        self._next = None
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
        if self._next is not None and not self._is_asked and self._is_measured:
            self._is_asked, request, self._next = True, self._next, None
            self._process.send(**request)

    def _on_answer(self, answer):
        if "progress" in answer:
            self.progressed.emit(answer["progress"])
        elif "measured" in answer:
            self._is_measured = True
            self.measured.emit(answer["measured"])
            self._send_next()
        else:
            self._is_asked, is_outdated = False, self._next is not None
            self._send_next()
            if "proposed" not in answer:
                self._is_meshing = False
            if "meshed" in answer:
                self.meshed.emit(answer["meshed"])
            elif "shelled" in answer:
                self.shelled.emit(answer["shelled"])
            elif "refused" in answer:
                self.refused.emit(translated(answer["refused"]))
            elif not is_outdated:
                self.proposed.emit(answer["proposed"])

    def _on_finished(self, sentence):
        self._is_meshing = self._is_measured = False
        self.ended.emit(sentence or translate("ThinPart", "The worker process ended unexpectedly."))
