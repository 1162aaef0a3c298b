# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user says of wall regions, as info files have it."""

from ..application.qt import QtCore, Signal

_READ, _KEEP = "document_info.notes", "document_info.keep_notes"


class RegionNotes(QtCore.QObject):
    """Reads and keeps notes on wall regions through a RequestQueue.

    Signals
    -------
    answered(str, str)
        Path of the document whose notes were read or kept, and on failure a sentence, else empty.
    """

    answered = Signal(str, str)

    def __init__(self, requests, parent=None):
        super().__init__(parent)
        self._known = {}
        self._requests = requests
        requests.answered.connect(self._on_answered)

    def known(self, document):
        """What was read last: dict of list by part name; None where there is no info file, or nothing was read yet."""
        return self._known.get(document)

    def read(self, document):
        """Read what is kept with a document: its path."""
        self._requests.ask(_READ, document=document)

    def keep(self, document, part, regions, **said):
        """Keep what the user says of regions.

        Parameters
        ----------
        document : str
            Path of the document.
        part : str
            Name of the part.
        regions : list of dict
            As in a part record.
        said
            ``excluded`` or ``mesh_size_mm``, as of `note_regions`.
        """
        places = [{key: region[key] for key in ("place", "faces", "length_mm", "median")} for region in regions]
        self._requests.keep(_KEEP, document=document, part=part, regions=places, **said)

    def _on_answered(self, request):
        if request.function in (_READ, _KEEP):
            document = request.arguments["document"]
            if not request.sentence:
                self._known[document] = request.answer
            self.answered.emit(document, request.sentence)
