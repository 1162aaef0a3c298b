# SPDX-License-Identifier: LGPL-2.1-or-later
"""What differs between a part of a document and one of a library: found in another process, shown in the 3D views."""

import shutil
import tempfile

import FreeCADGui as Gui

from ...api.window.open_parts import SourcesState
from ...api.window.part_difference import shown_difference
from ...freecad_adapter.objects.snapshot import write_snapshot
from ...freecad_adapter.objects.thickness_object import thickness_objects
from ...freecad_adapter.occurrences.occurrences import occurrence_matrices, sources_of
from ...freecad_adapter.preferences import preference, preferred_analysis
from ..application import lifelong
from ..application.qt import QtCore, QtWidgets, Signal
from ..processes.request_queue import RequestQueue
from ..processes.snapshot_job import disk_full_error
from ..scene.document_views import views_of
from ..view3d.covered_sources import CoveredSources
from ..view3d.difference_nodes import DifferenceNodes

_FUNCTION = "window.part_difference.write_difference"


class PartDifference(QtCore.QObject):
    """Shows one difference at a time. It ends by itself when its part changes, and when a thickness map is shown.

    Signals
    -------
    changed(object, str)
        It is looked for, is shown, or is neither any more: what `write_difference` says of the one that is shown, else None,
        and why there is none where it cannot be found.
    """

    changed = Signal(object, str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._queue = RequestQueue("difference", parent=self)
        self._queue.answered.connect(self._on_answered)
        self._request = self._folder = self._nodes = None
        self._document = self._state = self._matrices = None
        self._name, self._hidden, self._visible = "", set(), set()
        self._covered = CoveredSources()
        self._views = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        self._views.subWindowActivated.connect(self._on_view)
        lifelong.map_events.refresh_due.add(self._check)

    @property
    def is_running(self):
        """Whether the difference is looked for."""
        return self._request is not None

    @property
    def is_shown(self):
        """Whether the difference is in the views."""
        return self._nodes is not None

    def start(self, document, part, measured, others, own, known):
        """Look for the difference and show it; a ThinPartError says that the disk is full.

        Parameters
        ----------
        document : FreeCAD.Document
        part, measured : SolidPart or MeshedPart
            As it is in the document, and as it was measured.
        others : list of SolidPart or MeshedPart
            The other parts of the document.
        own, known : dict
            The two parts, see `write_difference`: of the other one ``file``, ``info_file`` and ``name``.
        """
        self._end()
        self._document, self._name = document, document.Name
        sources = sources_of(document, [part])
        self._state = SourcesState(sources)
        self._matrices = occurrence_matrices(document, part, measured)
        # An object that shows other parts too stays.
        self._hidden = {(each.Document.Name, each.Name) for each in sources if each not in sources_of(document, others)}
        try:
            self._folder = tempfile.mkdtemp(prefix="thinpart-")
            list(write_snapshot([measured], self._folder, preferred_analysis(), {}))
        except Exception as error:  # FreeCAD raises its own exception classes where a disk is full
            self._end()
            raise disk_full_error(error) from None
        self._request = self._queue.ask(
            _FUNCTION, snapshot=self._folder, own=own, seconds=preference("Seconds"),
            megabytes=preference("MemoryMegabytes"), **{key: known[key] for key in ("file", "info_file", "name")})
        self.changed.emit(None, "")

    def end(self):
        """Show nothing any more, and look for nothing."""
        if self.is_running or self.is_shown:
            self._end()
            self.changed.emit(None, "")

    def leave(self):
        """End for good: the panel is closed."""
        self._end()
        self._views.subWindowActivated.disconnect(self._on_view)
        lifelong.map_events.refresh_due.remove(self._check)

    def _end(self):
        if self._request is not None:
            self._queue.cancel(self._request)
        nodes, self._request, self._nodes = self._nodes, None, None
        if nodes is not None:
            self._covered.cover(set())
            lifelong.map_events.set_maps_aside(self._name, None)
            nodes.leave(self._scenes())
        self._remove_folder()

    def _on_answered(self, request):
        if request is not self._request:
            return
        self._request = None
        if request.sentence or not self._is_unchanged():
            self._end()
            self.changed.emit(None, request.sentence)
            return
        self._show(*shown_difference(self._folder))
        self._remove_folder()
        self.changed.emit(request.answer, "")

    def _show(self, part, other):
        self._nodes = DifferenceNodes(part, other, self._matrices, bool(self._hidden))
        self._nodes.show_in(self._scenes())
        self._visible = self._visible_maps()
        self._covered.cover(self._hidden)
        lifelong.map_events.set_maps_aside(self._name, True)

    def _check(self):
        """End what is out of date."""
        if not (self.is_running or self.is_shown):
            return
        if not self._is_unchanged() or self.is_shown and self._visible_maps() - self._visible:
            self.end()

    def _is_unchanged(self):
        try:
            return self._state.is_unchanged
        except ReferenceError:
            return False  # an object was deleted

    def _visible_maps(self):
        return {each.Name for each in thickness_objects(self._document) if each.ViewObject.Visibility}

    def _on_view(self, *_):
        # A view that was just made is in the list of the document's views a moment later.
        QtCore.QTimer.singleShot(0, self._show_in_new_views)

    def _show_in_new_views(self):
        if self._nodes is not None:
            self._nodes.show_in(self._scenes())

    def _scenes(self):
        return [view.getSceneGraph() for view in views_of(self._name)]

    def _remove_folder(self):
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)
            self._folder = None
