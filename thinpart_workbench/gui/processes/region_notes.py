# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the user says of wall regions, and whatever else is kept by part, as info files have it."""

from ..application.qt import QtCore, Signal


class KeptWithParts(QtCore.QObject):
    """Reads and keeps something of the parts of documents through a RequestQueue.

    Parameters
    ----------
    requests : RequestQueue
    reading, keeping : str
        Functions of `api`, which return what is kept: dict of list by part name.

    Signals
    -------
    answered(str, str)
        Path of the document of which something was read or kept, and on failure a sentence, else empty.
    """

    answered = Signal(str, str)

    def __init__(self, requests, reading, keeping, parent=None):
        super().__init__(parent)
        self._known, self._reading, self._keeping = {}, reading, keeping
        self._requests = requests
        requests.answered.connect(self._on_answered)

    def known(self, document):
        """What was read last: dict of list by part name; None where there is no info file, or nothing was read yet."""
        return self._known.get(document)

    def read(self, document):
        """Read what is kept with a document: its path."""
        self._requests.ask(self._reading, document=document)

    def ask_to_keep(self, **arguments):
        """Have something kept: the arguments of the function, ``document`` among them."""
        self._requests.keep(self._keeping, **arguments)

    def _on_answered(self, request):
        if request.function in (self._reading, self._keeping):
            document = request.arguments["document"]
            if not request.sentence:
                self._known[document] = request.answer
            self.answered.emit(document, request.sentence)


class RegionNotes(KeptWithParts):
    """Reads and keeps notes on wall regions."""

    def __init__(self, requests, parent=None):
        super().__init__(requests, "document_info.notes", "document_info.keep_notes", parent)

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
        self.ask_to_keep(document=document, part=part, regions=places, **said)
