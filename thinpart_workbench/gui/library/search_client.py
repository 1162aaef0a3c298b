# SPDX-License-Identifier: LGPL-2.1-or-later
"""Client of the worker process that searches the libraries."""

from types import SimpleNamespace

from ..application.qt import QtCore, Signal, translate
from ..processes.conversation import Conversation

_SEND_DELAY = 40
"""Milliseconds within which several changes of the query are sent as one request."""


class SearchClient(QtCore.QObject):
    """Sends requests to the worker process that reads libraries, and drops responses to outdated requests.

    Signals
    -------
    found(object)
        The ``found`` response; its ``rows`` have the fields of StoredPart as attributes and are None for
        deleted parts; ``same`` says whether only the libraries have changed since the last response.
    rows_received(int, object)
        Number of the first row, and the rows.
    libraries_changed(object)
        list of dict: ``root``, ``parts``, ``problems``, ``busy``.
    progressed(object)
        dict: ``root``, ``done``, ``total``.
    record_received(object), annotation_saved(object)
        The ``record`` and ``kept`` responses of the process.
    failed(str)
        The process has failed.
    """

    found = Signal(object)
    rows_received = Signal(int, object)
    libraries_changed = Signal(object)
    progressed = Signal(object)
    record_received = Signal(object)
    annotation_saved = Signal(object)
    failed = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._roots, self._serial, self._answered = [], 0, 0
        self._refreshing, self._is_changed = False, True
        self._query = {"query": {}, "sort": "file", "descending": False, "current": None, "like": None}
        self._process = Conversation("library_worker", self)
        self._process.received.connect(self._on_message)
        self._process.finished.connect(self._on_process_ended)
        self._send_timer = QtCore.QTimer(self, singleShot=True, interval=_SEND_DELAY)
        self._send_timer.timeout.connect(self._send)

    @property
    def is_open(self):
        """Whether the process is running."""
        return self._process.is_running

    @property
    def is_refreshing(self):
        """Whether libraries are being refreshed."""
        return self._refreshing

    @property
    def is_waiting(self):
        """Whether a query is pending."""
        return self._send_timer.isActive() or self._answered != self._serial

    @property
    def like(self):
        """The reference of a similarity search, or None."""
        return self._query["like"]

    def open(self, roots):
        """Open libraries for searching: iterable of folders."""
        self._roots = list(roots)
        sentence = self._process.ensure_started()
        if sentence:
            self.failed.emit(sentence)
            return
        self._refreshing = True
        self._process.send(ask="open", roots=self._roots)

    def refresh(self, roots=None):
        """Refresh libraries: list of folders, all by default."""
        if roots == []:
            return
        if self._process.is_running:
            self._refreshing = True
            self._process.send(ask="refresh", roots=roots)
        else:
            self.open(self._roots)

    def stop_refreshing(self):
        """Stop refreshing; records already read stay in the index."""
        self._process.send(ask="stop")

    def update_query(self, **changes):
        """Change some of ``query``, ``sort``, ``descending``, ``current`` and ``like``, and schedule a search."""
        if any(self._query[key] != value for key, value in changes.items()):
            self._query.update(changes)
            self._is_changed = True
            self._send_timer.start()

    def set_current_part(self, part):
        """Set the part whose row number search results should include."""
        self._query["current"] = part and [part.root, part.info_file, part.name]

    def find_again(self, part):
        """Search again, and have the result include the row number of a part."""
        self.set_current_part(part)
        self._is_changed = True
        self._send_timer.start()

    def request_rows(self, start, end):
        """Request some rows of the search result."""
        if not self.is_waiting:
            self._process.send(ask="rows", serial=self._serial, start=start, end=end)

    def request_record(self, part):
        """Request the record of a part."""
        self._process.send(ask="record", info_file=part.info_file, name=part.name)

    def save_annotation(self, part, changes):
        """Save changed fields of a part's annotation: dict of some of ``notes``, ``mesh`` and ``link``."""
        self._process.send(ask="keep", root=part.root, info_file=part.info_file, name=part.name,
                          **{key: changes.get(key) for key in ("notes", "mesh", "link")})

    def end(self):
        """Detach from the process."""
        self._send_timer.stop()
        self._answered, self._refreshing = self._serial, False
        self._process.detach()

    def _send(self):
        self._serial += 1
        self._process.send(ask="find", serial=self._serial, **self._query)

    def _on_message(self, content):
        answers = {"found": self._on_found, "rows": self._on_rows, "libraries": self._on_libraries, "kept": self._on_kept,
                   "progress": self.progressed.emit, "record": self.record_received.emit}
        for name, response in content.items():
            answers[name](response)

    def _on_found(self, found):
        if found["serial"] == self._serial:
            self._answered = self._serial
            same, self._is_changed = not self._is_changed, False
            self.found.emit({**found, "same": same, "rows": _rows(found["rows"])})

    def _on_rows(self, rows):
        if rows["serial"] == self._serial:
            self.rows_received.emit(rows["start"], _rows(rows["rows"]))

    def _on_libraries(self, libraries):
        self._refreshing = any(library["busy"] for library in libraries)
        self.libraries_changed.emit(libraries)
        # The same query may now find other parts, and rows may have moved.
        self._send_timer.start()

    def _on_kept(self, result):
        # The worker reads a saved annotation into the index at once.
        self._refreshing = self._refreshing or not result["sentence"]
        self.annotation_saved.emit(result)

    def _on_process_ended(self, sentence):
        self._answered, self._refreshing = self._serial, False
        if sentence:
            sentence = translate("ThinPart", "{} Refresh the libraries to go on.").format(sentence)
        self.failed.emit(sentence)


def _rows(rows):
    """Rows with the fields of a StoredPart as attributes; None for deleted parts."""
    return [row and SimpleNamespace(**row) for row in rows]
