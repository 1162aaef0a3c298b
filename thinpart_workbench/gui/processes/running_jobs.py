# SPDX-License-Identifier: LGPL-2.1-or-later
"""The button in the status bar that names what runs in the background, and leads to its window and page."""

from ..application.qt import QtWidgets, translate
from ..widgets.elided_button import StatusBarButton

_MAX_CHARACTERS = 40


class RunningJobs:
    """Jobs whose windows may be closed or covered; the button shows the last that was begun."""

    def __init__(self):
        self._jobs = {}  # name -> (text, window, function that shows its page)
        self._button = StatusBarButton("ThinPart_RunningJobs", _MAX_CHARACTERS, self._on_clicked)

    def show(self, name, text, window, show_page=lambda: None):
        """Show a job, or how far it is, by the name of its kind, of which there is one at a time.

        A click shows the window, and calls `show_page`, which shows the page that the job belongs to.
        """
        self._jobs[name] = text, window, show_page
        self._show()

    def end(self, name):
        """Hide a job that has ended."""
        self._jobs.pop(name, None)
        self._show()

    def _show(self):
        if not self._jobs:
            self._button.hide()
            return
        texts = [text for text, _, _ in self._jobs.values()]
        last = texts[-1]
        self._button.show(last if len(texts) == 1 else translate("ThinPart", "{} jobs: {}").format(len(texts), last),
                          "\n".join([*texts, translate("ThinPart", "Click to show its window.")]))

    def _on_clicked(self):
        if len(self._jobs) == 1:
            self._show_window(*self._jobs)
        elif self._jobs:
            button = self._button.widget
            menu = QtWidgets.QMenu(button)
            menu.setObjectName("ThinPart_RunningJobsMenu")
            for name, (text, _, _) in self._jobs.items():
                action = menu.addAction(text)
                action.setObjectName(f"ThinPart_RunningJob_{name}")
                action.triggered.connect(lambda *_, name=name: self._show_window(name))
            menu.aboutToHide.connect(menu.deleteLater)
            menu.popup(button.mapToGlobal(button.rect().topLeft()))

    def _show_window(self, name):
        if name not in self._jobs:
            return  # it has ended while the menu was open
        _, window, show_page = self._jobs[name]
        show_page()
        window.show()
        window.raise_()
        window.activateWindow()
