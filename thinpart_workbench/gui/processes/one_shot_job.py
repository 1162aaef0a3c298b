"""A child process that receives one job and returns one answer."""

from ..application.qt import QtCore, Signal, translate
from .conversation import Conversation


class OneShotJob(QtCore.QObject):
    """Runs a module of `window_processes` in another process for one job at a time.

    Parameters
    ----------
    module : str
        Such as ``info_file_worker``.

    Signals
    -------
    answered(object)
        The answer, a dict; with ``failure``, a sentence, on failure. Not emitted after `end`.
    """

    answered = Signal(object)

    def __init__(self, module, parent=None):
        super().__init__(parent)
        self._process = Conversation(module, self)
        self._process.received.connect(self._on_answer)
        self._process.finished.connect(lambda sentence: self._on_answer({
            "failure": sentence or translate("ThinPart", "The worker process ended unexpectedly.")}))
        self._is_waiting = False

    @property
    def is_waiting(self):
        """Whether a job was sent and its answer is outstanding."""
        return self._is_waiting

    def ask(self, **job):
        """Start the process and send the job."""
        self._is_waiting = True
        sentence = self._process.ensure_started()
        if sentence:
            self._on_answer({"failure": sentence})
        else:
            self._process.send(**job)

    def end(self):
        """Drop the job and detach the process, without waiting."""
        self._is_waiting = False
        self._process.detach()

    def _on_answer(self, answer):
        if self._is_waiting:
            # The process ends by itself, but the next job may come before it has.
            self.end()
            self.answered.emit(answer)
