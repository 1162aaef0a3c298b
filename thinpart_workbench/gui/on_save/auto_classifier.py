# SPDX-License-Identifier: LGPL-2.1-or-later
"""Classifies documents in the background whenever they are saved."""

import os

import FreeCAD as App

from ...core.hook import Hook
from ...freecad_adapter.guard import guarded_methods, report_fault
from ...freecad_adapter.preferences import GROUP, preference, preference_list, preferred_analysis
from ...storage.info.info_location import info_location
from ..application import lifelong
from ..application.length_unit import length_unit
from ..application.qt import QtCore, call_later, translate
from ..application.sentences import translated
from ..document.active_task import open_session
from ..processes.request_queue import DOCUMENT_KNOWN, RequestQueue
from ..widgets.elided_button import StatusBarButton
from .verdict_changes_text import headline, reasons, warnings

PREFERENCE = "AutomaticClassification"

_MAX_CHARACTERS = 50

_LOOKUP_DELAY = 200
"""Milliseconds for which a document has to be active before its info file is read."""


@guarded_methods("onChange")
class AutoClassifier(QtCore.QObject):
    """Classifies saved documents one after the other, and shows the verdict of the active one.

    Parameters
    ----------
    observer : DocumentObserver
    measurement_signals : MeasurementSignals
        Emitted by the panels.

    Attributes
    ----------
    clicked : Hook
        Called when the verdict in the status bar is clicked.

    Notes
    -----
    The document itself is never touched: a process reads the saved file. A panel that measures the same document
    takes precedence. As long as it measures the document as it was saved, nothing is measured here: the panel
    writes the info file and announces the verdict.
    """

    def __init__(self, observer, measurement_signals):
        super().__init__()
        self._observer, self._measurement_signals = observer, measurement_signals
        self._states = {}  # text and reason of the status button, by document name
        self._requests = {}  # what is asked for, by document name
        self._delegated = set()  # names of documents that the panel measures
        self._asked_known = {}  # name of the document, by the request what libraries have of it
        self._known = set()  # what was said of that: (path of the document, sentence)
        self._told = set()  # paths of documents of which was said that an earlier version has measured them
        self._group = App.ParamGet(GROUP)  # it drops its observers once Python no longer references it
        # One at a time: many documents may be saved at once, and each may use up to the memory limit.
        self._queue = RequestQueue("on-save", parent=self)
        self._queue.answered.connect(self._on_answer)
        self.clicked = Hook(report_fault)
        self._button = StatusBarButton("ThinPart_StatusVerdict", _MAX_CHARACTERS, self.clicked)
        self._lookup_timer = QtCore.QTimer(self, singleShot=True, interval=_LOOKUP_DELAY)
        self._lookup_timer.timeout.connect(self._look_up)
        self._refresh_timer = QtCore.QTimer(self, singleShot=True, interval=0)
        self._refresh_timer.timeout.connect(self._refresh)

    @property
    def is_on(self):
        """Whether the preference is switched on."""
        return preference(PREFERENCE)

    @property
    def is_busy(self):
        """Whether a document is being classified or queued."""
        return self._queue.is_busy

    def begin(self):
        """Start observing documents, panels and the preference; called once, when FreeCAD starts."""
        self._observer.saved.add(self._on_saved)
        self._observer.closed.add(self._on_closed)
        self._observer.activated.add(self._refresh_timer.start)
        self._measurement_signals.begun.connect(self._on_panel_begun)
        self._measurement_signals.info_file_abandoned.connect(self._on_panel_abandoned)
        self._measurement_signals.written.connect(self._on_panel_written)
        self._measurement_signals.not_written.connect(self._on_panel_failed)
        lifelong.requests.answered.connect(self._on_known)
        self._group.Attach(self)
        self._refresh_timer.start()

    def onChange(self, _group, name):
        """Called by FreeCAD when a preference has changed."""
        if name == PREFERENCE:
            self._refresh_timer.start()

    def end(self):
        """Cancel all jobs and forget all verdicts."""
        for name in list(self._requests):
            self._cancel(name)
        self._delegated.clear()
        self._states.clear()
        self._refresh_timer.start()

    def _on_panel_begun(self, name):
        """Cancel the own job: the Classify panel measures this document now."""
        if self._cancel(name):
            self._delegated.add(name)

    def _on_panel_abandoned(self, name):
        """Classify the document here: the panel was closed or cancelled before it wrote the info file."""
        if name in self._delegated:
            self._delegated.discard(name)
            # Later, because FreeCAD may be closing the document, which closes the panel too.
            call_later(self, lambda: self._classify(name))

    def _on_panel_written(self, name, before, now):
        """Show the verdicts of an info file that the panel has written."""
        self._delegated.discard(name)
        if self.is_on:
            self._show_verdicts(name, before, now)
            if not preference("KnownParts"):  # else the panel says it
                self._ask_for_known(name)

    def _on_panel_failed(self, name, sentence):
        """Show that the panel could not write the info file; the panel has reported it."""
        if name in self._delegated:
            self._delegated.discard(name)
            self._set_state(name, translate("ThinPart", "failed"), sentence)

    def _on_saved(self, name):
        if self.is_on:
            # Saving has finished once the event loop runs again.
            call_later(self, lambda: self._classify(name))

    def _on_closed(self, name):
        self._cancel(name)
        self._delegated.discard(name)
        self._states.pop(name, None)
        self._refresh_timer.start()

    def _classify(self, name):
        document = App.listDocuments().get(name)
        if not self.is_on or document is None:
            return
        self._cancel(name)  # it reads the previous version of the file
        session = open_session()
        if (session is not None and session.document_name == name and session.is_up_to_date
                and not self._observer.differs_from_file(document)):
            self._delegated.add(name)
            session.write_info_file()
        else:
            self._enqueue(name, measure=True)
        self._set_state(name, translate("ThinPart", "measuring\u2026"))

    def _look_up(self):
        """Read the active document's verdict from its info file, where none is known yet."""
        document = App.ActiveDocument
        if self.is_on and document is not None and document.FileName and (
                document.Name not in (*self._states, *self._delegated, *self._requests)):
            self._enqueue(document.Name, measure=False)

    def _enqueue(self, name, measure):
        document = App.getDocument(name)
        if document.FileName:
            self._requests[name] = self._queue.ask(
                "saved_documents.classify_saved", document=document.FileName,
                settings=preferred_analysis().content(), profile=preference("Profile"),
                seconds=preference("Seconds"), megabytes=preference("MemoryMegabytes"), measure=measure)

    def _cancel(self, name):
        """Cancel the job of a document and return whether it was going to be measured."""
        request = self._requests.pop(name, None)
        if request is None:
            return False
        self._queue.cancel(request)
        return request.arguments["measure"]

    def _on_answer(self, request):
        name = next(name for name, asked in self._requests.items() if asked is request)
        del self._requests[name]
        answer = request.answer or {"failures": [request.sentence]}
        failures = [translated(failure) for failure in answer["failures"]]
        if not request.arguments["measure"]:
            if answer.get("current"):
                self._set_state(name, headline(answer["verdicts"]),
                                reasons(answer["verdicts"], length_unit(App.getDocument(name))))
            else:
                if answer.get("older"):
                    failures.append(self._tell_older(App.getDocument(name)))
                self._set_state(name, translate("ThinPart", "not classified"), "\n".join(failures))
            return
        if answer.get("verdicts"):
            before = answer["verdicts"] if answer["current"] else answer["before"]
            self._show_verdicts(name, before, answer["verdicts"])
            self._ask_for_known(name)
        elif answer.get("no_part"):
            self._set_state(name, "\u2013", translated(answer["no_part"]))
            return
        else:
            self._set_state(name, translate("ThinPart", "failed"), failures[0])
        if failures:
            lifelong.notifications.show_failure(_failure_text(_display_name(name), failures), App.getDocument(name).Label)

    def _tell_older(self, document):
        """Warn, once for each document, that its results of an earlier version are not enough to judge by: the sentence."""
        sentence = translate("ThinPart", "{}: an earlier version of ThinPart has measured this document, but not all that "
                             "decides today: classify it again.").format(_display_name(document.Name))
        if document.FileName not in self._told:
            self._told.add(document.FileName)
            lifelong.notifications.warn(sentence, document.Label)
        return sentence

    def _show_verdicts(self, name, before, now):
        self._set_state(name, headline(now), reasons(now, length_unit(App.getDocument(name))))
        lifelong.notifications.show_message(f"ThinPart: {_display_name(name)}: {headline(now)}")
        for sentence in warnings(_display_name(name), before, now, preference("WarnOfCategory"),
                                 preference("WarnWallUnder"), length_unit(App.getDocument(name))):
            lifelong.notifications.warn(sentence, App.getDocument(name).Label)

    def _ask_for_known(self, name):
        """Ask what the libraries have of a document, whose info file is written."""
        if preference("KnownPartsOnSave") and preference_list("Libraries"):
            info_file = os.fspath(info_location(App.getDocument(name).FileName, preference("InfoFolder")))
            self._asked_known[lifelong.requests.ask(DOCUMENT_KNOWN, info_file=info_file)] = name

    def _on_known(self, request):
        """Say what the libraries have of a document, and has not been said of it."""
        name = self._asked_known.pop(request, None)
        document = App.listDocuments().get(name)
        for sentence in request.answer or () if document is not None else ():
            if (document.FileName, sentence) not in self._known:
                self._known.add((document.FileName, sentence))
                lifelong.notifications.warn(
                    f"{_display_name(name)}: {translated(sentence, length_unit(document))}", document.Label)

    def _set_state(self, name, text, reason=""):
        self._states[name] = text, reason
        self._refresh()

    def _refresh(self):
        """Update the status button."""
        if not self.is_on:
            if self._states or self.is_busy:
                self.end()
            self._button.hide()
            return
        active = App.ActiveDocument
        state = self._states.get(active.Name) if active is not None else None
        if state is None:
            self._lookup_timer.start()
        text, reason = state or ("\u2013", "")
        self._button.show(translate("ThinPart", "ThinPart: {}").format(text), "\n".join(filter(None, [
            reason, translate("ThinPart", "The active document as it was saved. Click to classify it "
                              "in the panel.")])))


def _display_name(name):
    document = App.getDocument(name)
    return os.path.basename(document.FileName) or document.Label


def _failure_text(document, failures):
    first = failures[0] if failures[0].startswith(document) else f"{document}: {failures[0]}"
    if len(failures) == 1:
        return first
    return translate("ThinPart", "{} There are {} more failures.").format(first, len(failures) - 1)
