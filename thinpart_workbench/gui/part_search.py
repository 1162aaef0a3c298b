"""The search behind the panel: what is asked now, and what came of it."""

from types import SimpleNamespace

from .json_process import JsonProcess, started
from .qt import QtCore, Signal

_PAUSE = 40
"""Milliseconds in which several changes of a question become one."""


class PartSearch(QtCore.QObject):
    """Asks the process that reads libraries. Answers to questions that are outdated are thrown away.

    Signals
    -------
    found(object)
        The process's ``found``; its ``rows`` with the fields of StoredPart as attributes, None for parts
        that went; and ``same``, whether only the libraries have changed since the last one.
    rows_came(int, object)
        Place of the first, and rows.
    libraries_changed(object)
        list of dict: ``root``, ``parts``, ``problems``, ``busy``.
    progressed(object)
        dict: ``root``, ``done``, ``total``.
    record_came(object), kept(object)
        As the process tells them.
    failed(str)
        The process is gone.
    """

    found = Signal(object)
    rows_came = Signal(int, object)
    libraries_changed = Signal(object)
    progressed = Signal(object)
    record_came = Signal(object)
    kept = Signal(object)
    failed = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._roots, self._serial, self._answered = [], 0, 0
        self._refreshing, self._is_new = False, True
        self._asked = {"query": {}, "sort": "file", "descending": False, "current": None, "like": None}
        self._process = JsonProcess("library_worker", self)
        self._process.told.connect(self._take)
        self._process.ended.connect(self._lost)
        self._pause = QtCore.QTimer(self, singleShot=True, interval=_PAUSE)
        self._pause.timeout.connect(self._send)

    @property
    def is_open(self):
        """Whether the process is there."""
        return self._process.is_running

    @property
    def is_refreshing(self):
        """Whether libraries are being read."""
        return self._refreshing

    @property
    def is_waiting(self):
        """Whether a question was asked that is not answered yet."""
        return self._pause.isActive() or self._answered != self._serial

    @property
    def like(self):
        """What parts are compared with, None where they are not."""
        return self._asked["like"]

    def open(self, roots):
        """Search these libraries from now on."""
        self._roots = list(roots)
        sentence = started(self._process)
        if sentence:
            self.failed.emit(sentence)
            return
        self._refreshing = True
        self._process.say(ask="open", roots=self._roots)

    def refresh(self):
        """Bring all libraries up to date."""
        if self._process.is_running:
            self._refreshing = True
            self._process.say(ask="refresh")
        else:
            self.open(self._roots)

    def stop_refreshing(self):
        """Leave off refreshing; what was read is kept."""
        self._process.say(ask="stop")

    def ask(self, **changes):
        """Change some of ``query``, ``sort``, ``descending``, ``current`` and ``like``, and ask."""
        if any(self._asked[key] != value for key, value in changes.items()):
            self._asked.update(changes)
            self._is_new = True
            self._pause.start()

    def stay_with(self, part):
        """Have the place of this part told with what is found."""
        self._asked["current"] = part and [part.root, part.info_file, part.name]

    def want_rows(self, start, end):
        """Have some rows of what was found told."""
        if not self.is_waiting:
            self._process.say(ask="rows", serial=self._serial, start=start, end=end)

    def want_record(self, part):
        """Have a part's record told."""
        self._process.say(ask="record", info_file=part.info_file, name=part.name)

    def keep(self, part, changes):
        """Set what is kept with a part: dict of some of ``notes``, ``mesh`` and ``link``."""
        self._process.say(ask="keep", root=part.root, info_file=part.info_file, name=part.name,
                          **{key: changes.get(key) for key in ("notes", "mesh", "link")})

    def end(self):
        """End the process."""
        self._pause.stop()
        self._answered, self._refreshing = self._serial, False
        self._process.end()

    def _send(self):
        self._serial += 1
        self._process.say(ask="find", serial=self._serial, **self._asked)

    def _take(self, content):
        for name, each in content.items():
            getattr(self, f"_take_{name}")(each)

    def _take_found(self, found):
        if found["serial"] == self._serial:
            self._answered = self._serial
            same, self._is_new = not self._is_new, False
            self.found.emit({**found, "same": same, "rows": _rows(found["rows"])})

    def _take_rows(self, rows):
        if rows["serial"] == self._serial:
            self.rows_came.emit(rows["start"], _rows(rows["rows"]))

    def _take_libraries(self, libraries):
        self._refreshing = any(each["busy"] for each in libraries)
        self.libraries_changed.emit(libraries)
        # Other parts may be found by the same question, and rows have other places.
        self._pause.start()

    def _take_progress(self, progress):
        self.progressed.emit(progress)

    def _take_record(self, record):
        self.record_came.emit(record)

    def _take_kept(self, kept):
        # What is kept is read into the index at once.
        self._refreshing = self._refreshing or not kept["sentence"]
        self.kept.emit(kept)

    def _lost(self, sentence):
        self._answered, self._refreshing = self._serial, False
        self.failed.emit(sentence)


def _rows(rows):
    """Rows with the fields of a StoredPart as attributes; None where a part has gone."""
    return [row and SimpleNamespace(**row) for row in rows]
