"""A process beside FreeCAD that is given one job and gives one answer."""

from ..core.errors import ThinPartError
from .json_process import JsonProcess
from .qt import QtCore, Signal, translate
from .sentences import translated


class AskedProcess(QtCore.QObject):
    """A module of `workflow` that does one job.

    Parameters
    ----------
    module : str
        Such as ``info_file_worker``.

    Signals
    -------
    answered(object)
        dict; ``failure``, a sentence, where there is no answer. Not sent after `end`.
    """

    answered = Signal(object)

    def __init__(self, module, parent=None):
        super().__init__(parent)
        self._process = JsonProcess(module, self)
        self._process.told.connect(self._take)
        self._process.ended.connect(lambda _: self._take(
            {"failure": translate("ThinPart", "The process that does this ended unexpectedly.")}))
        self._is_waiting = False

    @property
    def is_waiting(self):
        """Whether there is no answer yet."""
        return self._is_waiting

    def ask(self, **job):
        """Start the process and hand over the job."""
        self._is_waiting = True
        try:
            self._process.start()
        except ThinPartError as error:
            self._take({"failure": translated(error)})
            return
        self._process.say(**job)

    def end(self):
        """Have the process end; nobody waits for that, nor for an answer."""
        self._is_waiting = False
        self._process.end()

    def _take(self, answer):
        if self._is_waiting:
            # It ends by itself, but may be asked anew before it has.
            self.end()
            self.answered.emit(answer)
