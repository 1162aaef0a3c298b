# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sizes and poor elements of a part, or its shell, in the 3D views of its document."""

import FreeCADGui as Gui
import numpy as np

from ..application import lifelong
from ..application.qt import QtCore, QtWidgets
from ..scene.document_views import views_of
from ..view3d.covered_sources import CoveredSources
from .size_nodes import SizeNodes


class SizeView(QtCore.QObject):
    """What is drawn of a PartToMesh, in views that are opened later too."""

    def __init__(self, part, parent):
        super().__init__(parent)
        self._part, self._name = part, part.document.Name
        self._nodes, self._covered = None, CoveredSources()
        self._views = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        self._views.subWindowActivated.connect(self._on_view)

    def show_sizes(self, corners, colours, normals):
        """Colour the surface: ndarrays of shape (m, 3, 3), mm, uint8 and unit vectors."""
        self._shown().show_sizes(corners, colours, normals)
        self._set_aside(False)

    def show_shell(self, corners, colours):
        """Draw the shell in place of the part: ndarrays of shape (m, 3, 3), mm, and (m, 3), uint8."""
        sides = corners[:, 1:] - corners[:, :1]
        normals = np.cross(sides[:, 0], sides[:, 1])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(np.float32).tiny)
        self._shown().show_sizes(
            corners, *(np.repeat(each[:, None], 3, axis=1) for each in (colours, normals)), has_edges=True)
        self._set_aside(True)

    def hide(self):
        """Draw neither."""
        self._shown().hide_sizes()
        self._set_aside(None)

    def show_poor(self, corners):
        """Draw poor elements: see `poor_elements`; an empty sequence for none."""
        self._shown().show_poor(corners)

    def leave(self):
        """Draw nothing any more."""
        self._views.subWindowActivated.disconnect(self._on_view)
        nodes, self._nodes = self._nodes, None
        self._set_aside(None)
        if nodes is not None:
            nodes.leave(self._scenes())

    def _shown(self):
        if self._nodes is None:
            self._nodes = SizeNodes(self._part.shown_at)
        self._nodes.show_in(self._scenes())
        return self._nodes

    def _set_aside(self, shows_shell):
        """Hide what covers a shell, and thickness maps; None where nothing is coloured."""
        self._covered.cover(self._part.covering() if shows_shell else set())
        # A colour bar of thicknesses beside colours of sizes would be read as theirs.
        lifelong.map_events.set_maps_aside(self._name, shows_shell)

    def _on_view(self, *_):
        # A view that was just made is in the list of the document's views a moment later.
        QtCore.QTimer.singleShot(0, self._show_in_new_views)

    def _show_in_new_views(self):
        if self._nodes is not None:
            self._nodes.show_in(self._scenes())

    def _scenes(self):
        return [view.getSceneGraph() for view in views_of(self._name)]
