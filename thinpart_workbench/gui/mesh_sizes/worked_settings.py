# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings that worked for a part or for one like it: offered, and kept once they have worked."""

from ...api.window.part_sizes import rows_to_keep
from ...core.number_text import percent
from ...core.sizing.sizing_settings import LAYERS_OF_ORDER
from ..application import lifelong
from ..application.numbers import marked
from ..application.qt import QtCore, Signal, grouped, translate


class WorkedSettings(QtCore.QObject):
    """Looks for settings for a part of a document, and keeps those of a mesh.

    Signals
    -------
    found(str)
        A sentence about settings that worked.
    """

    found = Signal(str)

    def __init__(self, document, parent):
        super().__init__(parent)
        self._document, self._offer, self._request = document, None, None
        lifelong.requests.answered.connect(self._on_answered)

    def look_for(self, record):
        """Look for settings for a part, by its record."""
        self._request = lifelong.requests.ask("document_info.settings_for", record=record, document=self._document.FileName)

    def offered(self):
        """The settings, dict, and the sizes of walls, list of pairs, that were found."""
        settings = self._offer["settings"]
        layers = settings["layers"] if settings["error"] else settings["layers"] or LAYERS_OF_ORDER[settings["order"]]
        return {**settings, "layers": layers}, self._offer["sizes"]

    def keep(self, record, settings, sizes, meshed):
        """Keep what worked with a part, for it and for parts like it; a document that was never saved keeps nothing."""
        if self._document.FileName:
            lifelong.requests.keep("document_info.keep_settings", document=self._document.FileName, part=record["name"],
                                   settings=settings, diagonal=record["descriptors"]["diagonal_mm"],
                                   **rows_to_keep(meshed, sizes))

    def leave(self):
        """Listen no more."""
        lifelong.requests.answered.disconnect(self._on_answered)

    def _on_answered(self, request):
        offer = request.answer
        if request is not self._request or offer is None:
            return
        self._offer, meshed = offer, offer["meshed"]
        if meshed.get("error"):
            made = translate("ThinPart", "error aimed at: {}, elements: {}").format(
                marked(f"{100.0 * meshed['error']:.2g}\u00a0%"), grouped(meshed["elements"]))
        else:
            made = translate("ThinPart", "layers: {}, elements: {}").format(
                f"{meshed['layers'] or LAYERS_OF_ORDER[meshed['order']]:g}", grouped(meshed["elements"]))
        if offer["is_own"]:
            self.found.emit(translate("ThinPart", "Settings that worked for this part: {}").format(made))
        else:
            self.found.emit(translate("ThinPart", "Settings that worked for {} ({} alike): {}").format(
                offer["label"], percent(offer["alike"] / 100.0), made))
