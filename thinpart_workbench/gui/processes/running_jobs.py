"""The button in the status bar that names what runs in the background, and leads to its window and page."""

import FreeCADGui as Gui

from ..application.qt import QtWidgets, translate
from ..widgets.elided_button import ElidedButton

_MAX_CHARACTERS = 40


class RunningJobs:
    """Jobs whose windows may be closed or covered; the button shows the last that was begun.

    Notes
    -----
    The button is created when the first job begins.
    """

    def __init__(self):
        self._jobs = {}  # name -> (text, window, function that shows its page)
        self._button = None

    def show(self, name, text, window, show_page=lambda: None):
        """Show a job, or how far it is.

        Parameters
        ----------
        name : str
            Of the kind of job, of which there is one at a time.
        text : str
        window : QWidget
            Shown when the button is clicked.
        show_page : callable, optional
            Shows the page of the window that the job belongs to.
        """
        self._jobs[name] = text, window, show_page
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
            self._button.clicked.connect(lambda *_: self._on_clicked())
            Gui.getMainWindow().statusBar().addPermanentWidget(self._button)
        texts = [text for text, _, _ in self._jobs.values()]
        last = texts[-1]
        self._button.setText(last if len(texts) == 1 else translate("ThinPart", "{} jobs: {}").format(len(texts), last))
        self._button.setToolTip("\n".join([*texts, translate("ThinPart", "Click to show its window.")]))
        self._button.updateGeometry()
        self._button.show()

    def _on_clicked(self):
        if len(self._jobs) == 1:
            self._show_window(*self._jobs)
        elif self._jobs:
            menu = QtWidgets.QMenu(self._button)
            menu.setObjectName("ThinPart_RunningJobsMenu")
            for name, (text, _, _) in self._jobs.items():
                action = menu.addAction(text)
                action.setObjectName(f"ThinPart_RunningJob_{name}")
                action.triggered.connect(lambda *_, name=name: self._show_window(name))
            menu.aboutToHide.connect(menu.deleteLater)
            menu.popup(self._button.mapToGlobal(self._button.rect().topLeft()))

    def _show_window(self, name):
        if name not in self._jobs:
            return  # it has ended while the menu was open
        _, window, show_page = self._jobs[name]
        show_page()
        window.show()
        window.raise_()
        window.activateWindow()
