# SPDX-License-Identifier: LGPL-2.1-or-later
"""A queue of requests, which a process answers one after the other."""

from collections import deque

import FreeCAD as App

from ...freecad_adapter.preferences import preference, preference_list, preferred_person
from ...storage.info.info_location import not_answered
from ..application.qt import QtCore, QtWidgets, Signal, call_later, translate
from ..application.sentences import translated
from .conversation import PATIENCE, Conversation

LABEL = "document_info.keep_label"
"""Request to keep a label: its answer is the list of all labels of the part."""

KNOWN = "window.known_parts.part_in_libraries"
"""Request whether libraries have a part: its answer is as of that function."""

DOCUMENT_KNOWN = "window.known_parts.document_in_libraries"
"""Request what libraries have of the parts of a document: its answer is a list of sentences."""

HANGING = 60.0
"""Seconds without a sign of life after which a process counts as hanging, as on a network share that is gone. Requests about
other folders wait so long behind one about such a share."""

_QUIT_SECONDS = 10.0
"""Seconds that FreeCAD, when it quits, waits until everything is kept."""


class Request:
    """A request and its answer.

    Attributes
    ----------
    function : str
        Module and name of a function of `api`.
    arguments : dict
    is_kept : bool
        Whether it is done even if FreeCAD quits meanwhile.
    answer : object
        What the function has returned: JSON values.
    sentence : str
        Why there is no answer; else empty.
    """

    def __init__(self, function, arguments, is_kept):
        self.function, self.arguments, self.is_kept = function, arguments, is_kept
        self.answer, self.sentence = None, ""


class RequestQueue(QtCore.QObject):
    """Has functions of `api` called in another process, which is started when needed and ends when nothing is left to do.

    Parameters
    ----------
    name : str
        Stands in the command line of the process.
    patience : float, optional
        Such as `HANGING`; by default there is no limit.
    parent : QObject, optional

    Signals
    -------
    answered(object)
        Request: it is answered, or cannot be. Panels that have closed meanwhile are not told; it is done nevertheless.
    progressed(object, object)
        Request, and the arguments with which its function has reported progress.
    """

    answered = Signal(object)
    progressed = Signal(object, object)

    def __init__(self, name, patience=0.0, parent=None):
        super().__init__(parent)
        self._waiting = deque()  # the first one is being done
        self._process = Conversation("request_worker", self, arguments=[name])
        self._process.received.connect(self._on_received)
        self._process.finished.connect(self._on_finished)
        self._patience = patience
        self._silence = QtCore.QTimer(self, singleShot=True, interval=int(patience * 1000))
        self._silence.timeout.connect(self._on_silence)
        QtWidgets.QApplication.instance().aboutToQuit.connect(self._finish)

    @property
    def is_busy(self):
        """Whether requests are still to be answered."""
        return bool(self._waiting)

    def ask(self, function, **arguments):
        """Ask for something, as a Request; when FreeCAD quits, it is not asked any more.

        Parameters
        ----------
        function : str
            Module and name of a function of `api`.
        arguments
            JSON values. For its parameters ``folder``, ``person`` and ``roots`` the function gets the preferences.
        """
        return self._add(Request(function, arguments, False))

    def keep(self, function, **arguments):
        """Have something written, as `ask`; it is written even if FreeCAD quits."""
        return self._add(Request(function, arguments, True))

    def cancel(self, request):
        """Drop a request; `answered` is not emitted. If it is being done, it is stopped or, where it cannot be, finished."""
        if request in self._waiting:
            is_running = request is self._waiting[0]
            self._waiting.remove(request)
            if is_running:
                self._process.detach()
                self._do_next()

    def _add(self, request):
        self._waiting.append(request)
        if len(self._waiting) == 1:
            self._do_next()
        return request

    def _do_next(self):
        self._silence.stop()
        if not self._waiting:
            self._process.detach()  # it ends by itself
            return
        sentence = self._process.ensure_started()
        if sentence:
            call_later(self, lambda: self._on_finished(sentence))
            return
        self._send(self._waiting[0])
        if self._patience:
            self._silence.start()

    def _send(self, request):
        self._process.send(ask=request.function, arguments=request.arguments, preferred={
            "folder": preference("InfoFolder"), "person": preferred_person(), "roots": preference_list("Libraries")})

    def _on_received(self, content):
        if "progress" in content:
            if self._patience:
                self._silence.start()
            self.progressed.emit(self._waiting[0], content["progress"])
        else:
            self._end(content.get("answer"), translated(content.get("refused", "")))

    def _on_finished(self, sentence):
        if self._waiting:
            self._end(None, sentence or translate("ThinPart", "The worker process ended unexpectedly."))

    def _on_silence(self):
        self._process.detach(kill=True)
        self._end(None, translated(not_answered(preference("InfoFolder"), self._patience)))

    def _end(self, answer, sentence):
        request = self._waiting.popleft()
        request.answer, request.sentence = answer, sentence
        if sentence and request.is_kept:
            App.Console.PrintWarning(sentence + "\n")  # the panel may be closed
        self._do_next()
        self.answered.emit(request)

    def _finish(self):
        """Have everything written that is to be kept, because FreeCAD quits."""
        kept = [request for request in self._waiting if request.is_kept]
        if self._waiting and not self._waiting[0].is_kept:
            self._process.end_now(PATIENCE)
        for request in kept:
            if request is not self._waiting[0] and not self._process.ensure_started():
                self._send(request)
        self._waiting.clear()
        self._process.end_now(_QUIT_SECONDS)
