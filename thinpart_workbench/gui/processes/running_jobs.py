"""The button in the status bar that names what runs in the background, and leads to its window."""

import FreeCADGui as Gui

from ..application.qt import translate
from ..widgets.elided_button import ElidedButton

_MAX_CHARACTERS = 40


class RunningJobs:
    """Jobs whose windows may be closed or covered; the button shows the last that was begun.

    Notes
    -----
    The button is created when the first job begins.
    """

    def __init__(self):
        self._jobs = {}  # name -> (text, window)
        self._button = None

    def show(self, name, text, window):
        """Show a job, or how far it is.

        Parameters
        ----------
        name : str
            Of the kind of job, of which there is one at a time.
        text : str
        window : QWidget
            Shown when the button is clicked.
        """
        self._jobs[name] = text, window
        self._show()

    def end(self, name):
        """Hide a job that has ended."""
        self._jobs.pop(name, None)
        self._show()

    def _show(self):
        if not self._jobs:
            if self._button is not None:
                self._button.hide()
            return
        if self._button is None:
            self._button = ElidedButton("ThinPart_RunningJobs", _MAX_CHARACTERS)
            self._button.clicked.connect(lambda *_: self._show_window())
            Gui.getMainWindow().statusBar().addPermanentWidget(self._button)
        texts = [text for text, _ in self._jobs.values()]
        last = texts[-1]
        self._button.setText(last if len(texts) == 1 else translate("ThinPart", "{} jobs: {}").format(len(texts), last))
        self._button.setToolTip("\n".join([*texts, translate("ThinPart", "Click to show its window.")]))
        self._button.updateGeometry()
        self._button.show()

    def _show_window(self):
        if self._jobs:
            window = list(self._jobs.values())[-1][1]
            window.show()
            window.raise_()
            window.activateWindow()
