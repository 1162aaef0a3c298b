"""Documents that are classified in the background whenever they are saved."""

import os
from dataclasses import dataclass

import FreeCAD as App

from ..freecad_adapter.edge import guarded_methods
from ..freecad_adapter.settings import GROUP, preference, preferred_analysis
from .asked_process import AskedProcess
from .document_observer import OBSERVER
from .document_verdict_text import headline, reasons, warnings
from .length_unit import length_unit
from .notices import NOTICES
from .qt import QtCore, soon, translate
from .sentences import translated
from .task_session import open_session
from .verdict_label import VerdictLabel

PREFERENCE = "AutomaticClassification"

_LOOK_AFTER = 200
"""Milliseconds for which a document has to be active before its info file is looked up."""


@dataclass
class _State:
    """What the label says about a document."""

    words: str
    reason: str = ""


@guarded_methods("onChange")
class AutomaticClassification(QtCore.QObject):
    """Classifies one saved document after the other, and knows the verdicts.

    Notes
    -----
    The document itself is never touched: a process reads the file that was saved. The panel of
    the same document goes first. As long as what it measures is the document as it was saved, nothing
    is measured here: the panel writes the info file, and tells the verdict.
    """

    def __init__(self):
        super().__init__()
        self._states = {}
        self._waiting = {}  # whether to measure, by document
        self._left = set()  # documents that the panel is at
        self._running, self._measures = None, False
        self._group = App.ParamGet(GROUP)  # lets go of its observers when Python does not hold it
        self._process = AskedProcess("saved_document_worker", self)
        self._process.answered.connect(self._take)
        self._label = VerdictLabel()
        self._look = QtCore.QTimer(self, singleShot=True, interval=_LOOK_AFTER)
        self._look.timeout.connect(self._look_up)
        self._shown = QtCore.QTimer(self, singleShot=True, interval=0)
        self._shown.timeout.connect(self._show)

    @property
    def is_on(self):
        """Whether the user wants it."""
        return preference(PREFERENCE)

    @property
    def is_busy(self):
        """Whether a document is being classified or waits for it."""
        return self._process.is_waiting or bool(self._waiting)

    def begin(self):
        """Follow the documents and the preference; called once, when FreeCAD starts."""
        OBSERVER.on_save(self._saved)
        OBSERVER.on_close(self._closed)
        OBSERVER.on_activate(self._shown.start)
        self._group.Attach(self)
        self._shown.start()

    def onChange(self, _group, name):
        """FreeCAD calls it when a preference was changed."""
        if name == PREFERENCE:
            self._shown.start()

    def leave_to_panel(self, name):
        """The Classify panel measures this document now."""
        if self._drop(name):
            self._left.add(name)

    def take_over(self, name):
        """The panel is gone, or was cancelled: what it has not done is done here."""
        if name in self._left:
            self._left.discard(name)
            # Not while FreeCAD closes the document, which ends the panel too.
            soon(self, lambda: self._classify(name))

    def take_from_panel(self, name, before, now):
        """The panel has written the info file."""
        self._left.discard(name)
        if self.is_on:
            self._show_verdicts(name, before, now)

    def take_failure(self, name, sentence):
        """The panel could not write the info file, and has said so."""
        if name in self._left:
            self._left.discard(name)
            self._set(name, translate("ThinPart", "failed"), sentence)

    def end(self):
        """Stop what is going on and forget what is known."""
        self._waiting.clear()
        self._drop(self._running)
        self._left.clear()
        self._states.clear()
        self._shown.start()

    def _saved(self, name):
        if self.is_on:
            # Saving is over when the window has its turn again.
            soon(self, lambda: self._classify(name))

    def _closed(self, name):
        self._drop(name)
        self._left.discard(name)
        self._states.pop(name, None)
        self._shown.start()

    def _classify(self, name):
        document = App.listDocuments().get(name)
        if not self.is_on or document is None:
            return
        self._drop(name)  # it was at work on the file as it was before
        session = open_session()
        if (session is not None and session.document_name == name and session.measured.is_up_to_date
                and not OBSERVER.differs_from_file(document)):
            self._left.add(name)
            session.measured.keep()
        else:
            self._wait(name, measure=True)
        self._set(name, translate("ThinPart", "measuring\u2026"))

    def _look_up(self):
        """Take the active document's verdict from its info file, where nothing is known yet."""
        document = App.ActiveDocument
        if self.is_on and document is not None and document.FileName and (
                document.Name not in self._states and document.Name not in self._left):
            self._wait(document.Name, measure=False)

    def _wait(self, name, measure):
        self._waiting[name] = measure
        self._next()

    def _next(self):
        # One at a time: many documents may be saved at once, and each may take all the memory it is allowed.
        while self._waiting and not self._process.is_waiting:
            name = next(iter(self._waiting))
            measure = self._waiting.pop(name)
            document = App.listDocuments().get(name)
            if document is not None and document.FileName:
                self._running, self._measures = name, measure
                self._process.ask(
                    document=document.FileName, folder=preference("InfoFolder"),
                    settings=preferred_analysis().content(), profile=preference("Profile"),
                    seconds=preference("Seconds"), megabytes=preference("MemoryMegabytes"),
                    measure=measure)

    def _drop(self, name):
        """Stop whatever is done about a document; whether it was to be measured."""
        measure = self._waiting.pop(name, False)
        if name is not None and name == self._running:
            measure = measure or self._measures
            self._running = None
            self._process.end()
            self._next()
        return measure

    def _take(self, answer):
        name, self._running = self._running, None
        try:
            self._take_answer(name, answer)
        finally:
            self._next()

    def _take_answer(self, name, answer):
        failures = [translated(each) for each in (
            [answer["failure"]] if "failure" in answer else answer["failures"])]
        if not self._measures:
            if answer.get("current"):
                self._set(name, headline(answer["verdicts"]), reasons(answer["verdicts"]))
            else:
                self._set(name, translate("ThinPart", "not classified"), "\n".join(failures))
            return
        if answer.get("verdicts"):
            before = answer["verdicts"] if answer["current"] else answer["before"]
            self._show_verdicts(name, before, answer["verdicts"])
        elif answer.get("no_part"):
            self._set(name, "\u2013", translated(answer["no_part"]))
            return
        else:
            self._set(name, translate("ThinPart", "failed"), failures[0])
        if failures:
            NOTICES.tell_failure(_sentence(_called(name), failures), App.getDocument(name).Label)

    def _show_verdicts(self, name, before, now):
        self._set(name, headline(now), reasons(now))
        NOTICES.tell(f"ThinPart: {_called(name)}: {headline(now)}")
        for sentence in warnings(_called(name), before, now, preference("WarnOfCategory"),
                                 preference("WarnWallUnder"), length_unit(App.getDocument(name))):
            NOTICES.warn(sentence, App.getDocument(name).Label)

    def _set(self, name, words, reason=""):
        self._states[name] = _State(words, reason)
        self._show()

    def _show(self):
        """Bring the label up to date."""
        if not self.is_on:
            if self._states or self.is_busy:
                self.end()
            self._label.hide()
            return
        active = App.ActiveDocument
        state = self._states.get(active.Name) if active is not None else None
        if state is None:
            self._label.show("\u2013")
            self._look.start()
        else:
            self._label.show(state.words, state.reason)


def _called(name):
    document = App.getDocument(name)
    return os.path.basename(document.FileName) or document.Label


def _sentence(document, failures):
    first = failures[0] if failures[0].startswith(document) else f"{document}: {failures[0]}"
    if len(failures) == 1:
        return first
    return translate("ThinPart", "{} There are {} more failures.").format(first, len(failures) - 1)


AUTOMATIC = AutomaticClassification()
"""The one of this session."""
