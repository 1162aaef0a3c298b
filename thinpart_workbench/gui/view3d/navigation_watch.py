# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws large maps with fewer facets for as long as the user turns, shifts or zooms the view."""

import FreeCAD as App

from ...freecad_adapter.guard import guarded_methods
from ...freecad_adapter.objects.thickness_object import thickness_objects
from ..application.qt import QtCore

_STILL = 250
"""Milliseconds without a movement after which all facets are drawn again."""


@guarded_methods(eventFilter=False)
class NavigationWatch(QtCore.QObject):
    """Watches the mouse over one 3D view of a document, by the name of that.

    Notes
    -----
    Only what the user does with the mouse counts. Cameras that a program moves are followed by saved pictures, which show
    all facets.
    """

    def __init__(self, view, name):
        widget = view.graphicsView().viewport()
        super().__init__(widget)  # it ends with the view
        self._view, self._name, self._root = view, name, view.getSceneGraph()
        self._pressed_at = None  # where the camera was when a button was pressed that still is
        self._timer = QtCore.QTimer(self, singleShot=True, interval=_STILL)
        self._timer.timeout.connect(self._on_still)
        widget.installEventFilter(self)

    def is_in(self, root):
        """Whether this is the watch of the view with a scene graph."""
        return int(self._root.this) == int(root.this)

    def end(self):
        """Watch no longer; the view may be gone already."""
        try:
            self._timer.stop()
            self.parent().removeEventFilter(self)
            self.deleteLater()
        except RuntimeError:
            return

    def eventFilter(self, _widget, event):
        """Notice movements; never keeps an event from FreeCAD."""
        kind = event.type()
        if kind == QtCore.QEvent.MouseButtonPress:
            self._pressed_at = self._camera()
        elif kind == QtCore.QEvent.MouseButtonRelease or (kind == QtCore.QEvent.MouseMove and not event.buttons()):
            self._pressed_at = None
        elif kind == QtCore.QEvent.Wheel or (
                kind == QtCore.QEvent.MouseMove and self._pressed_at not in (None, self._camera())):
            if not self._timer.isActive():
                self._coarsen(True)
            self._timer.start()
        return False

    def _on_still(self):
        if self._pressed_at is None:
            self._coarsen(False)
        else:
            self._timer.start()  # not between two movements, where each takes long to draw

    def _camera(self):
        camera = self._view.getCameraNode()
        lens = camera.height if hasattr(camera, "height") else camera.heightAngle
        return camera.position.getValue().getValue(), camera.orientation.getValue().getValue(), lens.getValue()

    def _coarsen(self, is_coarse):
        if self._name in App.listDocuments():
            for thickness in thickness_objects(App.getDocument(self._name)):
                view = getattr(thickness.ViewObject, "Proxy", None)
                if hasattr(view, "coarsen"):
                    view.coarsen(is_coarse)
