"""A JSON-lines client that reports the end of its process as a sentence."""

import FreeCAD as App

from ...core.errors import NO_MEMORY, ThinPartError
from ...system.exit_cause import ExitCause
from ..application import lifelong
from ..application.qt import Signal, translate
from ..application.sentences import translated
from .json_client import JsonClient


class Conversation(JsonClient):
    """A `JsonClient` for the requests of panels and dialogs.

    Signals
    -------
    finished(str)
        The process has ended by itself, or could not be started: empty on success, else one sentence.
    """

    finished = Signal(str)

    def __init__(self, module, parent=None):
        super().__init__(module, parent)
        self.ended.connect(self._on_ended)
        self.failed_to_start.connect(lambda: self.finished.emit(
            translate("ThinPart", "The worker process could not be started.")))

    def ensure_started(self):
        """Start the process if it is not running; returns an error sentence, empty on success."""
        if not self.is_running:
            try:
                self.start()
            except ThinPartError as error:
                return translated(error)
        return ""

    def _on_ended(self, end):
        self.finished.emit(self._sentence(end))

    def _sentence(self, end):
        cause = end.cause()
        if self.failure is None and cause is ExitCause.WELL:
            return ""
        if self.failure is not None:
            App.Console.PrintLog(end.text + "\n")  # the traceback of an unexpected exception
            return translated(self.failure["message"])
        lifelong.notifications.report_output(end.text)
        if cause is ExitCause.OUT_OF_MEMORY:
            return translated(NO_MEMORY)
        return translate(
            "ThinPart", "The worker process ended unexpectedly; the report view shows its last output.")
