# SPDX-License-Identifier: LGPL-2.1-or-later
"""Connects the fields of the section plane with a map."""

import numpy as np

from ...core.maps.map_section import SectionPlane, section_extent
from ...freecad_adapter.objects.thickness_probes import moved_matrix
from ..scene.camera_flight import look_direction
from ..scene.document_views import view_of
from ..section.section_box import AXES, FROM_VIEW
from .map_presenter import MapPresenter


class SectionPresenter(MapPresenter):
    """Cuts a map where the user wants it; nothing of it is saved or undone. The map stays cut without the panel."""

    def __init__(self, thickness, shown, box, parent):
        super().__init__(thickness, shown, box, parent)
        self._connect((box.switched, self._switch), (box.direction_chosen, self._choose), (box.moved, self._move),
                      (box.flipped, self._flip))

    def show(self):
        """Show the section of the map in its fields."""
        plane, unit = self._view.section, self._shown.unit
        if plane is None:
            self._box.show_section(None, (0.0, 1.0), 0.0, unit)
            return
        direction, forward = _direction(plane)
        low, high = section_extent(self._shown.all, moved_matrix(self._thickness), forward)
        place = plane.offset if forward == plane.normal else -plane.offset
        self._box.show_section(direction, (min(low, place), max(high, place)), place, unit)

    def uncover(self, point):
        """Draw the map whole if a point in mm is cut off."""
        plane = self._view.section
        if plane is not None and plane.heights(point) > 0.0:
            self._switch(False)

    def _switch(self, is_on):
        if is_on:
            look = self._look()
            # Across the axis that faces the camera most.
            self._choose(max(AXES, key=lambda name: abs(np.dot(AXES[name], look))))
        else:
            self._cut(None)

    def _choose(self, direction):
        look = self._look()
        normal = tuple(map(float, -look)) if direction == FROM_VIEW else AXES[direction]
        if np.dot(normal, look) > 0.0:  # what faces the camera is cut off
            normal = tuple(-part for part in normal)
        low, high = section_extent(self._shown.all, moved_matrix(self._thickness), normal)
        self._cut(SectionPlane(normal, 0.5 * (low + high)))

    def _move(self, place):
        plane = self._view.section
        _, forward = _direction(plane)
        self._cut(SectionPlane(plane.normal, place if forward == plane.normal else -place))

    def _flip(self):
        plane = self._view.section
        self._cut(SectionPlane(tuple(-part for part in plane.normal), -plane.offset))

    def _cut(self, plane):
        self._view.section = plane
        self.show()

    def _look(self):
        view = view_of(self._thickness.Document)
        return np.array([0.0, 1.0, 0.0]) if view is None else look_direction(view)


def _direction(plane):
    """What the plane is called, and the normal along which its position counts: (str, tuple of float)."""
    for name, axis in AXES.items():
        if np.allclose(np.abs(plane.normal), axis, atol=1e-6):
            return name, plane.normal if np.dot(plane.normal, axis) > 0.0 else tuple(-part for part in plane.normal)
    return FROM_VIEW, plane.normal
