# SPDX-License-Identifier: LGPL-2.1-or-later
"""Client of the process that judges libraries again."""

from ..application.qt import QtCore, Signal
from ..processes.conversation import Conversation

_TYPING_DELAY = 250
"""Milliseconds after the last change before the profile is judged by."""


class JudgingClient(QtCore.QObject):
    """Sends profiles and folders to ``judging_worker``, and drops answers to outdated requests.

    Signals
    -------
    counted(object)
        The ``counted`` answer to the last profile.
    parts_received(object)
        A ``parts`` answer.
    written(object)
        A ``written`` answer.
    failed(str)
        The process could not be started or has failed; one sentence. Empty where it has ended by itself.
    """

    counted = Signal(object)
    parts_received = Signal(object)
    written = Signal(object)
    failed = Signal(str)

    def __init__(self, parent=None):
        super().__init__(parent)
        self._roots, self._profile, self._serial, self._is_complete = [], None, 0, True
        self.is_writing = False
        self._process = Conversation("judging_worker", self)
        self._process.received.connect(self._on_message)
        self._process.finished.connect(self._on_finished)
        self._typing_timer = QtCore.QTimer(self, singleShot=True, interval=_TYPING_DELAY)
        self._typing_timer.timeout.connect(self._send)

    @property
    def is_waiting(self):
        """Whether the counts of the last profile are not complete yet."""
        return self._typing_timer.isActive() or not self._is_complete

    def open(self, roots):
        """Count in other folders, list of str; what was read before is read again."""
        self._roots = list(roots)
        if self._process.is_running:
            self._process.send(ask="open", roots=self._roots)
        self._typing_timer.start()

    def judge(self, content):
        """Count soon what a profile would change, unless another one comes before; None stops counting."""
        self._profile = content
        self._serial += 1  # answers that are on their way are outdated
        if content is None:
            self._typing_timer.stop()
            self._is_complete = True
        else:
            self._typing_timer.start()

    def request_parts(self, before, after):
        """Ask for the parts of a change of the last counts."""
        self._process.send(ask="parts", serial=self._serial, before=before, after=after)

    def write(self):
        """Write the verdicts by the profile that was counted last; the counts are made anew then."""
        self.is_writing, self._is_complete = True, False
        self._process.send(ask="write", profile=self._profile)

    def stop_writing(self):
        """Write no further info file."""
        self._process.send(ask="stop")

    def end(self):
        """End the process; an info file that is being written is finished."""
        self._typing_timer.stop()
        self._is_complete = True
        self._process.detach(kill=not self.is_writing)
        self.is_writing = False

    def _send(self):
        if self._profile is None or not self._roots:
            return
        if not self._process.is_running:
            sentence = self._process.ensure_started()
            if sentence:
                self.failed.emit(sentence)
                return
            self._process.send(ask="open", roots=self._roots)
        self._is_complete = False
        self._process.send(ask="judge", serial=self._serial, profile=self._profile)

    def _on_message(self, content):
        counted, parts, written = (content.get(key) for key in ("counted", "parts", "written"))
        if counted is not None and counted["serial"] == self._serial:
            self._is_complete = counted["read"] == counted["total"]
            self.counted.emit(counted)
        elif parts is not None and parts["serial"] == self._serial:
            self.parts_received.emit(parts)
        elif written is not None:
            self.is_writing = not written["ended"]
            self.written.emit(written)

    def _on_finished(self, sentence):
        self._is_complete, self.is_writing = True, False
        self.failed.emit(sentence)
