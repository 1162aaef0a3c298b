# SPDX-License-Identifier: LGPL-2.1-or-later
"""Events about thickness maps: refresh, measurement and panel requests. The handlers register themselves."""

import sys

from ...core.hook import Hook
from ...freecad_adapter.guard import report_fault
from ..application.qt import QtCore

_MAPS = "thinpart_workbench.freecad_adapter.objects.thickness_object"


class MapEvents:
    """Schedules a refresh of all maps after any change, and forwards requests for single maps.

    Attributes
    ----------
    refresh_due : Hook
        Called when the maps should be refreshed.
    measure_requested : Hook
        Called with the document name and object name of a map to be measured again.
    panel_requested : Hook
        Called with a map whose panel should be opened.
    first_colours : dict
        The FirstColours that are shown, by the name of their document.
    set_aside : dict
        By the name of each document in whose views other colours are shown than those of its maps, whether the maps are
        hidden too; their colour bars and labels are.
    shown_again : set
        ``(document, object)`` names of objects that the user has shown since a map covered them, and that it is to cover
        again at the next refresh.
    """

    def __init__(self):
        self.refresh_due, self.measure_requested, self.panel_requested = [Hook(report_fault) for _ in range(3)]
        self.first_colours, self.set_aside, self.shown_again = {}, {}, set()
        self._soon = QtCore.QTimer(singleShot=True, interval=0)
        self._soon.timeout.connect(lambda: self.refresh_due())

    def refresh_soon(self):
        """Refresh the maps when FreeCAD returns to the event loop; does nothing if there are no maps."""
        # FreeCAD imports this module with the first map; the import also loads numpy.
        if _MAPS in sys.modules:
            self._soon.start()

    def cover_again(self, names):
        """Cover the sources of a map also where the user has shown them: ``(document, object)`` names."""
        self.shown_again.update(names)
        self.refresh_soon()

    def set_maps_aside(self, name, hides_maps):
        """Leave the views of a document to other colours; None for `hides_maps` gives them back to its maps."""
        before = self.set_aside.pop(name, None)
        if hides_maps is not None:
            self.set_aside[name] = hides_maps
        if hides_maps != before:
            self.refresh_soon()

    def request_measurement(self, thickness):
        """Request that a map be measured again when FreeCAD returns to the event loop."""
        document, name = thickness.Document.Name, thickness.Name
        # The object may be deleted by then, so handlers get names.
        QtCore.QTimer.singleShot(0, lambda: self.measure_requested(document, name))

    def request_panel(self, thickness):
        """Request the panel of a map."""
        self.panel_requested(thickness)

    def recomputed(self, thickness, is_to_be_measured):
        """Move the view of a recomputed map with its sources, and request a measurement if one is due."""
        view = getattr(getattr(thickness, "ViewObject", None), "Proxy", None)
        if not hasattr(view, "move"):
            return  # saved without a window, and not refreshed yet
        view.move()
        if is_to_be_measured:
            self.request_measurement(thickness)
